#pragma once

#include <cstdint>
#include <string>

namespace lichtraum {

/// What this process may use, in bytes: what the machine has, or its control group's limit (a container's, a batch
/// job's) where that is less.
std::uint64_t usable_memory_bytes();

/// "25.3 GB", three digits and a unit.
std::string bytes_text(double bytes);

}  // namespace lichtraum
