#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lichtraum/drawn_objects.hpp"
#include "lichtraum/scene_edits.hpp"

namespace lichtraum::view {

/// A scene's lights, environment and materials as values to change: what sliders stand for. The scene stays as it is.
class SceneValues {
 public:
  SceneValues() = default;
  /// Of the materials, those that what is drawn has.
  SceneValues(Scene const& scene, DrawnObjects const& objects);

  struct EditableMaterial {
    Material const* original;  ///< the scene's
    Material value;
    bool is_listed = false;  ///< as Scene::materials lists it: an eSDF scene does not list those of its meshes
    bool is_edited = false;
  };
  std::vector<Light> lights;
  std::optional<EnvironmentLight> environment;
  std::vector<EditableMaterial> materials;  ///< by name

  Light const& original_light(std::size_t number) const { return original_lights_[number]; }
  void reset_light(std::size_t number) { lights[number] = original_lights_[number]; }
  void reset_material(std::size_t number) {
    materials[number].value = *materials[number].original;
    materials[number].is_edited = false;
  }
  bool is_environment_edited() const;
  /// Anything of it.
  bool is_edited() const;
  void reset();
  SceneEdits edits() const;

  /// Its place in `materials`; nothing for the default material.
  std::size_t const* find(Material const* original) const;

 private:
  std::vector<Light> original_lights_;
  std::optional<EnvironmentLight> original_environment_;
  std::unordered_map<Material const*, std::size_t> places_;
};

}  // namespace lichtraum::view
