#pragma once

#include <optional>
#include <string>

namespace lichtraum {

/// Whether something is missing that makes PoCL abort its process: a readable /sys, or memory.
bool is_opencl_suspicious();

/// Lists all platforms and devices in a child process. Nothing when the child came back; else how it died, with the
/// last of what it had printed ("it was ended by signal 6 (Aborted): Not enough memory to run on this device.").
std::optional<std::string> opencl_kills_a_child();

}  // namespace lichtraum
