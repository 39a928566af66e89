#include <nlohmann/json.hpp>

#include "app/prediction.hpp"
#include "app/report_json.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::app {
namespace {

using Json = nlohmann::ordered_json;

Json picture_json(PicturePlan const& plan) {
  Job const& job = plan.job;
  Region const& region = *job.region;
  return {{"output", plan.output.shown},
          {"format", plan.output.format->name},
          {"camera", job.camera},
          {"width", region.width},
          {"height", region.height},
          {"integrator", find_word<Integrator>(integrator_words, *job.integrator)},
          {"integrator_reason", plan.integrator_reason},
          {"samples", job.sampling->count},
          {"depth", *job.max_depth},
          {"line", plan.location.line > 0 ? Json(plan.location.line) : Json()}};
}

}  // namespace

std::string to_json(std::vector<Prediction> const& predictions, DeviceInfo const& device) {
  Json scenes = Json::array();
  for (Prediction const& prediction : predictions) {
    Json pictures = Json::array();
    for (PicturePlan const& plan : prediction.pictures) pictures.push_back(picture_json(plan));
    scenes.push_back({{"file", prediction.file},
                      {"exit_status", prediction.exit_code},
                      {"diagnostics", json_of(prediction.diagnostics)},
                      {"pictures", pictures}});
  }
  return printed({{"lichtraum", LICHTRAUM_VERSION}, {"device", json_of(device)}, {"scenes", scenes}});
}

}  // namespace lichtraum::app
