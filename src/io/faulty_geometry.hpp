#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum {

struct GeometryFaults {
  std::size_t out_of_range = 0;
  std::size_t non_finite = 0;
};

/// Of lists of two indices a line or three a triangle (`corners`), leaves out each line or triangle that names a
/// position that is not there or not finite.
GeometryFaults remove_faulty(std::vector<std::uint32_t>& indices, std::size_t corners,
                             std::vector<Float3> const& positions);

/// What is said of them: "2 triangles left out: they have <what>". `noun`: what one of them is.
std::string left_out_message(std::size_t count, std::string_view what, std::string_view noun = "triangle");

}  // namespace lichtraum
