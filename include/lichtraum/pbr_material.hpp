#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/math.hpp"

namespace lichtraum {

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
/// needs. Colours are linear; textures of colours (base, emissive, specular, sheen, diffuse) are stored in sRGB, all
/// others linear. Factors are multiplied with their textures.
struct PbrMaterial {
  glm::dvec4 base_color{1};  ///< linear red, green, blue, alpha; also times the vertex colour
  TextureSlot base_color_texture;
  double metallic = 1;   ///< 0..1; times the texture's blue
  double roughness = 1;  ///< 0..1; times the texture's green
  TextureSlot metallic_roughness_texture;
  TextureSlot normal_texture;
  double normal_scale = 1;
  TextureSlot occlusion_texture;  ///< red
  double occlusion_strength = 1;
  Rgb emissive{0};  ///< with KHR_materials_emissive_strength multiplied in
  TextureSlot emissive_texture;

  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = false;
  bool unlit = false;  ///< KHR_materials_unlit: shows its base colour, whatever the light

  double ior = 1.5;       ///< KHR_materials_ior
  double dispersion = 0;  ///< KHR_materials_dispersion: 20 / Abbe number
  double specular = 1;    ///< KHR_materials_specular
  Rgb specular_color{1};
  TextureSlot specular_texture;  ///< alpha
  TextureSlot specular_color_texture;

  double transmission = 0;                     ///< KHR_materials_transmission
  TextureSlot transmission_texture;            ///< red
  double thickness = 0;                        ///< KHR_materials_volume: 0 is a thin wall, all else a solid body
  TextureSlot thickness_texture;               ///< green
  std::optional<double> attenuation_distance;  ///< nothing: clear
  Rgb attenuation_color{1};

  double clearcoat = 0;           ///< KHR_materials_clearcoat
  TextureSlot clearcoat_texture;  ///< red
  double clearcoat_roughness = 0;
  TextureSlot clearcoat_roughness_texture;  ///< green
  TextureSlot clearcoat_normal_texture;

  Rgb sheen_color{0};  ///< KHR_materials_sheen
  TextureSlot sheen_color_texture;
  double sheen_roughness = 0;
  TextureSlot sheen_roughness_texture;  ///< alpha

  double anisotropy = 0;  ///< KHR_materials_anisotropy: strength, 0..1
  double anisotropy_rotation_radians = 0;
  TextureSlot anisotropy_texture;

  double iridescence = 0;           ///< KHR_materials_iridescence
  TextureSlot iridescence_texture;  ///< red
  double iridescence_ior = 1.3;
  double iridescence_thickness_minimum_nm = 100;
  double iridescence_thickness_maximum_nm = 400;
  TextureSlot iridescence_thickness_texture;  ///< green
};

/// Every texture slot of a material.
inline constexpr TextureSlot PbrMaterial::*texture_slots[] = {
    &PbrMaterial::base_color_texture,
    &PbrMaterial::metallic_roughness_texture,
    &PbrMaterial::normal_texture,
    &PbrMaterial::occlusion_texture,
    &PbrMaterial::emissive_texture,
    &PbrMaterial::transmission_texture,
    &PbrMaterial::specular_texture,
    &PbrMaterial::specular_color_texture,
    &PbrMaterial::thickness_texture,
    &PbrMaterial::clearcoat_texture,
    &PbrMaterial::clearcoat_roughness_texture,
    &PbrMaterial::clearcoat_normal_texture,
    &PbrMaterial::sheen_color_texture,
    &PbrMaterial::sheen_roughness_texture,
    &PbrMaterial::anisotropy_texture,
    &PbrMaterial::iridescence_texture,
    &PbrMaterial::iridescence_thickness_texture,
};

}  // namespace lichtraum
