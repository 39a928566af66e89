#pragma once

#include <filesystem>

namespace lichtraum::bench {

/// Writes a .glb of `nodes` nodes, each with a name and a place of its own, that share a mesh of 80 triangles.
void write_node_model(std::filesystem::path const& path, int nodes);

}  // namespace lichtraum::bench
