#include "scene/texture_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/elementary.hpp"
#include "core/srgb.hpp"

namespace lichtraum {
namespace {

/// The texel in whose column (or row) `place` lies; both count in texels. Always one of 0..size-1.
int wrapped(double place, int size, TextureWrap wrap) {
  double const n = size;
  if (!std::isfinite(place)) return 0;
  double const whole = std::floor(place);
  double texel = whole;
  if (wrap == TextureWrap::repeat) texel = whole - n * std::floor(whole / n);
  if (wrap == TextureWrap::mirrored_repeat) {
    double const in_pair = whole - 2 * n * std::floor(whole / (2 * n));
    texel = in_pair < n ? in_pair : 2 * n - 1 - in_pair;
  }
  return int(std::clamp(texel, 0.0, n - 1));
}

glm::dvec4 texel_at(TextureImage const& image, int column, int row, TexelContent content) {
  std::uint8_t const* const rgba = &image.rgba[4 * (std::size_t(row) * std::size_t(image.width) + std::size_t(column))];
  glm::dvec4 value = glm::dvec4(rgba[0], rgba[1], rgba[2], rgba[3]) / 255.0;
  if (content == TexelContent::color) {
    for (int c = 0; c < 3; ++c) value[c] = linear_from_srgb(value[c]);
  }
  return value;
}

}  // namespace

glm::dvec2 transform_coordinate(TextureSlot const& slot, glm::dvec2 const& uv) {
  double const cosine = cos_of(slot.rotation_radians);
  double const sine = sin_of(slot.rotation_radians);
  glm::dvec2 const scaled = slot.scale * uv;
  // Counter-clockwise as seen where v points down.
  return slot.offset + glm::dvec2(cosine * scaled.x + sine * scaled.y, cosine * scaled.y - sine * scaled.x);
}

glm::dvec4 look_up(TextureSlot const& slot, glm::dvec2 const& uv, TexelContent content) {
  Texture const& texture = *slot.texture;
  TextureImage const& image = *texture.image;
  glm::dvec2 const place = transform_coordinate(slot, uv) * glm::dvec2(image.width, image.height);
  auto const column = [&](double x) { return wrapped(x, image.width, texture.wrap_s); };
  auto const row = [&](double y) { return wrapped(y, image.height, texture.wrap_t); };
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) return texel_at(image, 0, 0, content);
  if (texture.filter == TextureFilter::nearest) return texel_at(image, column(place.x), row(place.y), content);
  double const x = place.x - 0.5, y = place.y - 0.5;  // texels have their values in their middles
  glm::dvec4 const upper = glm::mix(texel_at(image, column(x), row(y), content),
                                    texel_at(image, column(x + 1), row(y), content), x - std::floor(x));
  glm::dvec4 const lower = glm::mix(texel_at(image, column(x), row(y + 1), content),
                                    texel_at(image, column(x + 1), row(y + 1), content), x - std::floor(x));
  return glm::mix(upper, lower, y - std::floor(y));
}

}  // namespace lichtraum
