#pragma once

#include <memory>
#include <string>
#include <vector>

namespace lichtraum {

/// Radiance from infinitely far away, in latitude and longitude: a texel (column, row) holds what arrives from the
/// direction whose u = (column + 0.5) / width and v = (row + 0.5) / height, where, in the world before the light's
/// rotation,  u = 0.5 + atan2(z, x) / (2 pi)  and  v = acos(y) / pi.  So +y is up, and -x lies at the left and right
/// edge.
struct EnvironmentMap {
  int width = 0;
  int height = 0;
  std::vector<float> radiance;  ///< height x width x 3, first row at the top; linear Rec. 709, finite and not negative
};

/// A map around the scene. Radiance 1 from everywhere lights a white diffuse surface to 1.
struct EnvironmentLight {
  std::string source;  ///< where the map is from: a file's path, or a built-in one's name
  std::shared_ptr<EnvironmentMap const> map;
  double rotation_degrees = 0;  ///< about the y axis, counter-clockwise seen from above
  double brightness = 1;        ///< >= 0; what the map's radiance is multiplied by
};

}  // namespace lichtraum
