#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/parse_number.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/statements.hpp"
#include "lichtraum/words.hpp"

// render <camera> <file> [<x-res> <y-res>] [integrator=<name>] [samples=<n>] [depth=<n>]
// Dialects: samples and depth after the resolution, a file name in pieces or in quotes, a camera that is missing or not
// defined, a file that `define filename` gave.

namespace lichtraum::esdf {
namespace {

constexpr std::string_view render_usage = "render <camera> <file> [<width> <height>]";

/// The statement's parts. An empty token is not there.
struct Parts {
  Token camera;
  std::span<Token const> file;  ///< more than one token: pieces of one name
  std::span<Token const> numbers;
};

/// Where a file name in quotes ends that begins with arguments[first]; `first` where there is none.
std::size_t end_of_quotes(std::span<Token const> arguments, std::size_t first) {
  if (first >= arguments.size() || arguments[first].front() != '"') return first;
  for (std::size_t last = first; last < arguments.size(); ++last) {
    bool const is_mark_alone = last == first && arguments[first].size() == 1;
    if (arguments[last].back() == '"' && !is_mark_alone) return last + 1;
  }
  return first;
}

Parts split(Interpreter const& interpreter, std::span<Token const> arguments) {
  for (std::size_t const first : {0, 1}) {
    std::size_t const end = end_of_quotes(arguments, first);
    if (end == first) continue;
    return {first == 1 ? arguments[0] : Token(), arguments.subspan(first, end - first), arguments.subspan(end)};
  }
  auto const camera_exists = [&](Token name) {
    return interpreter.scene.cameras.contains(name) || interpreter.is_faulty(Kind::camera, name);
  };
  // By position wherever that makes sense: any token may be a name, also a number.
  bool const is_by_position = arguments.size() == 2 || (arguments.size() == 4 && looks_like_number(arguments[2]) &&
                                                        looks_like_number(arguments[3]));
  if (is_by_position && (camera_exists(arguments[0]) || !looks_like_number(arguments[1]))) {
    return {arguments[0], arguments.subspan(1, 1), arguments.subspan(2)};
  }
  std::size_t words = arguments.size();
  while (words > 0 && looks_like_number(arguments[words - 1])) --words;
  std::span<Token const> const numbers = arguments.subspan(words);
  if (words == 0) return {Token(), {}, numbers};
  bool const has_camera = words > 1 || camera_exists(arguments[0]) || arguments[0].find('.') == Token::npos;
  if (!has_camera) return {Token(), arguments.first(1), numbers};
  std::size_t const file_words = words - 1;
  // 'render eye 7' and 'render eye 7 640 480' draw to a file called 7.
  bool const file_is_number = file_words == 0 && (numbers.size() == 1 || numbers.size() == 3);
  if (file_is_number) return {arguments[0], numbers.first(1), numbers.subspan(1)};
  return {arguments[0], arguments.subspan(1, file_words), numbers};
}

/// Whether file and camera are swapped, which is then reported.
bool report_file_first(Interpreter& interpreter, Statement const& statement, Parts const& parts) {
  auto const& cameras = interpreter.scene.cameras;
  if (parts.camera.empty() || cameras.contains(parts.camera) || parts.file.size() != 1) return false;
  if (!cameras.contains(parts.file[0])) return false;
  interpreter.error(Code::undefined_camera, span_of(parts.camera, parts.file[0]),
                    fmt::format("render: {} stands before the camera", in_quotes(parts.camera)),
                    fmt::format("write {} {} {}", statement.keyword, parts.file[0], parts.camera));
  return true;
}

/// "write 64 48" for a resolution of one word, 64x48; else an empty text.
std::string hint_for_resolution(Token word) {
  std::size_t const x = std::min(word.find('x'), word.size());
  bool const is_resolution =
      parse_number(word.substr(0, x)).has_value() && x < word.size() && parse_number(word.substr(x + 1)).has_value();
  return is_resolution ? fmt::format("write {} {}", word.substr(0, x), word.substr(x + 1)) : std::string();
}

/// Null, after a report, when the camera is neither there nor obvious.
Camera const* find_camera(Interpreter& interpreter, Statement const& statement, Token name) {
  auto const& cameras = interpreter.scene.cameras;
  if (Camera const* const camera = name.empty() ? nullptr : cameras.find(name)) return camera;
  if (!name.empty() && interpreter.is_faulty(Kind::camera, name)) return nullptr;
  if (cameras.size() == 1) {
    std::string const later = name.empty() ? std::string() : interpreter.defined_later(Kind::camera, name);
    std::string const hint =
        fmt::format("{}{}{}", later, later.empty() ? "" : "; ",
                    interpreter.done_unless_strict("using the only one: " + in_quotes(cameras.front().name())));
    bool const accepted =
        name.empty()
            ? interpreter.dialect_warning(Code::camera_assumed, statement.keyword, "render: no camera is given", hint)
            : interpreter.dialect_warning(Code::camera_assumed, name,
                                          fmt::format("camera {} is not defined", in_quotes(name)), hint);
    return accepted ? &cameras.front() : nullptr;
  }
  if (!name.empty()) {
    interpreter.report_undefined(Code::undefined_camera, "camera", {Kind::camera}, name, cameras);
  } else {
    interpreter.error(Code::no_camera, place_after(statement.keyword), "render: no camera is given",
                      std::string(render_usage));
  }
  return nullptr;
}

/// The file's name as one piece. nullopt, after a report, when that cannot be meant.
std::optional<std::string> join_file(Interpreter& interpreter, Statement const& statement, Parts const& parts) {
  if (parts.file.empty()) {
    if (!interpreter.scene.filename.empty()) {
      if (!interpreter.dialect(statement.keyword, "a render without a file name")) return std::nullopt;
      return interpreter.scene.filename;
    }
    interpreter.error(Code::no_file_name, place_after(parts.camera.empty() ? statement.keyword : parts.camera),
                      "render: the file name is missing", std::string(render_usage));
    return std::nullopt;
  }
  Token const at = span_of(parts.file.front(), parts.file.back());
  if (at.size() > 2 && at.front() == '"' && at.back() == '"') {
    if (!interpreter.dialect(at, "a file name in quotes")) return std::nullopt;
    return std::string(at.substr(1, at.size() - 2));
  }
  std::string joined;
  for (Token const piece : parts.file) joined += piece;
  if (parts.file.size() == 1) return joined;

  auto const number = std::find_if(parts.file.begin(), parts.file.end(), looks_like_number);
  if (number != parts.file.end() || joined.find('.') == std::string::npos) {
    Token const odd =
        number != parts.file.end() ? *std::find_if_not(number, parts.file.end(), looks_like_number) : parts.file[1];
    interpreter.error(Code::stray_word, odd, fmt::format("render: {} does not belong here", in_quotes(odd)),
                      std::string(render_usage));
    return std::nullopt;
  }
  if (!interpreter.dialect_warning(Code::spaces_in_file_name, at, "render: the file name contains spaces",
                                   interpreter.done_unless_strict("taken as " + in_quotes(joined)))) {
    return std::nullopt;
  }
  return joined;
}

bool read_extra_numbers(Interpreter& interpreter, std::span<Token const> extra, RenderCommand& command) {
  Token const at = span_of(extra.front(), extra.back());
  bool const is_one = extra.size() == 1;
  if (!interpreter.dialect_warning(Code::extra_render_numbers, at,
                                   is_one ? "render: one more number" : "render: more numbers",
                                   interpreter.done_unless_strict(is_one ? "taken as samples per pixel"
                                                                         : "taken as samples per pixel and depth"))) {
    return false;
  }
  auto const samples = read_whole_number(interpreter, extra[0], "the number of samples", 0);
  if (!samples) return false;
  if (*samples > 0) command.samples = samples;
  if (extra.size() == 1) return true;
  command.depth = read_whole_number(interpreter, extra[1], "the depth", 0);
  return command.depth.has_value();
}

std::optional<Integrator> read_integrator(Interpreter& interpreter, Token value) {
  std::span<Word<Integrator> const> const words = integrator_words;
  if (Integrator const* const found = find_value(words, value)) return *found;
  std::vector<std::string_view> known;
  for (auto const& entry : words) known.push_back(entry.word);
  std::string const hint = interpreter.suggest(value, known);
  interpreter.error(Code::unknown_integrator, value, fmt::format("render: unknown integrator {}", in_quotes(value)),
                    hint.empty() ? list_of(words) : hint);
  return std::nullopt;
}

/// Per pixel; 4x4 is no number, though they may lie so.
std::optional<int> read_samples(Interpreter& interpreter, Token value) {
  std::string const hint = hint_for_resolution(value);
  if (hint.empty()) return read_whole_number(interpreter, value, "the number of samples", 1);
  interpreter.error(Code::not_a_number, value, fmt::format("{} is not a number", in_quotes(value)),
                    "samples= is how many a pixel has in all");
  return std::nullopt;
}

/// What fills `command`; as keys say it clearly, they win over extra numbers.
auto keys_of(Interpreter& interpreter, RenderCommand& command) {
  return std::to_array<Key>({{"integrator",
                              [&](Token value) {
                                command.integrator = read_integrator(interpreter, value);
                                return command.integrator.has_value();
                              },
                              true},
                             {"samples",
                              [&](Token value) {
                                command.samples = read_samples(interpreter, value);
                                return command.samples.has_value();
                              },
                              true},
                             {"depth",
                              [&](Token value) {
                                command.depth = read_whole_number(interpreter, value, "the depth", 0);
                                return command.depth.has_value();
                              },
                              true}});
}

/// How many of the arguments come before the keys. A file's name may hold a '=', too: the first two arguments are keys
/// only where their words are known.
std::size_t count_without_keys(std::span<Token const> arguments, std::span<Key const> keys) {
  std::size_t count = arguments.size();
  auto const is_key = [&](Token argument) {
    return has_key(argument) && (count > 2 || std::any_of(keys.begin(), keys.end(), [&](Key const& key) {
                                   return key.word == argument.substr(0, argument.find('='));
                                 }));
  };
  while (count > 0 && is_key(arguments[count - 1])) --count;
  return count;
}

}  // namespace

void render(Interpreter& interpreter, Statement const& whole) {
  RenderCommand command;
  auto const keys = keys_of(interpreter, command);
  std::size_t const first_key = count_without_keys(whole.arguments, keys);
  Statement const statement{whole.what, whole.keyword, whole.arguments.first(first_key)};
  Parts const parts = split(interpreter, statement.arguments);
  if (report_file_first(interpreter, statement, parts)) return;
  auto const file = join_file(interpreter, statement, parts);
  if (!file) return;
  if (parts.numbers.size() == 1 || parts.numbers.size() > 4) {
    std::string const hint = hint_for_resolution(parts.numbers[0]);
    interpreter.error(
        Code::wrong_count,
        parts.numbers.size() == 1 ? place_after(statement.last()) : span_of(parts.numbers[4], parts.numbers.back()),
        fmt::format("render: expected 2 numbers, found {}", parts.numbers.size()),
        hint.empty() ? std::string(render_usage) : hint);
    return;
  }
  Camera const* const camera = find_camera(interpreter, statement, parts.camera);

  command.file = *file;
  if (!parts.numbers.empty()) {
    command.resolution = read_resolution(interpreter, parts.numbers[0], parts.numbers[1]);
    if (!command.resolution) return;
    if (parts.numbers.size() > 2 && !read_extra_numbers(interpreter, parts.numbers.subspan(2), command)) return;
  }
  if (!read_keys(interpreter, whole, first_key, keys, std::string(render_usage)) || !camera) return;
  command.camera = camera->name();
  bool const has_resolution = command.resolution || camera->resolution() || interpreter.scene.resolution;
  if (!has_resolution && !interpreter.options.has_size) {
    interpreter.error(Code::no_resolution, place_after(statement.last()),
                      "render: neither this statement nor the camera has a resolution",
                      "render <camera> <file> <width> <height>; or --size chooses one");
    return;
  }
  interpreter.render(std::move(command), parts.file.empty() ? whole.keyword : parts.file.front());
}

}  // namespace lichtraum::esdf
