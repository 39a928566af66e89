#pragma once

#include <string>
#include <vector>

#include "app/picture_plan.hpp"

namespace lichtraum::app {

/// What was measured of one picture.
struct PictureReport {
  PicturePlan plan;
  std::string written_to;  ///< empty when nothing was written
  bool is_complete = false;
  bool is_skipped = false;  ///< with --resume: it was there already
  double load_ms = 0;       ///< bringing the scene to where it is in this picture
  SceneStatistics scene;
  RenderStatistics render;
  int samples = 0;              ///< per pixel that were taken; 0: none, see is_skipped
  std::optional<double> noise;  ///< that is left, where there is a limit: see render_to_noise
  std::string denoiser;         ///< what took the noise out; empty: nothing
  double denoise_ms = 0;
  double write_ms = 0;  ///< encoding and writing

  double mrays_per_second() const {
    return render.trace_ms > 0 ? double(render.rays.total()) / render.trace_ms * 1e-3 : 0;
  }
};

struct SceneReport {
  std::string file;
  double load_ms = 0;
  std::vector<PictureReport> pictures;
  std::vector<Diagnostic> diagnostics;  ///< in the order in which they were said
  std::string error;                    ///< empty when all went well
  int exit_code = 0;                    ///< of the process, were this its only input
};

struct RunReport {
  DeviceInfo device;
  std::vector<SceneReport> scenes;
  std::string film;  ///< where it is; empty without one
  double total_ms = 0;
};

/// For --json.
std::string to_json(RunReport const& report);

/// "hello.png: 640x480, 3.1 ms, 221 Mrays/s".
std::string summary(PictureReport const& report);
/// Everything that was measured, for --verbose.
std::string details(PictureReport const& report);

}  // namespace lichtraum::app
