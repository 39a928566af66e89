#pragma once

#include <string>

#include "bench_rays.hpp"

namespace lichtraum::bench {

/// All triangles of a model, in world space. Throws what the loader throws.
TriangleMesh read_mesh(std::string const& path);

}  // namespace lichtraum::bench
