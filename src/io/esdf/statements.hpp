#pragma once

#include <span>
#include <string_view>

#include "io/esdf/arguments.hpp"

namespace lichtraum::esdf {

class Interpreter;

// One function per statement. Each reports what is wrong and then leaves the scene as it was.
void define_material(Interpreter& interpreter, Statement const& statement);
void define_shape(Interpreter& interpreter, Statement const& statement);
void define_light(Interpreter& interpreter, Statement const& statement);
void define_ambient(Interpreter& interpreter, Statement const& statement);
void define_camera(Interpreter& interpreter, Statement const& statement);
void define_background(Interpreter& interpreter, Statement const& statement);
void define_filename(Interpreter& interpreter, Statement const& statement);
void define_resolution(Interpreter& interpreter, Statement const& statement);
void transform(Interpreter& interpreter, Statement const& statement);
void render(Interpreter& interpreter, Statement const& statement);

using Execute = void (*)(Interpreter& interpreter, Statement const& statement);

/// One row of a table of keywords.
struct Keyword {
  std::string_view word;
  Execute execute;
  bool is_standard = true;  ///< else a dialect, which options.strict refuses
};

/// What starts a line, except `define`.
std::span<Keyword const> commands();
/// What may follow `define`.
std::span<Keyword const> classes();
/// What may follow `define shape`.
std::span<Keyword const> shape_kinds();

Keyword const* find_keyword(std::span<Keyword const> keywords, Token word);

}  // namespace lichtraum::esdf
