#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "io/esdf/interpreter.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/statements.hpp"
#include "scene/unit_vector.hpp"

// define camera <name> <fov-x> [<x-res> <y-res>] [aperture=<diameter> focus=<distance>] [orthographic=<width>]
// Dialects: <fov> [eye], <fov> [eye] [dir], <fov> [eye] [dir] [up], <fov> <x-res> <y-res> [eye] [dir]

namespace lichtraum::esdf {
namespace {

Signature const camera_signature{
    {{"the opening angle", 1}}, false, {3, 4, 7, 9, 10}, "define camera <name> <degrees> [<width> <height>]"};

constexpr std::string_view camera_usage =
    "define camera <name> <degrees> [<width> <height>] aperture=<diameter> focus=<distance>";

/// What the keys of a camera say; 0: nothing.
struct CameraKeys {
  double aperture = 0;
  double focus_distance = 0;
  double width = 0;  ///< of an orthographic camera

  bool has_lens() const { return aperture > 0; }
};

/// Eye, direction and up from `tokens` (3, 6 or 9 of them), as the frame they span.
std::optional<Transform> read_frame(Interpreter& interpreter, std::span<Token const> tokens) {
  std::array<double, 9> v{};
  if (!read_numbers(interpreter, tokens, v)) return std::nullopt;
  Vec3 const eye(v[0], v[1], v[2]);
  if (tokens.size() == 3) return Transform::translation(eye);

  Vec3 const direction(v[3], v[4], v[5]);
  if (direction == Vec3(0)) {
    interpreter.error(Code::zero_direction, span_of(tokens[3], tokens[5]), "camera: the direction must not be zero");
    return std::nullopt;
  }
  bool const has_up = tokens.size() == 9;
  Vec3 up = has_up ? Vec3(v[6], v[7], v[8]) : Vec3(0, 1, 0);
  if (up == Vec3(0) || are_parallel(direction, up)) {
    Vec3 const other = are_parallel(direction, Vec3(0, 1, 0)) ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    Token const at = has_up ? span_of(tokens[6], tokens[8]) : span_of(tokens[3], tokens[5]);
    std::string_view const problem = up == Vec3(0) ? "the up vector is zero" : "direction and up are parallel";
    interpreter.warning(Code::unusable_up, at, fmt::format("camera: {}", problem),
                        fmt::format("{} {} {} is taken as up", other.x, other.y, other.z));
    up = other;
  }
  return Transform::look_along(eye, direction, up);
}

std::optional<double> read_opening_angle(Interpreter& interpreter, Token token) {
  auto const degrees = read_number(interpreter, token);
  if (degrees && *degrees > 0 && *degrees < 180) return degrees;
  if (degrees) {
    interpreter.error(
        Code::out_of_range, token,
        fmt::format("camera: the opening angle must lie between 0 and 180 degrees, not {}", in_quotes(token)));
  }
  return std::nullopt;
}

/// Takes the keys off the end of a camera. Nothing, after a report, when they make no sense.
std::optional<CameraKeys> take_keys(Interpreter& interpreter, Statement& statement) {
  CameraKeys found;
  auto const& arguments = statement.arguments;
  std::size_t const words = first_key(statement, 1);
  auto const read_positive = [&interpreter](std::string_view word, double& number) {
    return [&interpreter, &number, word](Token value) {
      auto const given = read_number(interpreter, value);
      if (!given) return false;
      number = *given;
      if (number > 0) return true;
      interpreter.error(Code::out_of_range, value,
                        fmt::format("camera: {} must be more than 0, not {}", word, in_quotes(value)));
      return false;
    };
  };
  std::array<Key, 3> const keys{Key{"aperture", read_positive("aperture", found.aperture), true},
                                Key{"focus", read_positive("focus", found.focus_distance)},
                                Key{"orthographic", read_positive("orthographic", found.width), true}};
  if (!read_keys(interpreter, statement, words, keys, std::string(camera_usage))) return std::nullopt;
  if (found.has_lens() != (found.focus_distance > 0)) {
    std::string_view const half = found.has_lens() ? "aperture" : "focus";
    auto const at = std::find_if(arguments.begin() + std::ptrdiff_t(words), arguments.end(),
                                 [&](Token token) { return token.substr(0, half.size()) == half; });
    interpreter.error(Code::incomplete_lens, *at,
                      "camera: a lens has both, aperture= and focus=", std::string(camera_usage));
    return std::nullopt;
  }
  statement.arguments = arguments.first(words);
  return found;
}

bool read_camera(Interpreter& interpreter, Statement statement) {
  auto const keys = take_keys(interpreter, statement);
  if (!keys) return false;
  std::size_t const numbers = statement.size() - (statement.size() > 0 ? 1 : 0);
  bool const has_resolution = numbers == 3 || numbers == 9;
  bool const is_dialect = numbers == 4 || numbers == 7 || numbers == 9 || numbers == 10;
  if (numbers != 1 && numbers != 3 && !is_dialect) {
    report_wrong_count(interpreter, statement, camera_signature);
    return false;
  }
  if (is_dialect && !interpreter.dialect(statement.rest(2), "a camera with a place and a direction")) return false;

  auto const fov = read_opening_angle(interpreter, statement[1]);
  bool good = fov.has_value();
  std::optional<Resolution> resolution;
  if (has_resolution) {
    resolution = read_resolution(interpreter, statement[2], statement[3]);
    good &= resolution.has_value();
  }
  std::optional<Transform> frame = Transform();
  if (is_dialect) {
    frame = read_frame(interpreter, statement.arguments.subspan(has_resolution ? 4 : 2));
    good &= frame.has_value();
  }
  if (!good) return false;
  std::string const name(statement[0]);
  Camera camera = keys->width > 0 ? Camera::orthographic(name, keys->width, *frame, resolution)
                                  : Camera(name, *fov, *frame, resolution);
  if (keys->has_lens()) camera.set_lens({keys->aperture, keys->focus_distance});
  interpreter.define(statement[0], std::move(camera));
  return true;
}

}  // namespace

void define_camera(Interpreter& interpreter, Statement const& statement) {
  if (!read_camera(interpreter, statement) && statement.size() > 0) {
    interpreter.mark_faulty(Kind::camera, statement[0]);
  }
}

}  // namespace lichtraum::esdf
