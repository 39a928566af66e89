#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "io/esdf/interpreter.hpp"
#include "io/esdf/statements.hpp"

// transform <object> translate [offset]
// transform <object> rotate <angle> [axis]      dialects: rotate <angle> x|y|z, rotate [euler]
// transform <object> scale <s>                  dialect: scale [s]

namespace lichtraum::esdf {
namespace {

/// What a statement does, as steps that happen one after the other.
using Steps = std::vector<Transform>;
using Operands = std::span<Token const>;

constexpr std::string_view operations[] = {"translate", "rotate", "scale"};

bool is_operation(Token word) { return std::ranges::find(operations, word) != std::end(operations); }

double sense(Interpreter const& interpreter) { return interpreter.options.rotation == RotationSense::left ? -1 : 1; }

Transform rotation(Interpreter const& interpreter, double degrees, Vec3 const& axis) {
  return Transform::rotation(sense(interpreter) * degrees, axis);
}

/// Too few or too many operands; one operation a line.
std::optional<Steps> refuse_count(Interpreter& interpreter, Token operation, Operands operands, std::size_t most,
                                  std::string_view expected) {
  bool const too_many = operands.size() > most;
  std::string_view hint = "";
  for (Token const token : operands) {
    if (is_operation(token)) hint = "write one operation per line";
  }
  interpreter.error(
      Code::wrong_count,
      too_many ? span_of(operands[most], operands.back()) : place_after(operands.empty() ? operation : operands.back()),
      fmt::format("{}: expected {}, found {} argument{}", operation, expected, operands.size(),
                  operands.size() == 1 ? "" : "s"),
      std::string(hint));
  return std::nullopt;
}

std::optional<Steps> read_translate(Interpreter& interpreter, Token operation, Operands operands) {
  if (operands.size() != 3) return refuse_count(interpreter, operation, operands, 3, "3 numbers");
  auto const offset = read_vec3(interpreter, operands);
  if (!offset) return std::nullopt;
  return Steps{Transform::translation(*offset)};
}

std::optional<Steps> read_rotate_about_letter(Interpreter& interpreter, Operands operands) {
  constexpr std::string_view letters = "xyz";
  auto const index_of = [&](Token word) { return word.size() == 1 ? letters.find(word[0]) : std::string_view::npos; };
  std::size_t const index = index_of(operands[1]);
  if (index == std::string_view::npos) {
    interpreter.error(Code::unknown_axis, operands[1],
                      fmt::format("rotate: expected an axis, found {}", in_quotes(operands[1])),
                      index_of(operands[0]) == std::string_view::npos
                          ? "three numbers, or one of x, y and z"
                          : fmt::format("the angle comes first: rotate {} {}", operands[1], operands[0]));
    return std::nullopt;
  }
  auto const angle = read_number(interpreter, operands[0]);
  if (!interpreter.dialect(operands[1], "an axis as a letter") || !angle) return std::nullopt;
  Vec3 axis(0);
  axis[static_cast<glm::length_t>(index)] = 1;
  return Steps{rotation(interpreter, *angle, axis)};
}

/// Whether the first three numbers are the axis x, y or z, and the last is no part of such a one.
bool seems_axis_first(std::array<double, 4> const& v) {
  double const length = std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
  double const largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  return length == 1 && largest == 1 && std::abs(v[3]) > 1;
}

std::optional<Steps> read_rotate(Interpreter& interpreter, Token operation, Operands operands) {
  if (operands.size() == 2) return read_rotate_about_letter(interpreter, operands);
  if (operands.size() == 3) {
    auto const degrees = read_vec3(interpreter, operands);
    Token const at = span_of(operands.front(), operands.back());
    if (!interpreter.dialect(at, "a rotation about x, y and z in one") || !degrees) return std::nullopt;
    return Steps{rotation(interpreter, degrees->x, Vec3(1, 0, 0)), rotation(interpreter, degrees->y, Vec3(0, 1, 0)),
                 rotation(interpreter, degrees->z, Vec3(0, 0, 1))};
  }
  if (operands.size() != 4)
    return refuse_count(interpreter, operation, operands, 4, "an angle and an axis (4 numbers)");
  std::array<double, 4> v{};
  if (!read_numbers(interpreter, operands, v)) return std::nullopt;
  Vec3 const axis(v[1], v[2], v[3]);
  if (axis == Vec3(0)) {
    interpreter.error(Code::zero_direction, span_of(operands[1], operands[3]), "rotate: the axis must not be zero");
    return std::nullopt;
  }
  if (seems_axis_first(v)) {
    interpreter.warning(
        Code::axis_before_angle, span_of(operands[0], operands[3]),
        fmt::format("rotate: the angle is {} and the axis {}", operands[0], span_of(operands[1], operands[3])),
        fmt::format("the angle comes first: rotate {} {}", operands[3], span_of(operands[0], operands[2])));
  }
  return Steps{rotation(interpreter, v[0], axis)};
}

std::optional<Steps> read_scale(Interpreter& interpreter, Token operation, Operands operands) {
  if (operands.size() != 1 && operands.size() != 3) {
    return refuse_count(interpreter, operation, operands, operands.size() == 2 ? 1 : 3,
                        interpreter.options.strict ? "1 number" : "1 or 3 numbers");
  }
  std::array<double, 3> v{};
  bool good = read_numbers(interpreter, operands, v);
  if (operands.size() == 3) {
    good &= interpreter.dialect(span_of(operands.front(), operands.back()), "a scale per axis");
  } else {
    v = {v[0], v[0], v[0]};
  }
  for (std::size_t i = 0; good && i < operands.size(); ++i) {
    if (std::isfinite(1 / v[i])) continue;
    interpreter.error(Code::zero_scale, operands[i],
                      v[i] == 0 ? "scale: a factor must not be 0"
                                : fmt::format("scale: the factor {} is too small", in_quotes(operands[i])),
                      "it would make the object flat");
    good = false;
  }
  if (!good) return std::nullopt;
  return Steps{Transform::scaling(Vec3(v[0], v[1], v[2]))};
}

/// Whether the operation stands where the object should, which is then reported.
bool report_operation_first(Interpreter& interpreter, Statement const& statement) {
  if (!is_operation(statement[0]) || is_operation(statement[1])) return false;
  interpreter.error(Code::unknown_transform, span_of(statement[0], statement[1]),
                    fmt::format("transform: {} stands before the object", in_quotes(statement[0])),
                    fmt::format("write transform {} {}", statement[1], statement[0]));
  return true;
}

std::optional<Steps> read_steps(Interpreter& interpreter, Statement const& statement) {
  Token const operation = statement[1];
  Operands const operands = statement.arguments.subspan(2);
  if (operation == "translate") return read_translate(interpreter, operation, operands);
  if (operation == "rotate") return read_rotate(interpreter, operation, operands);
  if (operation == "scale") return read_scale(interpreter, operation, operands);
  std::string hint = interpreter.suggest(operation, operations);
  if (hint.empty()) hint = "translate, rotate or scale";
  interpreter.error(Code::unknown_transform, operation,
                    fmt::format("transform: unknown operation {}", in_quotes(operation)), std::move(hint));
  return std::nullopt;
}

bool is_finite(Mat4 const& matrix) {
  for (glm::length_t column = 0; column < 4; ++column) {
    for (glm::length_t row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

/// `world` after `steps`, in the order that the options ask for.
Transform composed(Interpreter const& interpreter, Transform world, Steps const& steps) {
  bool const in_parent = interpreter.options.transform_order == TransformOrder::parent;
  for (Transform const& step : steps) world = in_parent ? step * world : world * step;
  return world;
}

}  // namespace

void transform(Interpreter& interpreter, Statement const& statement) {
  if (statement.size() < 2) {
    interpreter.error(Code::wrong_count, place_after(statement.last()),
                      fmt::format("transform: expected an object and an operation, found {}",
                                  statement.size() == 0 ? "nothing" : "no operation"),
                      "translate, rotate or scale");
    return;
  }
  if (report_operation_first(interpreter, statement)) return;
  Token const name = statement[0];
  Scene& scene = interpreter.scene;
  auto* const shape = scene.shapes.find(name);
  Camera* const camera = shape ? nullptr : scene.cameras.find(name);
  if (shape && scene.cameras.contains(name)) {
    interpreter.warning(Code::shape_and_camera, name,
                        fmt::format("{} is both a shape and a camera: the shape is transformed", in_quotes(name)));
  }
  if (!shape && !camera && !interpreter.is_faulty(Kind::shape, name) && !interpreter.is_faulty(Kind::camera, name)) {
    if (interpreter.is_light(name) || interpreter.is_faulty(Kind::light, name)) {
      interpreter.error(Code::transformed_light, name,
                        fmt::format("{} is a light: only shapes and cameras can be transformed", in_quotes(name)),
                        scene.environment && scene.environment->name == name
                            ? "rotation=<degrees> in its definition turns it"
                            : "set the light's position in its definition");
    } else {
      interpreter.report_undefined(Code::undefined_object, "shape or camera", {Kind::shape, Kind::camera}, name,
                                   scene.shapes, scene.cameras);
    }
  }

  auto const steps = read_steps(interpreter, statement);
  if (!steps || (!shape && !camera)) return;
  Transform const& before = shape ? (*shape)->world_from_object() : camera->world_from_camera();
  Transform const after = composed(interpreter, before, *steps);
  if (!is_finite(after.matrix()) || !is_finite(after.inverse_matrix())) {
    interpreter.error(Code::transforms_too_large, statement.rest(1),
                      fmt::format("the transforms of {} exceed the range of numbers", in_quotes(name)));
  } else if (shape) {
    (*shape)->set_world_from_object(after);
  } else {
    camera->set_world_from_camera(after);
    interpreter.tell(EsdfStatement::Kind::camera_transform, name);
  }
}

}  // namespace lichtraum::esdf
