#pragma once

#include "io/text/diagnostics.hpp"

namespace lichtraum {

/// Reads the whole of a word, a part of the current line, as a number that fits a float; else false after a warning at
/// its place.
bool read_number(Token word, double& value, Diagnostics& diagnostics);

/// The same for data, where 'nan' and 'inf' are written for what was not measured: these become a NaN, without a
/// warning.
bool read_number_or_nan(Token word, double& value, Diagnostics& diagnostics);

}  // namespace lichtraum
