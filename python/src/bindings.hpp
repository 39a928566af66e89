#pragma once

#include <nanobind/nanobind.h>

/// What the module `lichtraum._native` is made of: each adds its classes and functions.

namespace lichtraum::python {

void bind_errors(nanobind::module_& module);
void bind_picture(nanobind::module_& module);
void bind_drawing(nanobind::module_& module);
void bind_editing(nanobind::module_& module);

}  // namespace lichtraum::python
