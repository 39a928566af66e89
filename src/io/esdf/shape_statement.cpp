#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/ascii.hpp"
#include "core/parse_number.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/mesh_statement.hpp"
#include "io/esdf/statements.hpp"
#include "lichtraum/shapes.hpp"

// define shape sphere <name> [center] <radius> <material>
// define shape box <name> [p1] [p2] <material>
// define shape triangle <name> [a] [b] [c] <material>
// define shape cylinder <name> [p1] [p2] <radius> <material>
// define shape cone <name> [base] [tip] <radius> <material>
// define shape plane <name> [point] [normal] <material>
// define shape composite <name> <child> ...

namespace lichtraum::esdf {
namespace {

Signature const sphere_signature{{{"the center", 3}, {"the radius", 1}}, true};
Signature const box_signature{{{"p1", 3}, {"p2", 3}}, true};
Signature const triangle_signature{{{"a", 3}, {"b", 3}, {"c", 3}}, true};
Signature const cylinder_signature{{{"p1", 3}, {"p2", 3}, {"the radius", 1}}, true, {5}};
Signature const cone_signature{{{"the base", 3}, {"the tip", 3}, {"the radius", 1}}, true, {5}};
Signature const plane_signature{{{"the point", 3}, {"the normal", 3}}, true};

/// Name, N numbers, material: the numbers. Reports what is wrong.
template <std::size_t N>
bool read_primitive(Interpreter& interpreter, Statement const& statement, Signature const& signature,
                    std::array<double, N>& values) {
  if (statement.size() == N + 2 && looks_like_number(statement.last()) && !looks_like_number(statement[1]) &&
      interpreter.scene.materials.contains(statement[1])) {
    interpreter.error(Code::material_first, statement[1],
                      fmt::format("{}: {} is not a number", statement.what, in_quotes(statement[1])),
                      "the material is the last argument");
    interpreter.mark_faulty(Kind::shape, statement[0]);
    return false;
  }
  if (statement.size() == N + 2 && read_numbers(interpreter, statement.arguments.subspan(1, N), values)) return true;
  if (statement.size() != N + 2) report_wrong_count(interpreter, statement, signature);
  if (statement.size() > 0) interpreter.mark_faulty(Kind::shape, statement[0]);
  return false;
}

/// A radius, whose sign does not count. Reports what is wrong with it.
std::optional<double> checked_radius(Interpreter& interpreter, Statement const& statement, Token token, double value) {
  if (value == 0) {
    interpreter.error(Code::zero_size, token, fmt::format("{}: the radius must not be 0", statement.what));
  } else if (value > 0 ||
             interpreter.dialect_warning(Code::negative_radius, token,
                                         fmt::format("{}: the radius {} is negative", statement.what, in_quotes(token)),
                                         interpreter.done_unless_strict("its absolute value is taken"))) {
    return std::abs(value);
  }
  interpreter.mark_faulty(Kind::shape, statement[0]);
  return std::nullopt;
}

void define_sphere(Interpreter& interpreter, Statement const& statement) {
  std::array<double, 4> v{};
  if (!read_primitive(interpreter, statement, sphere_signature, v)) return;
  auto const radius = checked_radius(interpreter, statement, statement[4], v[3]);
  if (!radius) return;
  interpreter.define(statement[0], std::make_shared<Sphere>(std::string(statement[0]), Vec3(v[0], v[1], v[2]), *radius,
                                                            interpreter.material(statement[5])));
}

/// What is round about the line between two points.
struct RoundSolid {
  Vec3 p1, p2;
  double radius;
};

/// Both points and the radius, or in a dialect the first, the radius, and the height above it along y.
std::optional<RoundSolid> read_round_solid(Interpreter& interpreter, Statement const& statement,
                                           Signature const& signature) {
  constexpr std::size_t dialect_numbers = 5;
  std::array<double, 7> v{};
  bool const has_height = statement.size() == dialect_numbers + 2 && looks_like_number(statement[5]);
  if (has_height) {
    std::array<double, dialect_numbers> w{};
    if (!read_primitive(interpreter, statement, signature, w)) return std::nullopt;
    interpreter.dialect(statement.keyword, fmt::format("a {} by its radius and height", statement.what));
    v = {w[0], w[1], w[2], w[0], w[1] + w[4], w[2], w[3]};
  } else if (!read_primitive(interpreter, statement, signature, v)) {
    return std::nullopt;
  }
  RoundSolid const solid{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6]};
  auto const radius = checked_radius(interpreter, statement, statement[has_height ? 4 : 7], solid.radius);
  if (!radius) return std::nullopt;
  if (solid.p1 == solid.p2) {
    auto const* const names = signature.numbers.begin();
    interpreter.error(
        Code::zero_size, statement[has_height ? 5 : 4],
        has_height ? fmt::format("{}: the height must not be 0", statement.what)
                   : fmt::format("{}: {} and {} are the same point", statement.what, names[0].name, names[1].name));
    interpreter.mark_faulty(Kind::shape, statement[0]);
    return std::nullopt;
  }
  return RoundSolid{solid.p1, solid.p2, *radius};
}

void define_cylinder(Interpreter& interpreter, Statement const& statement) {
  auto const solid = read_round_solid(interpreter, statement, cylinder_signature);
  if (!solid) return;
  interpreter.define(statement[0], std::make_shared<Cylinder>(std::string(statement[0]), solid->p1, solid->p2,
                                                              solid->radius, interpreter.material(statement.last())));
}

void define_cone(Interpreter& interpreter, Statement const& statement) {
  auto const solid = read_round_solid(interpreter, statement, cone_signature);
  if (!solid) return;
  interpreter.define(statement[0], std::make_shared<Cone>(std::string(statement[0]), solid->p1, solid->p2,
                                                          solid->radius, interpreter.material(statement.last())));
}

void define_plane(Interpreter& interpreter, Statement const& statement) {
  std::array<double, 6> v{};
  if (!read_primitive(interpreter, statement, plane_signature, v)) return;
  Vec3 const normal(v[3], v[4], v[5]);
  if (normal == Vec3(0)) {
    interpreter.error(Code::zero_direction, statement[4], "plane: the normal must not be 0 0 0");
    interpreter.mark_faulty(Kind::shape, statement[0]);
    return;
  }
  interpreter.define(statement[0], std::make_shared<Plane>(std::string(statement[0]), Vec3(v[0], v[1], v[2]), normal,
                                                           interpreter.material(statement[7])));
}

void define_box(Interpreter& interpreter, Statement const& statement) {
  std::array<double, 6> v{};
  if (!read_primitive(interpreter, statement, box_signature, v)) return;
  int const flat_sides = (v[0] == v[3]) + (v[1] == v[4]) + (v[2] == v[5]);  // one makes a wall, which can be seen
  if (flat_sides >= 2) {
    interpreter.warning(Code::invisible_shape, span_of(statement[1], statement[6]),
                        fmt::format("box: p1 and p2 are {}: nothing of it can be seen",
                                    flat_sides == 3 ? "the same point" : "on a line along an axis"),
                        "they are opposite corners");
  }
  interpreter.define(statement[0], std::make_shared<Box>(std::string(statement[0]), Vec3(v[0], v[1], v[2]),
                                                         Vec3(v[3], v[4], v[5]), interpreter.material(statement[7])));
}

void define_triangle(Interpreter& interpreter, Statement const& statement) {
  std::array<double, 9> v{};
  if (!read_primitive(interpreter, statement, triangle_signature, v)) return;
  Vec3 const a(v[0], v[1], v[2]);
  if (glm::cross(Vec3(v[3], v[4], v[5]) - a, Vec3(v[6], v[7], v[8]) - a) == Vec3(0)) {
    interpreter.warning(Code::invisible_shape, span_of(statement[1], statement[9]),
                        "triangle: its corners are on a line: nothing of it can be seen");
  }
  interpreter.define(statement[0], std::make_shared<Triangle>(std::string(statement[0]), Vec3(v[0], v[1], v[2]),
                                                              Vec3(v[3], v[4], v[5]), Vec3(v[6], v[7], v[8]),
                                                              interpreter.material(statement[10])));
}

// Children are looked up now, and a composite is complete when it becomes visible to others: no cycle can come about.
void define_composite(Interpreter& interpreter, Statement const& statement) {
  if (statement.size() < 2) {
    interpreter.error(Code::wrong_count, place_after(statement.last()),
                      fmt::format("composite: expected a name and at least one child, found {}",
                                  statement.size() == 0 ? "nothing" : "no child"));
    if (statement.size() > 0) interpreter.mark_faulty(Kind::shape, statement[0]);
    return;
  }
  Token const name = statement[0];
  Composite::Children children;
  children.reserve(statement.size() - 1);
  for (Token const child : statement.arguments.subspan(1)) {
    if (auto const* const shape = interpreter.scene.shapes.find(child)) {
      children.push_back(*shape);
    } else if (child == name) {
      interpreter.error(Code::contains_itself, child,
                        fmt::format("composite {} cannot contain itself", in_quotes(name)));
    } else if (!interpreter.is_faulty(Kind::shape, child)) {
      interpreter.report_undefined(Code::undefined_shape, "shape", {Kind::shape}, child, interpreter.scene.shapes);
    }
  }
  interpreter.define(name, std::make_shared<Composite>(std::string(name), std::move(children)));
}

constexpr Keyword shape_table[] = {
    {"triangle", define_triangle},        {"sphere", define_sphere},    {"box", define_box},
    {"composite", define_composite},      {"mesh", define_mesh, false}, {"obj", define_obj, false},
    {"cylinder", define_cylinder, false}, {"cone", define_cone, false}, {"plane", define_plane, false},
};

std::vector<std::string> accepted_shapes(Interpreter const& interpreter) {
  std::vector<std::string> words;
  for (Keyword const& keyword : shape_table) {
    if (keyword.is_standard || !interpreter.options.strict) words.emplace_back(keyword.word);
  }
  return words;
}

std::string known_shapes(Interpreter const& interpreter) {
  return "the shapes are " + listed(accepted_shapes(interpreter), "and");
}

/// What other programs call a shape.
std::string_view find_synonym(Token word) {
  constexpr std::pair<std::string_view, std::string_view> synonyms[] = {
      {"cube", "box"}, {"cuboid", "box"}, {"ball", "sphere"}, {"group", "composite"}, {"model", "mesh"}};
  auto const* const found = std::ranges::find(synonyms, word, [](auto const& pair) { return pair.first; });
  return found == std::end(synonyms) ? std::string_view() : found->second;
}

std::string hint_for_unknown_kind(Interpreter& interpreter, Statement const& statement) {
  std::string const lower = to_lower_ascii(statement[0]);
  if (lower != statement[0] && find_keyword(shape_kinds(), lower)) return "keywords are lower case: " + lower;
  std::string hint = did_you_mean(find_synonym(lower));
  if (hint.empty()) hint = interpreter.suggest(statement[0], accepted_shapes(interpreter));
  return hint.empty() ? known_shapes(interpreter) : hint;
}

}  // namespace

std::span<Keyword const> shape_kinds() { return shape_table; }

void define_shape(Interpreter& interpreter, Statement const& statement) {
  if (statement.arguments.empty()) {
    interpreter.error(Code::wrong_count, place_after(statement.keyword),
                      "shape: expected a kind of shape, found nothing", known_shapes(interpreter));
    return;
  }
  Token const word = statement[0];
  Statement const inner{word, word, statement.arguments.subspan(1)};
  Keyword const* const kind = find_keyword(shape_table, word);
  if (kind && (kind->is_standard || interpreter.dialect(word, fmt::format("'define shape {}'", word)))) {
    kind->execute(interpreter, inner);
  } else {
    if (!kind) {
      interpreter.error(Code::unknown_shape, word, fmt::format("unknown shape {}", in_quotes(word)),
                        hint_for_unknown_kind(interpreter, statement));
    }
    if (inner.size() > 0) interpreter.mark_faulty(Kind::shape, inner[0]);
  }
}

}  // namespace lichtraum::esdf
