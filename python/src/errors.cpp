#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>

#include "bindings.hpp"
#include "lichtraum/error.hpp"

namespace nb = nanobind;

namespace lichtraum::python {
namespace {

/// What pickle stores of a diagnostic, in the order of its members.
using State =
    std::tuple<int, int, std::string, std::size_t, std::size_t, std::size_t, std::string, std::string, std::string>;

/// Of lichtraum._errors.
char const* class_for(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "UsageError";
    case ErrorKind::scene:
      return "SceneError";
    case ErrorKind::no_input:
    case ErrorKind::cannot_create:
    case ErrorKind::io:
      return "FileError";
    case ErrorKind::no_device:
      return "DeviceError";
    case ErrorKind::unavailable:
    case ErrorKind::internal:
    case ErrorKind::try_again:
    case ErrorKind::interrupted:
      break;
  }
  return "Error";
}

void translate(std::exception_ptr const& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (Error const& error) {
    std::vector<Diagnostic> diagnostics;
    if (auto const* const scene_error = dynamic_cast<SceneError const*>(&error)) {
      diagnostics = scene_error->diagnostics();
    }
    nb::object const type = nb::module_::import_("lichtraum._errors").attr(class_for(error.kind()));
    // No UTF-8: the name of a file may be any bytes.
    auto const text =
        nb::steal<nb::object>(PyUnicode_DecodeUTF8(error.what(), Py_ssize_t(strlen(error.what())), "backslashreplace"));
    nb::object const instance = type(text, nb::cast(std::move(diagnostics)));
    PyErr_SetObject(type.ptr(), instance.ptr());
  } catch (std::invalid_argument const& error) {  // values that the library makes no sense of
    PyErr_SetString(nb::module_::import_("lichtraum._errors").attr("UsageError").ptr(), error.what());
  }
}

}  // namespace

void bind_errors(nb::module_& module) {
  nb::class_<Diagnostic>(module, "Diagnostic", "One finding in a scene or a model.")
      .def_prop_ro(
          "severity", [](Diagnostic const& d) { return severity_text(d.severity); }, "'note', 'warning' or 'error'.")
      .def_prop_ro(
          "file", [](Diagnostic const& d) { return d.location.file; }, "As it was named; empty: of no file.")
      .def_prop_ro(
          "line", [](Diagnostic const& d) { return d.location.line; }, "From 1; 0: the whole file.")
      .def_prop_ro(
          "column", [](Diagnostic const& d) { return d.location.column; }, "In bytes, from 1; 0: the whole line.")
      .def_prop_ro(
          "code", [](Diagnostic const& d) { return code_text(d.code); }, "Its kind, \"E0412\"; empty for none.")
      .def_ro("message", &Diagnostic::message, "What and why.")
      .def_ro("hint", &Diagnostic::hint, "What to do; may be empty.")
      .def_ro("source_line", &Diagnostic::source_line, "The line as written; may be empty.")
      .def("__getstate__",
           [](Diagnostic const& d) {
             return State(int(d.severity), int(d.code), d.location.file, d.location.line, d.location.column, d.length,
                          d.message, d.source_line, d.hint);
           })
      .def("__setstate__",
           [](Diagnostic& d, State const& state) {
             auto const& [severity, code, file, line, column, length, message, source_line, hint] = state;
             new (&d) Diagnostic{
                 Severity(severity), DiagnosticCode(code), {file, line, column}, length, message, source_line, hint};
           })
      .def("__str__", [](Diagnostic const& d) { return format_diagnostic(d); })
      .def("__repr__", [](Diagnostic const& d) {
        return "<" + std::string(severity_text(d.severity)) + " " + d.location.file + ":" +
               std::to_string(d.location.line) + ":" + std::to_string(d.location.column) + ": " + d.message + ">";
      });
  nb::register_exception_translator(translate);
}

}  // namespace lichtraum::python
