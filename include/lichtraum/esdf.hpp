#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/file_stamp.hpp"
#include "lichtraum/model.hpp"
#include "lichtraum/scene.hpp"

namespace LICHTRAUM_API lichtraum {

enum class TransformOrder {
  parent,  ///< world' = T * world: each transform happens in the parent's frame (the standard)
  local,   ///< world' = world * T: in the object's own frame (about a third of the course's tracers)
};
enum class RotationSense { right, left };
/// What numbers after a material's m mean.
enum class MaterialExtra { reflectance, transmittance, opacity, ior, ignore };

/// Which eSDF a file is written in, and how much of it must be right.
struct EsdfDialect {
  TransformOrder transform_order = TransformOrder::parent;
  RotationSense rotation = RotationSense::right;
  bool strict = false;      ///< the standard and lichtraum's key=value extensions only, no dialects
  bool keep_going = false;  ///< leave faulty statements out instead of failing
  std::vector<MaterialExtra> material_extras{};  ///< empty: extra numbers are ignored with a warning
  friend bool operator==(EsdfDialect const&, EsdfDialect const&) = default;
};

/// A statement that defined something other than a shape, moved a camera, or asked for a picture.
struct EsdfStatement {
  enum class Kind { material, light, environment, camera, camera_transform, render };
  std::size_t line = 0;  ///< from 1
  Kind kind = Kind::material;
  std::string name;  ///< of a render its camera's
};

struct EsdfOptions : EsdfDialect {
  std::vector<std::filesystem::path> allowed_paths{};  ///< folders outside the scene's that may be read
  std::size_t max_diagnostics = 100;
  FileObserver on_read{};                ///< may be empty
  std::shared_ptr<ModelCache> models{};  ///< see make_model_cache; null: each script has one for itself
  /// Where the maps of environments come from: a file's path or "studio". Exceptions as environment_map.
  std::function<std::shared_ptr<EnvironmentMap const>(std::string const&)> find_environment = environment_map;
  /// Changes each scene before it is shown, and then perhaps once more; may be empty.
  std::function<void(Scene&)> adjust{};
  /// Told of each such statement when it is executed, so by `play` once more; may be empty.
  std::function<void(EsdfStatement const&)> on_statement{};
  /// The caller has a size for pictures that have none of their own: a `render` without one is no mistake.
  bool has_size = false;
};

/// A checked eSDF file. eSDF is imperative: a `render` draws the scene as defined up to its line.
class EsdfScript {
 public:
  /// Reads and checks the whole file. Throws Error{no_input}, Error{io}, or SceneError with every problem found
  /// (unless options.keep_going).
  static EsdfScript from_file(std::filesystem::path const& path, EsdfOptions const& options = {});
  /// `name` stands for the file in messages; relative paths are looked up in `folder`.
  static EsdfScript from_text(std::string text, std::string name, EsdfOptions const& options = {},
                              std::filesystem::path const& folder = ".");
  ~EsdfScript();
  EsdfScript(EsdfScript&&) noexcept;
  EsdfScript& operator=(EsdfScript&&) noexcept;

  /// Warnings and notes (with keep_going: errors turned into warnings).
  std::vector<Diagnostic> const& diagnostics() const;
  /// The scene at the end of the file, with all its render commands.
  Scene const& scene() const;
  /// From now on `scene` is as the first `render` draws it, with what shows nothing by itself of the rest of the file:
  /// its cameras, its materials, and its render commands. Nothing changes in a file without `render`.
  void rewind();
  /// Moves that scene out.
  Scene take_scene() &&;

  /// Calls `draw` once for each `render` statement, in order, with the scene as defined up to it. Shapes keep their
  /// addresses from one call to the next. `draw` returns false to stop. A file without `render` gets no call.
  void play(std::function<bool(Scene const&, RenderCommand const&)> const& draw) const;

 private:
  struct State;
  explicit EsdfScript(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The scene at the end of the file. Same exceptions as EsdfScript::from_file.
Scene load_esdf(std::filesystem::path const& path, EsdfOptions const& options = {});

}  // namespace lichtraum
