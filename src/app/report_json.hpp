#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lichtraum/device.hpp"
#include "lichtraum/error.hpp"

/// What the JSON of several commands has in common; docs/JSON.md describes all of it.

namespace lichtraum::app {

nlohmann::ordered_json json_of(std::vector<Diagnostic> const& diagnostics);
/// What tells which device it was.
nlohmann::ordered_json json_of(DeviceInfo const& device);

/// As it is printed: indented, with a line break at the end. What is not UTF-8, as names of files need not be, is
/// replaced.
std::string printed(nlohmann::ordered_json const& json);

}  // namespace lichtraum::app
