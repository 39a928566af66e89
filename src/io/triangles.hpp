#pragma once

#include <cstdint>
#include <vector>

namespace lichtraum {

/// Unfolds strips (mode 5) and fans (mode 6) as glTF 2.0, section 3.7.2.1, says; a list (mode 4) stays, cut to whole
/// triangles.
std::vector<std::uint32_t> to_triangle_list(std::vector<std::uint32_t> indices, int mode);

}  // namespace lichtraum
