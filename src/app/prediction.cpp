#include "app/prediction.hpp"

#include <algorithm>
#include <iterator>

#include "app/diagnostics_of.hpp"
#include "app/exit_code.hpp"

namespace lichtraum::app {
namespace {

void add(std::vector<Diagnostic>& all, std::vector<Diagnostic> more) {
  std::ranges::move(more, std::back_inserter(all));
}

void fail(Prediction& prediction, Error const& error) {
  prediction.exit_code = exit_code(error.kind());
  prediction.pictures.clear();
  add(prediction.diagnostics, diagnostics_of(error));
}

}  // namespace

void predict(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
             Renderer& renderer, std::function<void(Prediction const&)> const& tell) {
  Denoiser denoiser([&renderer](NoisyPicture const& picture) { return renderer.filter_noise(picture); });
  PlanFindings plan_findings(options, inputs.size());
  PictureFindings picture_findings(renderer, options);
  SceneLoader loader(inputs, options, names, renderer, denoiser);
  for (std::string const& input : inputs) {
    Prediction prediction;
    prediction.file = input;
    auto& diagnostics = prediction.diagnostics;
    auto& pictures = prediction.pictures;
    int& code = prediction.exit_code;
    for (bool is_open = true; is_open;) {
      auto const message = loader.next();
      if (!message) continue;
      try {
        if (auto const* const opened = std::get_if<SceneOpened>(&*message)) {
          diagnostics = opened->diagnostics;
          pictures = opened->plans;
          add(diagnostics, plan_findings.next(*opened));
          picture_findings.begin(*opened);
        } else if (auto const* const ready = std::get_if<PictureReady>(&*message)) {
          if (code == 0) add(diagnostics, picture_findings.predicted(*ready, pictures.at(ready->number)));
        } else {
          is_open = false;
          if (auto const failure = std::get<SceneClosed>(*message).failure) std::rethrow_exception(failure);
        }
      } catch (Error const& error) {
        if (error.kind() == ErrorKind::internal) throw;
        if (code == 0) fail(prediction, error);
      }
    }
    tell(prediction);
  }
}

}  // namespace lichtraum::app
