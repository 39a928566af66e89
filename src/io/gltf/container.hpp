#pragma once

#include <string_view>

#include "io/gltf/findings.hpp"

namespace lichtraum::gltf {

/// The two parts of a model file; views of its bytes.
struct Container {
  std::string_view json;
  std::string_view binary;  ///< the GLB's BIN chunk; empty when there is none
  bool is_glb = false;
};

/// Takes a .glb apart (glTF 2.0, section 4.4); any other file is JSON as a whole. What the file is counts, not its
/// name. Fails on a container that cannot be read.
Container open_container(std::string_view file, Findings& findings);

}  // namespace lichtraum::gltf
