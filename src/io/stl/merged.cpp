#include <meshoptimizer.h>

#include "io/stl/facets.hpp"

namespace lichtraum::stl {

std::shared_ptr<MeshGeometry const> merged(std::vector<Float3> corners) {
  for (Float3& corner : corners) {
    for (float& number : corner) number += 0.0f;  // -0 is at the same place as 0, but has other bytes
  }
  auto geometry = std::make_shared<MeshGeometry>();
  std::size_t const count = corners.size();
  geometry->indices.resize(count);
  std::size_t const vertices =
      meshopt_generateVertexRemap(geometry->indices.data(), nullptr, count, corners.data(), count, sizeof(Float3));
  geometry->positions.resize(vertices);
  meshopt_remapVertexBuffer(geometry->positions.data(), corners.data(), count, sizeof(Float3),
                            geometry->indices.data());
  return geometry;
}

}  // namespace lichtraum::stl
