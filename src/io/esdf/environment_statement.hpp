#pragma once

#include "io/esdf/arguments.hpp"

namespace lichtraum::esdf {

/// `statement` starts with the light's name.
void define_environment(Interpreter& interpreter, Statement const& statement);

}  // namespace lichtraum::esdf
