#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/picture_findings.hpp"
#include "app/plan_findings.hpp"

namespace lichtraum::app {

/// What drawing one input would come to.
struct Prediction {
  std::string file;                     ///< as the command line names it
  std::vector<Diagnostic> diagnostics;  ///< in the order in which render says them
  std::vector<PicturePlan> pictures;    ///< that would be written; none where `exit_code` is not 0
  int exit_code = 0;                    ///< that render would end with, were this its only input
};

/// Does for all inputs what draw_sequence does, by the same code, but trace and write. `tell` gets the prediction of
/// each, in order.
void predict(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
             Renderer& renderer, std::function<void(Prediction const&)> const& tell);

/// For check --json.
std::string to_json(std::vector<Prediction> const& predictions, DeviceInfo const& device);

}  // namespace lichtraum::app
