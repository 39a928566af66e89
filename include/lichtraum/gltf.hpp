#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/error.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum {

struct GltfOptions {
  std::string scene;                   ///< index or name of the scene to import; empty: the file's default one
  std::optional<double> time_seconds;  ///< pose of the animation at that time; nothing: as the nodes stand in the file
  std::string animation;               ///< index or name of the animation that `time_seconds` is for; empty: the first
  int max_texture = 4096;              ///< pictures with a longer side are halved until they fit; >= 1
  std::vector<std::filesystem::path> allowed_paths;  ///< folders outside the model's that may be read
  std::shared_ptr<Material const> material;          ///< for everything, instead of the model's own; null: these
};

/// An imported model.
struct GltfModel {
  /// One root composite; below it a composite per node, named after it, and a Mesh per primitive. A name that is taken
  /// already gets "#2" and so on behind it. Never without a camera and a light: where the file has none, the scene gets
  /// a camera that shows all of it from the front, slightly above, and a key light, a fill light and an ambient one.
  Scene scene;
  /// Warnings: what was repaired or left out. Each begins with the place in the file, a JSON pointer.
  std::vector<Diagnostic> diagnostics;
};

/// A model that is read once and posed at many times: its files, materials and undeformed geometry are shared.
class GltfAnimation {
 public:
  /// Reads what import_gltf reads, with the same exceptions. options.time_seconds plays no role.
  explicit GltfAnimation(std::filesystem::path const& path, GltfOptions const& options = {});
  ~GltfAnimation();
  GltfAnimation(GltfAnimation&&) noexcept;
  GltfAnimation& operator=(GltfAnimation&&) noexcept;

  /// The time of the last key frame of options.animation; 0 without an animation.
  double duration_seconds();
  /// The model at that time; nothing: as the nodes stand in the file. The first call's diagnostics are about the model,
  /// later ones' about that pose. Same exceptions as import_gltf.
  GltfModel pose(std::optional<double> time_seconds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether `path` ends in .gltf or .glb, in any case.
bool is_gltf_file(std::filesystem::path const& path);

/// Reads a glTF 2.0 model, .gltf or .glb, with all it refers to in its folder or below. Only what cannot be drawn is
/// left out; docs/GLTF.md lists what is supported. Throws Error{no_input}, Error{io}, or SceneError when the file is no
/// glTF 2 or nothing in it can be drawn, with everything found, and Error{usage} for an unknown scene or animation.
GltfModel import_gltf(std::filesystem::path const& path, GltfOptions const& options = {});

/// The scene alone.
Scene load_gltf(std::filesystem::path const& path, GltfOptions const& options = {});

}  // namespace lichtraum
