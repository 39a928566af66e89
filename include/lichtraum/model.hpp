#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/file_stamp.hpp"
#include "lichtraum/scene.hpp"

namespace LICHTRAUM_API lichtraum {

/// Keeps models that scenes include from being read again for each scene.
class ModelCache;
std::shared_ptr<ModelCache> make_model_cache();

/// Which of a model's scenes is wanted, in which variant, when, and how fine.
struct ModelChoice {
  int max_texture = 4096;  ///< pictures with a longer side are halved until they fit; >= 1
  /// The diameter of points, in thousandths of the diagonal of the box around the model, > 0; nothing: by how many
  /// there are.
  std::optional<double> point_size;

  // Only glTF models have several scenes, move, and have surfaces without a back; for others these have no effect but a
  // warning.
  std::string variant;                 ///< index or name of the materials' variant; empty: as the meshes are
  std::string scene;                   ///< index or name of the scene to import; empty: the file's default one
  std::optional<double> time_seconds;  ///< pose of the animation at that time; nothing: as the nodes stand in the file
  std::string animation;               ///< index or name of the animation that `time_seconds` is for; empty: the first
  bool both_sides = false;             ///< paths' cameras see the backs of single-sided surfaces as well
  friend bool operator==(ModelChoice const&, ModelChoice const&) = default;
};

struct ModelOptions : ModelChoice {
  std::vector<std::filesystem::path> allowed_paths;  ///< folders outside the model's that may be read
  std::shared_ptr<Material const> material;          ///< for everything, instead of the model's own; null: these
  FileObserver on_read;                              ///< may be empty
  /// True for a part of a scene whose own materials are Phong's: those of an OBJ model stay Phong's then, too
  /// (docs/MODELS.md).
  bool is_part_of_scene = false;
};

/// What only glTF models have, as far as it is not in the scene.
struct ModelContents {
  struct Extension {
    std::string name;
    bool is_required = false;
    std::string support;  ///< what is done with it, in a few words; empty: it is not supported
  };
  struct Animation {
    std::string name;
    double seconds = 0;  ///< its last key frame's time
  };
  std::vector<Extension> extensions;  ///< used ones
  std::vector<Animation> animations;
  std::optional<std::size_t> animation;  ///< which of them poses are of
  std::vector<std::string> scenes;
  std::vector<std::string> variants;  ///< of materials
};

/// An imported model.
struct Model {
  /// One root composite; below it what the file's parts are called, and Mesh shapes. A name that is taken already gets
  /// "#2" and so on after it. Never without a camera and a light: where the file has none, the scene gets a camera
  /// that shows all of it from the front, slightly above, and a key light, a fill light and an ambient one.
  Scene scene;
  /// Warnings: what was repaired or left out, each with its place in the file.
  std::vector<Diagnostic> diagnostics;
  ModelContents contents;
  /// What was taken off all places in a model that lies far from the origin compared with its size, so that single
  /// precision tells its vertices apart; else 0.
  Vec3 origin{0};
};

/// Whether `path` ends like a model that can be imported: .gltf, .glb, .obj, .ply or .stl, in any case.
bool is_model_file(std::filesystem::path const& path);

/// Reads a model of the format that its name tells, with all it refers to in its folder or below. Only what cannot be
/// drawn is left out; docs/MODELS.md and docs/GLTF.md list what is supported. Throws Error{usage} for a file that is no
/// model by its name, Error{no_input}, Error{io}, or SceneError, with everything found, when nothing in it can be
/// drawn.
Model import_model(std::filesystem::path const& path, ModelOptions const& options = {});

/// The same from the bytes of a file that lies in no folder. `name` tells the format, and stands for the file in
/// messages. Other files that the model names are left out.
Model import_model_bytes(std::string bytes, std::string const& name, ModelOptions const& options = {});

/// The formats of models, each by how its files end, without the dot: "gltf", "glb", "obj" ...
std::vector<std::string_view> model_formats();

/// One of those that bytes tell: "glb", "obj", "ply" or "stl"; empty where they may be anything else.
std::string_view model_format_of(std::string_view bytes);

/// The scene alone.
Scene load_model(std::filesystem::path const& path, ModelOptions const& options = {});

}  // namespace lichtraum
