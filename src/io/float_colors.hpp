#pragma once

#include <fmt/format.h>

#include <string>

namespace lichtraum {

/// What is white among colours that should go from 0 to 1, of which this is the largest number: some programs write
/// bytes, or numbers of 16 bits, and colours of vertices that are meant to be twice as bright as white are unheard of.
inline float white_of(float largest) { return largest > 255 ? 65535.0f : largest > 2 ? 255.0f : 1.0f; }

/// That they were read so. `which`: "OBJ's".
inline std::string read_to_white(float largest, std::string const& which) {
  return fmt::format("colours of vertices go up to {:g}: read as 0 to {:g}, though {} go from 0 to 1", largest,
                     white_of(largest), which);
}

}  // namespace lichtraum
