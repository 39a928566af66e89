#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/picture_plan.hpp"
#include "farm/plan.hpp"

namespace lichtraum::app {

/// What the command line of `lichtraum job plan` says becomes a plan: reads the scenes, draws nothing. `device`: of
/// the pictures. Throws Error{usage} for pictures of several sizes.
farm::Plan make_plan(RenderOptions& options, std::vector<std::string> const& inputs, farm::DeviceClass const& device,
                     std::string const& traversal, Console const& console);

/// What `lichtraum render` would have been told for the plan's pictures, and the scenes in `inputs`.
RenderOptions options_of(farm::Plan const& plan, std::vector<std::string>& inputs);

}  // namespace lichtraum::app
