#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "lichtraum/api.hpp"
#include "lichtraum/model.hpp"

namespace LICHTRAUM_API lichtraum {

/// A model that is read once and posed at many times: its files, materials and undeformed geometry are shared.
class GltfAnimation {
 public:
  /// Reads what import_gltf reads, with the same exceptions. options.time_seconds plays no role.
  explicit GltfAnimation(std::filesystem::path const& path, ModelOptions const& options = {});
  /// Reads what import_gltf_bytes reads.
  GltfAnimation(std::string bytes, std::string const& name, ModelOptions const& options = {});
  ~GltfAnimation();
  GltfAnimation(GltfAnimation&&) noexcept;
  GltfAnimation& operator=(GltfAnimation&&) noexcept;

  /// The time of the last key frame of options.animation; 0 without an animation.
  double duration_seconds();
  /// From now on the camera of a model that has none shows all of the animation, and stands still from pose to pose;
  /// its made-up lights, too. Takes a few poses. Same exceptions as `pose`.
  void frame_whole_animation();
  /// The model at that time; nothing: as the nodes stand in the file. The first call's diagnostics are about the model,
  /// later ones' about that pose. Same exceptions as import_gltf.
  Model pose(std::optional<double> time_seconds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether `path` ends in .gltf or .glb, in any case.
bool is_gltf_file(std::filesystem::path const& path);

/// Reads a glTF 2.0 model, .gltf or .glb: a composite per node, named after it, and a Mesh per primitive. Each message
/// begins with the place in the file, a JSON pointer. Throws what import_model throws, a SceneError also for what is
/// not glTF 2, and Error{usage} for an unknown scene or animation.
Model import_gltf(std::filesystem::path const& path, ModelOptions const& options = {});

/// The same from the file's bytes. `name` stands for the file in messages; other files that it names are left out.
Model import_gltf_bytes(std::string bytes, std::string const& name, ModelOptions const& options = {});

/// The scene alone.
Scene load_gltf(std::filesystem::path const& path, ModelOptions const& options = {});

}  // namespace lichtraum
