#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/render_options.hpp"
#include "app/scene_source.hpp"

namespace lichtraum::app {

/// One picture of a scene, everything decided and checked before anything is drawn.
struct PicturePlan {
  std::size_t scene_number = 0;        ///< which of the scenes that LoadedScene::play shows
  std::optional<double> time_seconds;  ///< of a model's animation
  double turn_degrees = 0;             ///< how far the camera is carried around the scene
  std::string camera;
  Output output;
  ImageEncoding encoding;
  Resolution size;
  Region region;
  Sampling sampling;
  PlaneSet planes;
  int depth = 0;
};

/// A plan for each `render` of the script (or each time of a model), in order; for a script without any, one of its
/// only (or first) camera; for a turntable, as many as that has for each of these. What the command line says wins over
/// the render statement, that over the camera, that over the scene's defaults, those over 640x480, one sample a pixel
/// and depth 5. Throws Error{usage}, Error{scene} and Error{cannot_create}, the last when a file could not be written.
/// The pictures of a film must have one size.
std::vector<PicturePlan> plan_pictures(LoadedScene const& script, SceneSource const& source,
                                       RenderOptions const& options, OutputNames& names);

/// What is seen of a scene at its end before anyone chose a picture: through --camera, else the camera of its first
/// `render`, else its first camera; in the size that a picture of it would have, one sample a pixel unless --samples
/// says more. Throws Error{usage} and Error{scene}.
RenderRequest first_view(LoadedScene const& loaded, SceneSource const& source, RenderOptions const& options);

/// How pictures of the scene are developed.
Development choose_development(Scene const& scene, bool is_model, RenderOptions const& options);

/// Throws Error{`kind`} with the numbers when a picture of that size needs more memory than the machine has.
void check_memory(Region const& region, PlaneSet const& planes, int sample_count, ErrorKind kind);

}  // namespace lichtraum::app
