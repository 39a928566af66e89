#include <fmt/format.h>

#include <array>

#include "io/esdf/color_range.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/statements.hpp"

// Statements that set one value of the whole scene:
// define background [rgb], define backgroundcolor [rgb]
// Dialects: define filename <file>, define resolution <x-res> <y-res>

namespace lichtraum::esdf {
namespace {

/// Reports any other number of arguments than `count`.
bool has_arguments(Interpreter& interpreter, Statement const& statement, std::size_t count, std::string_view expected) {
  if (statement.size() == count) return true;
  interpreter.error(Code::wrong_count, statement.size() > count ? statement.rest(count) : place_after(statement.last()),
                    fmt::format("{}: expected {}, found {} argument{}", statement.what, expected, statement.size(),
                                statement.size() == 1 ? "" : "s"));
  return false;
}

}  // namespace

void define_background(Interpreter& interpreter, Statement const& statement) {
  if (!has_arguments(interpreter, statement, 3, "3 numbers")) return;
  std::array<double, 3> v{};
  if (!read_numbers(interpreter, statement.arguments, v)) return;
  check_color(interpreter, statement.arguments, v, "background", largest_share);
  interpreter.scene.background = {v[0], v[1], v[2]};
}

void define_filename(Interpreter& interpreter, Statement const& statement) {
  if (has_arguments(interpreter, statement, 1, "a file name")) interpreter.scene.filename = statement[0];
}

void define_resolution(Interpreter& interpreter, Statement const& statement) {
  if (!has_arguments(interpreter, statement, 2, "2 numbers")) return;
  if (auto const resolution = read_resolution(interpreter, statement[0], statement[1])) {
    interpreter.scene.resolution = resolution;
  }
}

}  // namespace lichtraum::esdf
