#include "io/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/gltf/textures.hpp"
#include "io/gltf/values.hpp"
#include "io/model_scene.hpp"

namespace lichtraum::gltf {
namespace {

using tinygltf::Value;

/// Reads one material. Runs twice for each: first to learn which textures are wanted, then with the textures.
class Reader {
 public:
  using FindTexture = std::function<std::shared_ptr<Texture const>(int)>;

  Reader(tinygltf::Material const& source, std::string pointer, std::size_t texture_count, FindTexture find_texture,
         Findings* findings)
      : source_(source),
        pointer_(std::move(pointer)),
        texture_count_(texture_count),
        find_texture_(std::move(find_texture)),
        findings_(findings) {}

  PbrMaterial read() {
    PbrMaterial m;
    read_core(m);
    if (auto const* e = extension("KHR_materials_pbrSpecularGlossiness")) read_specular_glossiness(*e, m);
    m.unlit = extension("KHR_materials_unlit") != nullptr;
    if (auto const* e = extension("KHR_materials_emissive_strength")) {
      m.emissive *= at_least_zero(*e, "emissiveStrength", 1);
    }
    if (auto const* e = extension("KHR_materials_ior")) {
      double const ior = at_least_zero(*e, "ior", 1.5);
      if (ior >= 1) m.ior = ior;
    }
    if (auto const* e = extension("KHR_materials_dispersion")) m.dispersion = at_least_zero(*e, "dispersion", 0);
    if (auto const* e = extension("KHR_materials_specular")) {
      m.specular = fraction(*e, "specularFactor", 1);
      m.specular_color = color(*e, "specularColorFactor", Rgb(1));
      m.specular_texture = slot(*e, "specularTexture");
      m.specular_color_texture = slot(*e, "specularColorTexture");
    }
    if (auto const* e = extension("KHR_materials_transmission")) {
      m.transmission = fraction(*e, "transmissionFactor", 0);
      m.transmission_texture = slot(*e, "transmissionTexture");
    }
    if (auto const* e = extension("KHR_materials_volume")) {
      m.thickness = at_least_zero(*e, "thicknessFactor", 0);
      m.thickness_texture = slot(*e, "thicknessTexture");
      double const distance = at_least_zero(*e, "attenuationDistance", 0);
      if (distance > 0) m.attenuation_distance = distance;
      m.attenuation_color = color(*e, "attenuationColor", Rgb(1));
    }
    if (auto const* e = extension("KHR_materials_clearcoat")) {
      m.clearcoat = fraction(*e, "clearcoatFactor", 0);
      m.clearcoat_texture = slot(*e, "clearcoatTexture");
      m.clearcoat_roughness = fraction(*e, "clearcoatRoughnessFactor", 0);
      m.clearcoat_roughness_texture = slot(*e, "clearcoatRoughnessTexture");
      m.clearcoat_normal_texture = slot(*e, "clearcoatNormalTexture");
    }
    if (auto const* e = extension("KHR_materials_sheen")) {
      m.sheen_color = color(*e, "sheenColorFactor", Rgb(0));
      m.sheen_color_texture = slot(*e, "sheenColorTexture");
      m.sheen_roughness = fraction(*e, "sheenRoughnessFactor", 0);
      m.sheen_roughness_texture = slot(*e, "sheenRoughnessTexture");
    }
    if (auto const* e = extension("KHR_materials_anisotropy")) {
      m.anisotropy = fraction(*e, "anisotropyStrength", 0);
      m.anisotropy_rotation_radians = number_of(*e, "anisotropyRotation", 0);
      m.anisotropy_texture = slot(*e, "anisotropyTexture");
    }
    if (auto const* e = extension("KHR_materials_iridescence")) {
      m.iridescence = fraction(*e, "iridescenceFactor", 0);
      m.iridescence_texture = slot(*e, "iridescenceTexture");
      m.iridescence_ior = std::max(1.0, number_of(*e, "iridescenceIor", 1.3));
      m.iridescence_thickness_minimum_nm = at_least_zero(*e, "iridescenceThicknessMinimum", 100);
      m.iridescence_thickness_maximum_nm = at_least_zero(*e, "iridescenceThicknessMaximum", 400);
      m.iridescence_thickness_texture = slot(*e, "iridescenceThicknessTexture");
    }
    return m;
  }

 private:
  void read_core(PbrMaterial& m) {
    auto const& pbr = source_.pbrMetallicRoughness;
    for (int c = 0; c < 4; ++c) m.base_color[c] = in_range(pbr.baseColorFactor[std::size_t(c)], "baseColorFactor");
    m.metallic = in_range(pbr.metallicFactor, "metallicFactor");
    m.roughness = in_range(pbr.roughnessFactor, "roughnessFactor");
    m.base_color_texture = slot(pbr.baseColorTexture);
    m.metallic_roughness_texture = slot(pbr.metallicRoughnessTexture);
    m.normal_texture = slot(source_.normalTexture);
    m.normal_scale = source_.normalTexture.scale;
    m.occlusion_texture = slot(source_.occlusionTexture);
    m.occlusion_strength = in_range(source_.occlusionTexture.strength, "occlusionTexture/strength");
    for (int c = 0; c < 3; ++c) {
      double const value = source_.emissiveFactor[std::size_t(c)];
      m.emissive[c] = std::isfinite(value) && value > 0 ? value : 0;
    }
    m.emissive_texture = slot(source_.emissiveTexture);
    if (source_.alphaMode == "MASK") m.alpha_mode = AlphaMode::mask;
    if (source_.alphaMode == "BLEND") m.alpha_mode = AlphaMode::blend;
    m.alpha_cutoff = source_.alphaCutoff;
    m.double_sided = source_.doubleSided;
  }

  // The conversion of the extension's own appendix, with the metal's share solved for.
  void read_specular_glossiness(Value const& e, PbrMaterial& m) {
    Rgb const diffuse = color(e, "diffuseFactor", Rgb(1));
    Rgb const specular = color(e, "specularFactor", Rgb(1));
    constexpr double dielectric = 0.04;
    double const strongest = std::max({specular.r, specular.g, specular.b});
    double const diffuse_brightness = brightness(diffuse);
    double const specular_brightness = brightness(specular);
    double metallic = 0;
    if (specular_brightness > dielectric) {
      double const b = diffuse_brightness * (1 - strongest) / (1 - dielectric) + specular_brightness - 2 * dielectric;
      double const c = dielectric - specular_brightness;
      metallic = std::clamp((-b + std::sqrt(std::max(b * b - 4 * dielectric * c, 0.0))) / (2 * dielectric), 0.0, 1.0);
    }
    Rgb const from_diffuse = diffuse * ((1 - strongest) / (1 - dielectric) / std::max(1 - metallic, 1e-6));
    Rgb const from_specular = (specular - Rgb(dielectric) * (1 - metallic)) / std::max(metallic, 1e-6);
    Rgb const base = from_diffuse * (1 - metallic * metallic) + from_specular * (metallic * metallic);
    double alpha = 1;
    if (e.Has("diffuseFactor") && e.Get("diffuseFactor").ArrayLen() == 4) {
      Value const& last = e.Get("diffuseFactor").Get(3);
      if (last.IsNumber()) alpha = last.GetNumberAsDouble();
    }
    for (int c = 0; c < 3; ++c) m.base_color[c] = std::clamp(base[c], 0.0, 1.0);
    m.base_color.a = std::clamp(alpha, 0.0, 1.0);
    m.metallic = metallic;
    m.roughness = 1 - fraction(e, "glossinessFactor", 1);
    m.base_color_texture = slot(e, "diffuseTexture");
    m.metallic_roughness_texture = {};
  }

  // ITU-R BT.601 over squares, as the appendix has it: how bright a colour is perceived.
  static double brightness(Rgb const& c) {
    return std::sqrt(0.299 * c.r * c.r + 0.587 * c.g * c.g + 0.114 * c.b * c.b);
  }

  Value const* extension(char const* name) const { return find_extension(source_.extensions, name); }

  double in_range(double value, char const* name) {
    if (value >= 0 && value <= 1) return value;
    if (findings_) findings_->warn(pointer_, fmt::format("{} is {}, not in 0..1", name, value));
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

  TextureSlot slot(int texture, int texcoord, Value const* transform) {
    TextureSlot result;
    result.texcoord = texcoord;
    result.texture = find_texture_(texture);
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
    result.rotation_radians = number_of(*transform, "rotation", 0);
    if (auto const set = index_of(*transform, "texCoord", 1024)) result.texcoord = *set;
    return result;
  }

  template <class TextureInfo>
  TextureSlot slot(TextureInfo const& info) {
    if (info.index < 0) return {};
    return slot(info.index, info.texCoord, find_extension(info.extensions, "KHR_texture_transform"));
  }

  TextureSlot slot(Value const& e, char const* name) {
    if (!e.IsObject() || !e.Has(name)) return {};
    Value const& info = e.Get(name);
    auto const texture = index_of(info, "index", texture_count_);
    if (!texture) {
      if (findings_)
        findings_->warn(pointer_, fmt::format("{}: its texture is out of range ({})", name, texture_count_));
      return {};
    }
    Value const* transform = nullptr;
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform")) {
      transform = &info.Get("extensions").Get("KHR_texture_transform");
    }
    return slot(*texture, index_of(info, "texCoord", 1024).value_or(0), transform);
  }

  tinygltf::Material const& source_;
  std::string pointer_;
  std::size_t texture_count_;
  FindTexture find_texture_;
  Findings* findings_;
};

}  // namespace

std::vector<std::shared_ptr<Material>> read_materials(Document const& document, int max_texture, Buffers& buffers,
                                                      Findings& findings) {
  auto const& model = document.model;
  std::vector<bool> wanted(model.textures.size(), false);
  for (auto const& source : model.materials) {
    auto const note = [&](int texture) -> std::shared_ptr<Texture const> {
      wanted[std::size_t(texture)] = true;
      return nullptr;
    };
    Reader(source, "", wanted.size(), note, nullptr).read();
  }
  auto const textures = read_textures(document, wanted, max_texture, buffers, findings);

  Names names;
  std::vector<std::shared_ptr<Material>> materials;
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    auto const& source = model.materials[i];
    auto const find = [&](int texture) { return textures[std::size_t(texture)]; };
    Reader reader(source, fmt::format("/materials/{}", i), textures.size(), find, &findings);
    auto pbr = std::make_shared<PbrMaterial const>(reader.read());
    std::string name = names.unique(source.name.empty() ? fmt::format("material_{}", i) : source.name);
    materials.push_back(std::make_shared<Material>(phong_from_pbr(std::move(name), std::move(pbr))));
  }
  // The specification's default is a rough white metal, which is for image-based light; this is what it looks like
  // there.
  auto pbr = std::make_shared<PbrMaterial const>(matt_pbr(Rgb(0.8)));
  materials.push_back(std::make_shared<Material>(phong_from_pbr(names.unique("default"), std::move(pbr))));
  return materials;
}

}  // namespace lichtraum::gltf
