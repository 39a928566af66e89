#pragma once

#include <fmt/format.h>

#include <string>

namespace lichtraum {

/// The number for white among colours that should go from 0 to 1 and go up to `largest`: some programs write bytes, or
/// numbers of 16 bits, but none colours twice as bright as white.
inline float white_of(float largest) { return largest > 255 ? 65535.0f : largest > 2 ? 255.0f : 1.0f; }

/// The warning that they were read so. `which`: those that should, "OBJ's".
inline std::string read_to_white(float largest, std::string const& which) {
  return fmt::format("colours go up to {:g}: read as 0 to {:g}, though {} go from 0 to 1", largest, white_of(largest),
                     which);
}

}  // namespace lichtraum
