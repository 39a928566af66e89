#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"
#include "shared/pbr_fields.h"

namespace LICHTRAUM_API lichtraum {

/// A decoded picture: eight bits each of red, green, blue and alpha, first row at the top. What the numbers mean (sRGB
/// colours or plain data) is said where it is used.
struct TextureImage {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< height x width x 4
};

enum class TextureWrap { repeat, mirrored_repeat, clamp_to_edge };
enum class TextureFilter { nearest, linear };

/// A picture and how it goes on beyond its edges.
struct Texture {
  std::shared_ptr<TextureImage const> image;
  TextureWrap wrap_s = TextureWrap::repeat;
  TextureWrap wrap_t = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::linear;
};

/// A texture in its place in a material. A texture coordinate uv looks up
///   offset + rotation * (scale * uv)   (KHR_texture_transform; the rotation is counter-clockwise in texture space).
struct TextureSlot {
  std::shared_ptr<Texture const> texture;  ///< null: the slot is empty and counts as all ones
  int texcoord = 0;                        ///< which of MeshGeometry::texcoords
  glm::dvec2 offset{0};
  double rotation_radians = 0;
  glm::dvec2 scale{1};
  explicit operator bool() const { return texture != nullptr; }
};

enum class AlphaMode { opaque, mask, blend };

/// The metallic-roughness material of glTF 2.0 with its extensions, as written: what a physically based integrator
/// needs. Colours are linear; textures of colours (base, emissive, specular, sheen, diffuse transmission) are stored in
/// sRGB, all others linear. shared/pbr_fields.h says what each field means.
struct PbrModel {
#define LICHTRAUM_COLOR(name, initial, extension, key) Rgb name{initial};
#define LICHTRAUM_SHARE(name, initial, extension, key) double name = initial;
#define LICHTRAUM_NUMBER(name, initial, least, most, extension, key) double name = initial;
#define LICHTRAUM_TEXTURE(name, extension, key) TextureSlot name{};
#define LICHTRAUM_MODE(type, name, initial) type name = initial;
  PBR_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER, LICHTRAUM_TEXTURE, LICHTRAUM_MODE)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
#undef LICHTRAUM_TEXTURE
#undef LICHTRAUM_MODE
};

/// Every texture slot of a material.
inline constexpr TextureSlot PbrModel::*texture_slots[] = {
#define LICHTRAUM_NONE(...)
#define LICHTRAUM_TEXTURE(name, extension, key) &PbrModel::name,
    PBR_FIELDS(LICHTRAUM_NONE, LICHTRAUM_NONE, LICHTRAUM_NONE, LICHTRAUM_TEXTURE, LICHTRAUM_NONE)
#undef LICHTRAUM_NONE
#undef LICHTRAUM_TEXTURE
};

}  // namespace lichtraum
