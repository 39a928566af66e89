#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "control.hpp"
#include "lichtraum/job.hpp"
#include "source_files.hpp"

namespace lichtraum::python {

/// A picture that was drawn, with all that its files need.
struct Picture {
  Job job;  ///< with everything decided
  RenderRequest request;
  Development development;
  SourceFiles files;
  PreparedScene scene;   ///< only what its fingerprint needs
  Film film;             ///< as traced
  Image developed;       ///< what files of pictures show
  std::string denoiser;  ///< that took the noise out of it; may be empty
  bool is_complete = true;
  RenderStatistics statistics;
  std::vector<Diagnostic> diagnostics;  ///< what was found while it was drawn
  DeviceInfo device;

  /// Height x width x 3: linear, without noise, before exposure and tone map. Empty without radiance.
  std::vector<float> radiance;
  /// The planes that were asked for.
  std::map<FilmPlane, std::vector<float>> planes;

  /// Throws Error{usage} for what the format cannot hold. `shown`: the file, for messages.
  void check_format(ImageFormat const& format, ValueEncoding const& encoding, std::string const& shown) const;
  /// The bytes of its file, which are those that `lichtraum render` writes.
  std::string encoded(ImageFormat const& format, ValueEncoding const& encoding) const;
};

/// Draws `job` of `scene` as `lichtraum render` does. `previous`: a scene that the renderer prepared, or null; then the
/// one that was drawn. When it is told to stop, the picture is not complete.
Picture draw(Renderer& renderer, Scene const& scene, bool is_model, Job job,
             std::shared_ptr<PreparedScene const>& previous, Control& control);

}  // namespace lichtraum::python
