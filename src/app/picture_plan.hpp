#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/render_options.hpp"
#include "app/scene_source.hpp"

namespace lichtraum::app {

/// One picture of a scene, everything decided and checked before anything is drawn.
struct PicturePlan {
  SourceLocation location;             ///< of the `render` that asks for it, else the file
  std::size_t scene_number = 0;        ///< which of the scenes that LoadedScene::play shows
  Job job;                             ///< decided (see `resolved`), without the text of standard input
  std::string_view integrator_reason;  ///< see IntegratorChoice
  Output output;
  std::string fingerprint;  ///< for the file, once it is known; empty: none
};

/// A plan for each `render` of the script (or each time of a model), in order; for a script without any, one of its
/// only (or first) camera; for a turntable, as many as that has for each of these. Throws Error{usage}, Error{scene}
/// and Error{cannot_create}, the last when a file could not be written. The pictures of a film must have one size.
std::vector<PicturePlan> plan_pictures(LoadedScene const& script, SceneSource const& source,
                                       RenderOptions const& options, OutputNames& names);

/// What to trace for it. `scene`: as it is in the picture. `turn_center`: found with the first picture of the scene
/// that is turned. Throws as request_of does, and Error{usage} for a camera that is defined later.
RenderRequest request_for(PicturePlan const& plan, Scene const& scene, std::optional<Vec3>& turn_center);

/// Throws Error{usage} when the output's format cannot hold the picture of `job`, in which everything is decided.
void check_format(Job const& job, Output const& output);

/// Throws Error{`kind`} with the numbers when a picture of that size needs more memory than the machine has.
void check_memory(Region const& region, PlaneSet const& planes, int sample_count, ErrorKind kind,
                  bool is_denoised = false);

}  // namespace lichtraum::app
