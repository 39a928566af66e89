#pragma once

#include <optional>
#include <string>

namespace lichtraum {

/// Whether PoCL might abort the process here: /sys cannot be read, or memory or stack is short.
bool opencl_may_abort();

/// Lists all platforms and devices in a child process. Nothing when the child came back; else how it died, with the
/// last of what it had printed ("it was ended by signal 6 (Aborted): Not enough memory to run on this device.").
std::optional<std::string> probe_opencl_in_child();

}  // namespace lichtraum
