#include "scene/scene_content.hpp"

#include <unordered_map>

namespace lichtraum {
namespace {

/// Textures, each picture's texels once.
class TextureHasher {
 public:
  explicit TextureHasher(ContentHasher& hasher) : hasher_(hasher) {}

  void add(TextureSlot const& slot) {
    hasher_.add(bool(slot));
    if (!slot) return;
    Texture const& texture = *slot.texture;
    hasher_.add(content_of(*texture.image));
    hasher_.add(texture.wrap_s);
    hasher_.add(texture.wrap_t);
    hasher_.add(texture.filter);
    hasher_.add(slot.texcoord);
    hasher_.add(slot.offset);
    hasher_.add(slot.rotation_radians);
    hasher_.add(slot.scale);
  }

 private:
  ContentHash const& content_of(TextureImage const& image) {
    auto const [found, is_new] = images_.try_emplace(&image);
    if (is_new) {
      ContentHasher hasher;
      hasher.add(image.width);
      hasher.add(image.height);
      hasher.add(image.rgba);
      found->second = hasher.finish();
    }
    return found->second;
  }

  ContentHasher& hasher_;
  std::unordered_map<TextureImage const*, ContentHash> images_;
};

void add_fields(ContentHasher& hasher, PhongModel const& model) {
#define LICHTRAUM_FIELD(name, ...) hasher.add(model.name);
  PHONG_FIELDS(LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD)
#undef LICHTRAUM_FIELD
}

/// All but textures.
void add_fields(ContentHasher& hasher, PbrModel const& model) {
#define LICHTRAUM_FIELD(name, ...) hasher.add(model.name);
#define LICHTRAUM_NONE(...)
#define LICHTRAUM_MODE(type, name, initial) hasher.add(model.name);
  PBR_FIELDS(LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_NONE, LICHTRAUM_MODE)
#undef LICHTRAUM_FIELD
#undef LICHTRAUM_NONE
#undef LICHTRAUM_MODE
}

ContentHash content_of(Material const& material) {
  ContentHasher hasher;
  hasher.add(material.model().index());
  std::visit([&](auto const& model) { add_fields(hasher, model); }, material.model());
  return hasher.finish();
}

struct LightFieldHasher {
  ContentHasher& hasher;
  void position(char const*, Vec3 const& value) const { hasher.add(value); }
  void direction(char const*, Vec3 const& value) const { hasher.add(value); }
  void brightness(char const*, Rgb const& value) const { hasher.add(value); }
  void ambient(char const*, Rgb const& value) const { hasher.add(value); }
  void flag(char const*, bool value) const { hasher.add(value); }
  void range(char const*, double value) const { hasher.add(value); }
  void cone(char const*, SpotCone const& value) const { hasher.add(value); }
  void radius(char const*, double value) const { hasher.add(value); }
};

ContentHash content_of(std::vector<Light> const& lights) {
  ContentHasher hasher;
  LightFieldHasher const fields{hasher};
  for (Light const& light : lights) {
    hasher.add(light.model().index());
    std::visit([&](auto const& model) { for_each_field(model, fields); }, light.model());
  }
  return hasher.finish();
}

ContentHash content_of(EnvironmentMap const& map) {
  ContentHasher hasher;
  hasher.add(map.width);
  hasher.add(map.height);
  hasher.add(map.radiance);
  return hasher.finish();
}

/// All but the map.
ContentHash content_of(std::optional<EnvironmentLight> const& environment) {
  ContentHasher hasher;
  hasher.add(environment.has_value());
  if (environment) {
    hasher.add(environment->rotation_degrees);
    hasher.add(environment->brightness);
  }
  return hasher.finish();
}

ContentHash content_of_shapes(FlatScene const& scene) {
  ContentHasher hasher;
  for (FlatObject const& object : scene.objects) {
    hasher.add(object.content);
    hasher.add(object.shape_count);
  }
  for (FlatInstance const& instance : scene.instances) {
    hasher.add(instance.object);
    hasher.add(instance.world_from_object.matrix());
    hasher.add(instance.world_from_object.inverse_matrix());
    hasher.add(instance.world_shapes_before);
  }
  hasher.add(scene.unrepresentable);
  TextureHasher textures(hasher);
  for (auto const& material : scene.materials) {
    PbrModel const* const pbr = material ? material->pbr() : nullptr;
    if (!pbr) continue;
    for (auto const slot : texture_slots) textures.add(pbr->*slot);
  }
  return hasher.finish();
}

}  // namespace

ContentHash content_of(FlatObject const& object) {
  ContentHasher hasher;
  device::for_each_kind(object, [&](auto const& primitives) { hasher.add(primitives); });
  hasher.add(object.triangle_attributes);
  hasher.add(object.sphere_colors);
  hasher.add(object.ellipsoid_colors);
  hasher.add(object.cylinder_colors);
  hasher.add(object.vertex_data);
  return hasher.finish();
}

SceneContent content_of(FlatScene const& scene, std::vector<Light> const& lights,
                        std::optional<EnvironmentLight> const& environment, Vec3 const& up) {
  SceneContent content{content_of_shapes(scene), {}, content_of(lights), {}, content_of(environment), up};
  if (environment) content.environment_map = content_of(*environment->map);
  for (auto const& material : scene.materials) {
    content.materials.push_back(content_of(material ? *material : Material()));
  }
  return content;
}

SceneContent edit_content(SceneContent content, std::vector<Material const*> const& materials,
                          EnvironmentMap const* map, SceneEdits const& edits) {
  for (std::size_t i = 0; i < materials.size(); ++i) {
    auto const found = edits.materials.find(materials[i]);
    if (found != edits.materials.end()) content.materials[i] = content_of(found->second);
  }
  if (edits.lights) content.lights = content_of(*edits.lights);
  content.environment = content_of(edits.environment);
  EnvironmentMap const* const edited_map = edits.environment ? edits.environment->map.get() : nullptr;
  if (edited_map != map) content.environment_map = edited_map ? content_of(*edited_map) : ContentHash{};
  return content;
}

std::string scene_fingerprint(SceneContent const& content, SceneShading const& shading) {
  ContentHasher hasher;
  hasher.add(content.shapes);
  hasher.add(content.materials);
  hasher.add(content.lights);
  hasher.add(content.environment_map);
  hasher.add(content.environment);
  hasher.add(content.up);
  hasher.add(shading.ambient);
  hasher.add(shading.background);
  hasher.add(shading.tone_map);
  return hasher.finish().text();
}

}  // namespace lichtraum
