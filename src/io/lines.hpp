#pragma once

#include <cstdint>
#include <vector>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum {

/// Unfolds loops (mode 2) and strips (mode 3) to pairs as glTF 2.0, section 3.7.2.1, says; a list (mode 1) stays, cut
/// to whole pairs.
std::vector<std::uint32_t> to_line_list(std::vector<std::uint32_t> indices, int mode);

struct LineFaults {
  std::size_t out_of_range = 0;
  std::size_t non_finite = 0;
};

/// Leaves out lines with an end that is not there or not finite.
LineFaults remove_faulty_lines(MeshGeometry& geometry);

}  // namespace lichtraum
