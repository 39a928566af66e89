#include "bindings.hpp"

namespace nb = nanobind;

NB_MODULE(_native, module) {
  module.doc() = "What lichtraum's Python package is made of: use the names of the package itself.";
  nb::set_leak_warnings(false);  // arrays that live as long as the interpreter are none
  module.attr("version") = LICHTRAUM_VERSION;
  lichtraum::python::bind_errors(module);
  lichtraum::python::bind_picture(module);
  lichtraum::python::bind_drawing(module);
  lichtraum::python::bind_editing(module);
}
