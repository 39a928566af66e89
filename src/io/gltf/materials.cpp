#include "io/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/float3.hpp"
#include "io/gltf/roughness_pictures.hpp"
#include "io/gltf/textures.hpp"
#include "io/gltf/values.hpp"
#include "io/model_scene.hpp"

namespace lichtraum::gltf {
namespace {

using tinygltf::Value;

/// Reads one material. Runs twice for each: first to learn which textures are wanted, then with the textures.
class Reader {
 public:
  using FindTexture = std::function<std::shared_ptr<Texture const>(int, TexelContent)>;

  Reader(tinygltf::Material const& source, std::string pointer, std::size_t texture_count, FindTexture find_texture,
         RoughnessPictures& roughness_pictures, Findings* findings)
      : source_(source),
        pointer_(std::move(pointer)),
        texture_count_(texture_count),
        find_texture_(std::move(find_texture)),
        roughness_pictures_(roughness_pictures),
        findings_(findings) {}

  PbrModel read() {
    PbrModel m;
    read_core(m);
    if (auto const* e = extension("KHR_materials_pbrSpecularGlossiness")) read_specular_glossiness(*e, m);
    m.unlit = extension("KHR_materials_unlit") != nullptr;
    if (auto const* e = extension("KHR_materials_emissive_strength")) {
      m.emissive *= at_least_zero(*e, "emissiveStrength", 1);
    }
    read_extensions(m);
    keep_finite(m);
    return m;
  }

 private:
  /// Each of a file's numbers is finite, but not what is computed of huge ones: as if it had said nothing.
  static void keep_finite(PbrModel& m) {
    PbrModel const initial;
#define LICHTRAUM_COLOR(name, ...) \
  if (!is_finite(m.name)) m.name = initial.name;
#define LICHTRAUM_NUMBER(name, ...) \
  if (!std::isfinite(m.name)) m.name = initial.name;
#define LICHTRAUM_NONE(...)
    PBR_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_NUMBER, LICHTRAUM_NUMBER, LICHTRAUM_NONE, LICHTRAUM_NONE)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_NUMBER
#undef LICHTRAUM_NONE
  }

  // What shared/pbr_fields.h has a word for.
  void read_extensions(PbrModel& m) {
#define LICHTRAUM_COLOR(name, initial, extension, key) \
  if (auto const* e = object_of(extension, key)) m.name = color(*e, key, Rgb(initial));
#define LICHTRAUM_SHARE(name, initial, extension, key) \
  if (auto const* e = object_of(extension, key)) m.name = fraction(*e, key, initial);
#define LICHTRAUM_NUMBER(name, initial, least, most, extension, key) \
  if (auto const* e = object_of(extension, key)) m.name = allowed(number_of(*e, key, initial), least, initial);
#define LICHTRAUM_TEXTURE(name, extension, key) \
  if (auto const* e = object_of(extension, key)) m.name = slot(*e, key);
#define LICHTRAUM_MODE(type, name, initial)
    PBR_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER, LICHTRAUM_TEXTURE, LICHTRAUM_MODE)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
#undef LICHTRAUM_TEXTURE
#undef LICHTRAUM_MODE
    // 0 stands for an infinite one: all is reflected (KHR_materials_ior, "Specular-Glossiness Backwards
    // Compatibility").
    if (auto const* e = extension("KHR_materials_ior"); e && number_of(*e, "ior", 1.5) == 0) m.ior = 0;
    if (!(m.attenuation_distance > 0)) m.attenuation_distance = INFINITY;
    if (auto const* e = extension("KHR_materials_clearcoat"); e && e->Has("clearcoatNormalTexture")) {
      m.clearcoat_normal_scale = number_of(e->Get("clearcoatNormalTexture"), "scale", 1);
    }
    if (auto const* e = extension("KHR_materials_anisotropy")) {
      m.anisotropy_rotation = std::remainder(number_of(*e, "anisotropyRotation", 0), 2 * std::numbers::pi);
    }
  }

  void read_core(PbrModel& m) {
    auto const& pbr = source_.pbrMetallicRoughness;
    for (int c = 0; c < 3; ++c) m.base_color[c] = in_range(pbr.baseColorFactor[std::size_t(c)], "baseColorFactor");
    m.alpha = in_range(pbr.baseColorFactor[3], "baseColorFactor");
    m.metallic = in_range(pbr.metallicFactor, "metallicFactor");
    m.roughness = in_range(pbr.roughnessFactor, "roughnessFactor");
    m.base_color_texture = slot(pbr.baseColorTexture, TexelContent::color);
    m.metallic_roughness_texture = slot(pbr.metallicRoughnessTexture, TexelContent::data);
    m.normal_texture = slot(source_.normalTexture, TexelContent::data);
    m.normal_scale = source_.normalTexture.scale;
    m.occlusion_texture = slot(source_.occlusionTexture, TexelContent::data);
    m.occlusion_strength = in_range(source_.occlusionTexture.strength, "occlusionTexture/strength");
    for (int c = 0; c < 3; ++c) {
      double const value = source_.emissiveFactor[std::size_t(c)];
      m.emissive[c] = std::isfinite(value) && value > 0 ? value : 0;
    }
    m.emissive_texture = slot(source_.emissiveTexture, TexelContent::color);
    if (source_.alphaMode == "MASK") m.alpha_mode = AlphaMode::mask;
    if (source_.alphaMode == "BLEND") m.alpha_mode = AlphaMode::blend;
    m.alpha_cutoff = source_.alphaCutoff;
    m.double_sided = source_.doubleSided;
  }

  void read_specular_glossiness(Value const& e, PbrModel& m) {
    double alpha = 1;
    if (e.Has("diffuseFactor") && e.Get("diffuseFactor").ArrayLen() == 4) {
      Value const& last = e.Get("diffuseFactor").Get(3);
      if (last.IsNumber()) alpha = last.GetNumberAsDouble();
    }
    m.alpha = std::clamp(alpha, 0.0, 1.0);
    m.base_color_texture = slot(e, "diffuseTexture");
    m.base_color = glm::min(color(e, "diffuseFactor", Rgb(1)), Rgb(1));
    // The extension's own model, as KHR_materials_ior and KHR_materials_specular have it: a dielectric of an infinite
    // index, whose specular colour is what it reflects. A metal's share would need both pictures in one.
    m.metallic = 0;
    m.ior = 0;
    m.specular_color = glm::min(color(e, "specularFactor", Rgb(1)), Rgb(1));
    m.metallic_roughness_texture = {};
    double const glossiness = fraction(e, "glossinessFactor", 1);
    m.roughness = 1 - glossiness;
    m.specular_color_texture = slot(e, "specularGlossinessTexture");
    if (m.specular_color_texture) read_glossiness_picture(m.specular_color_texture, glossiness, m);
  }

  void read_glossiness_picture(TextureSlot const& picture, double glossiness, PbrModel& m) {
    auto const roughness = roughness_pictures_.roughness_from(picture.texture->image, glossiness);
    m.roughness = roughness.factor;
    if (roughness.picture) {
      Texture texture = *picture.texture;
      texture.image = roughness.picture;
      m.metallic_roughness_texture = picture;
      m.metallic_roughness_texture.texture = std::make_shared<Texture const>(std::move(texture));
    }
    if (roughness.is_average && findings_) {
      findings_->warn(DiagnosticCode::texture_left_out, pointer_,
                      "there is no room for a picture of the glossiness: its average counts");
    }
  }

  /// The extension that a field's word is in; null for a field of the core.
  Value const* object_of(std::string const& extension_of_field, std::string_view key) const {
    return key.empty() ? nullptr : extension(("KHR_materials_" + extension_of_field).c_str());
  }
  static double allowed(double value, double least, double otherwise) { return value >= least ? value : otherwise; }

  Value const* extension(char const* name) const { return find_extension(source_.extensions, name); }

  double in_range(double value, char const* name) {
    if (value >= 0 && value <= 1) return value;
    if (findings_)
      findings_->warn(DiagnosticCode::faulty_gltf_material, pointer_,
                      fmt::format("{} is {}, not in 0..1", name, value));
    return value > 1 ? 1 : 0;
  }
  static double fraction(Value const& e, char const* name, double absent) {
    return std::clamp(number_of(e, name, absent), 0.0, 1.0);
  }
  static double at_least_zero(Value const& e, char const* name, double absent) {
    return std::max(number_of(e, name, absent), 0.0);
  }
  static Rgb color(Value const& e, char const* name, Rgb const& absent) {
    if (!e.IsObject() || !e.Has(name) || e.Get(name).ArrayLen() < 3) return absent;
    Rgb result(0);
    for (int c = 0; c < 3; ++c) {
      Value const& component = e.Get(name).Get(c);
      if (!component.IsNumber()) return absent;
      result[c] = std::max(component.GetNumberAsDouble(), 0.0);
    }
    return result;
  }

  TextureSlot slot(int texture, int texcoord, TexelContent content, Value const* transform) {
    TextureSlot result;
    result.texcoord = texcoord;
    result.texture = find_texture_(texture, content);
    if (!transform) return result;
    auto const pair = [&](char const* name, glm::dvec2 absent) {
      if (!transform->Has(name) || transform->Get(name).ArrayLen() != 2) return absent;
      Value const& x = transform->Get(name).Get(0);
      Value const& y = transform->Get(name).Get(1);
      if (!x.IsNumber() || !y.IsNumber()) return absent;
      return glm::dvec2(x.GetNumberAsDouble(), y.GetNumberAsDouble());
    };
    result.offset = pair("offset", glm::dvec2(0));
    result.scale = pair("scale", glm::dvec2(1));
    result.rotation_radians = std::remainder(number_of(*transform, "rotation", 0), 2 * std::numbers::pi);
    if (auto const set = index_of(*transform, "texCoord", 1024)) result.texcoord = *set;
    return result;
  }

  template <class TextureInfo>
  TextureSlot slot(TextureInfo const& info, TexelContent content) {
    if (info.index < 0) return {};
    return slot(info.index, info.texCoord, content, find_extension(info.extensions, "KHR_texture_transform"));
  }

  /// Of an extension's texture, by its key.
  static TexelContent content_of(std::string_view key) {
    bool const is_color =
        key.ends_with("ColorTexture") || key == "diffuseTexture" || key == "specularGlossinessTexture";
    return is_color ? TexelContent::color : TexelContent::data;
  }

  TextureSlot slot(Value const& e, char const* name) {
    if (!e.IsObject() || !e.Has(name)) return {};
    Value const& info = e.Get(name);
    auto const texture = index_of(info, "index", texture_count_);
    if (!texture) {
      if (findings_)
        findings_->warn(DiagnosticCode::faulty_gltf_material, pointer_,
                        fmt::format("{}: its texture is out of range ({})", name, texture_count_));
      return {};
    }
    Value const* transform = nullptr;
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform")) {
      transform = &info.Get("extensions").Get("KHR_texture_transform");
    }
    return slot(*texture, index_of(info, "texCoord", 1024).value_or(0), content_of(name), transform);
  }

  tinygltf::Material const& source_;
  std::string pointer_;
  std::size_t texture_count_;
  FindTexture find_texture_;
  RoughnessPictures& roughness_pictures_;
  Findings* findings_;
};

/// Whether something has colours of its vertices, but no material.
bool has_colors_alone(tinygltf::Model const& model) {
  return std::ranges::any_of(model.meshes, [](tinygltf::Mesh const& mesh) {
    return std::ranges::any_of(mesh.primitives, [](tinygltf::Primitive const& primitive) {
      return primitive.material < 0 && primitive.attributes.contains("COLOR_0");
    });
  });
}

}  // namespace

std::vector<std::shared_ptr<Material>> read_materials(Document const& document, ModelChoice const& choice,
                                                      Buffers& buffers, Budget& budget, Findings& findings) {
  auto const& model = document.model;
  RoughnessPictures roughness_pictures(budget);
  std::vector<std::optional<TexelContent>> used(model.textures.size());
  for (auto const& source : model.materials) {
    auto const note = [&](int texture, TexelContent content) -> std::shared_ptr<Texture const> {
      if (used[std::size_t(texture)] != TexelContent::color) used[std::size_t(texture)] = content;
      return nullptr;
    };
    Reader(source, "", used.size(), note, roughness_pictures, nullptr).read();
  }
  auto const textures = read_textures(document, used, choice.max_texture, buffers, findings);

  Names names;
  std::vector<std::shared_ptr<Material>> materials;
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    auto const& source = model.materials[i];
    auto const find = [&](int texture, TexelContent) { return textures[std::size_t(texture)]; };
    Reader reader(source, fmt::format("/materials/{}", i), textures.size(), find, roughness_pictures, &findings);
    std::string name = names.unique(source.name.empty() ? fmt::format("material_{}", i) : source.name);
    PbrModel read = reader.read();
    read.double_sided = read.double_sided || choice.both_sides;
    materials.push_back(std::make_shared<Material>(std::move(name), std::move(read)));
  }
  // The specification's default is a rough white metal, whose form hardly shows; with colours it is what they say.
  PbrModel unnamed = matt_pbr(has_colors_alone(model) ? Rgb(1) : default_grey);
  unnamed.double_sided = choice.both_sides;
  materials.push_back(std::make_shared<Material>(names.unique("default"), std::move(unnamed)));
  return materials;
}

}  // namespace lichtraum::gltf
