#include "scene/studio_environment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/elementary.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum {
namespace {

constexpr int width = 1024, height = 512;
constexpr double pi = std::numbers::pi;
constexpr double mean_radiance = 0.7;

/// From 0 at `low` to 1 at `high`, with no kink.
double smooth_step(double low, double high, double x) {
  double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A rectangle of light with soft edges that stands at distance 1 and faces the middle.
struct SoftBox {
  Vec3 towards;  // unit
  double half_width, half_height;
  double edge;  // how far its light takes to fade
  double radiance;

  double light(Vec3 const& direction) const {
    double const distance = glm::dot(direction, towards);
    if (distance <= 0.05) return 0;
    Vec3 const right = glm::normalize(glm::cross(Vec3(0, 1, 0), towards));
    Vec3 const up = glm::cross(towards, right);
    double const x = std::abs(glm::dot(direction, right)) / distance, y = std::abs(glm::dot(direction, up)) / distance;
    double const shape = (1 - smooth_step(half_width - edge, half_width + edge, x)) *
                         (1 - smooth_step(half_height - edge, half_height + edge, y));
    // Brighter in the middle, as a lamp behind cloth is.
    return radiance * shape *
           (1 - 0.35 * std::min(1.0, x * x / (half_width * half_width)) -
            0.25 * std::min(1.0, y * y / (half_height * half_height)));
  }
};

/// `azimuth`: from who looks along -z, who stands towards +z, to the right; both in degrees.
Vec3 direction_of(double azimuth, double elevation) {
  double const a = azimuth * pi / 180, e = elevation * pi / 180;
  return {cos_of(e) * sin_of(a), sin_of(e), cos_of(e) * cos_of(a)};
}

double light_from(std::span<SoftBox const> boxes, Vec3 const& direction) {
  // A surround that is lighter above than below the horizon, and a floor that gives back what falls on it.
  double light = 0.16 + 0.20 * smooth_step(-0.3, 0.9, direction.y);
  light += 0.22 * smooth_step(0.05, 0.85, -direction.y);
  for (SoftBox const& box : boxes) light += box.light(direction);
  return light;
}

}  // namespace

std::shared_ptr<EnvironmentMap const> studio_environment() {
  auto map = std::make_shared<EnvironmentMap>();
  map->width = width;
  map->height = height;
  SoftBox const boxes[] = {
      {direction_of(-48, 42), 0.62, 0.52, 0.16, 9.0},   // key
      {direction_of(68, 18), 0.40, 0.70, 0.20, 2.2},    // fill
      {direction_of(160, 34), 0.75, 0.22, 0.14, 6.0},   // rim
      {direction_of(-125, 12), 0.22, 0.75, 0.14, 2.0},  // outline on the key's side
  };
  std::vector<double> lights;
  double sum = 0, weights = 0;
  for (int row = 0; row < height; ++row) {
    double const theta = pi * (row + 0.5) / height, sine = sin_of(theta), cosine = cos_of(theta);
    for (int column = 0; column < width; ++column) {
      double const phi = 2 * pi * ((column + 0.5) / width - 0.5);
      lights.push_back(light_from(boxes, {sine * cos_of(phi), cosine, sine * sin_of(phi)}));
      sum += lights.back() * sine;
      weights += sine;
    }
  }
  // What a white sphere reflects on the average is what arrives on the average.
  double const scale = mean_radiance * weights / sum;
  map->radiance.reserve(3 * lights.size());
  for (double const light : lights) map->radiance.insert(map->radiance.end(), 3, float(scale * light));
  return map;
}

}  // namespace lichtraum
