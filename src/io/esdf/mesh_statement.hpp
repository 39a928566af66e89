#pragma once

#include "io/esdf/arguments.hpp"

namespace lichtraum::esdf {

void define_mesh(Interpreter& interpreter, Statement const& statement);
void define_obj(Interpreter& interpreter, Statement const& statement);

}  // namespace lichtraum::esdf
