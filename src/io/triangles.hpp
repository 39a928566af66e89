#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum {

/// Unfolds strips (mode 5) and fans (mode 6) as glTF 2.0, section 3.7.2.1, says; a list (mode 4) stays, cut to whole
/// triangles.
std::vector<std::uint32_t> to_triangle_list(std::vector<std::uint32_t> indices, int mode);

struct TriangleFaults {
  std::size_t out_of_range = 0;
  std::size_t non_finite = 0;
};

/// Leaves out triangles that name a position that is not there or not finite.
TriangleFaults remove_faulty_triangles(MeshGeometry& geometry);

/// What is said of them: "2 triangles left out: they have <what>". `noun`: what one of them is.
std::string left_out_message(std::size_t count, std::string_view what, std::string_view noun = "triangle");

}  // namespace lichtraum
