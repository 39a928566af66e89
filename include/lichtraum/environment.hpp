#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// Radiance from infinitely far away, in latitude and longitude: a texel (column, row) holds what arrives from the
/// direction whose u = (column + 0.5) / width and v = (row + 0.5) / height, where, in a world whose Scene::up is
/// +y, before the light's rotation,  u = 0.5 + atan2(z, x) / (2 pi)  and  v = acos(y) / pi.  So +y is up, and -x lies
/// at the left and right edge.
struct EnvironmentMap {
  int width = 0;
  int height = 0;
  std::vector<float> radiance;  ///< height x width x 3, first row at the top; linear Rec. 709, finite and not negative
  std::string repairs{};        ///< which values of its file were replaced, for people; empty: none
};

/// The most that a map's file may have: 16384 x 8192.
inline constexpr std::int64_t max_environment_pixels = std::int64_t(1) << 27;

/// Reads a map from a picture in latitude and longitude: Radiance (.hdr; RGBE, whichever run lengths), OpenEXR (.exr;
/// R, G and B, or Y, of any type) or PFM (.pfm), told apart by their first bytes, whose values are taken for linear
/// Rec. 709. Values that are negative or no numbers become 0, infinite ones the largest other value. Throws
/// Error{no_input} for a file that cannot be opened, Error{scene} for one that is not whole, has no pixels or too many,
/// or more than one such value in a hundred; the message says where, and what to do.
EnvironmentMap read_environment(std::filesystem::path const& path);

/// The most that EnvironmentLight::brightness may be where somebody writes it.
inline constexpr double max_environment_brightness = 1e6;

/// A map around the scene. Radiance 1 from everywhere lights a white diffuse surface to 1.
struct EnvironmentLight {
  /// Where the map is from: a file's path, a built-in one's name, or the numbers of its one colour.
  std::string source;
  std::shared_ptr<EnvironmentMap const> map;
  double rotation_degrees = 0;  ///< about Scene::up, counter-clockwise seen from above
  double brightness = 1;        ///< >= 0; what the map's radiance is multiplied by
  std::string name{};           ///< in the scene's file; empty for one that was chosen elsewhere
};

/// The map that has the same radiance everywhere.
std::shared_ptr<EnvironmentMap const> uniform_environment(float red, float green, float blue);

/// An environment that is chosen for a scene. What is left open is as the scene has it.
struct EnvironmentChoice {
  std::string source;                      ///< a map's path, "studio" (the built-in one) or "none"
  std::optional<double> rotation_degrees;  ///< else the scene's for its own map, 0 for another
  std::optional<double> brightness;        ///< else the scene's for its own map, 1 for another
  friend bool operator==(EnvironmentChoice const&, EnvironmentChoice const&) = default;
};

/// The map of EnvironmentChoice::source: read, or made. Not of "none". Exceptions as read_environment.
std::shared_ptr<EnvironmentMap const> environment_map(std::string const& source);

/// What lights a scene whose own environment is `own`; `map`: finds source's.
std::optional<EnvironmentLight> chosen_environment(
    EnvironmentChoice const& choice, std::optional<EnvironmentLight> own,
    std::function<std::shared_ptr<EnvironmentMap const>(std::string const&)> const& map = environment_map);

}  // namespace lichtraum
