#include "io/esdf/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/ascii.hpp"
#include "core/parse_number.hpp"
#include "core/utf8.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/statements.hpp"
#include "io/esdf/unseen_character.hpp"

namespace lichtraum::esdf {
namespace {

constexpr std::string_view kind_names[] = {"material", "shape", "light", "camera"};  // by Kind

constexpr Kind all_kinds[] = {Kind::material, Kind::shape, Kind::light, Kind::camera};

std::string_view name_of(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

bool is_conflict_marker(Token token) {
  return token == "<<<<<<<" || token == "=======" || token == ">>>>>>>" || token == "|||||||";
}

/// The name that a line defines in the namespace of `kind`, or an empty token.
Token defined_name(Kind kind, std::span<Token const> tokens) {
  auto const token = [&](std::size_t i) { return i < tokens.size() ? tokens[i] : Token(); };
  if (kind == Kind::camera && token(0) == "camera") return token(1);
  if (kind == Kind::light && token(0) == "ambient") return token(1);
  if (kind == Kind::light && token(0) == "define" && token(1) == "ambient") return token(2);
  if (token(0) != "define" || token(1) != name_of(kind)) return {};
  if (kind == Kind::shape) return token(3);
  bool const has_light_class =
      kind == Kind::light && (token(2) == "ambient" || token(2) == "diffuse" || token(2) == "environment");
  return token(has_light_class ? 3 : 2);
}

/// The keywords that a line begins with when their case does not count, in lower case: "define", "shape" and "sphere".
std::vector<std::string> lower_keywords(std::span<Token const> tokens) {
  std::vector<std::string> words;
  for (Token const token : tokens.first(std::min<std::size_t>(tokens.size(), 3)))
    words.push_back(to_lower_ascii(token));
  std::size_t count = find_keyword(commands(), words[0]) ? 1 : 0;
  if (words[0] == "define") {
    bool const has_class = words.size() > 1 && find_keyword(classes(), words[1]);
    bool const has_kind = has_class && words[1] == "shape" && words.size() > 2 && find_keyword(shape_kinds(), words[2]);
    count = has_kind ? 3 : has_class ? 2 : 1;
  }
  words.resize(count);
  return words;
}

/// What a line was probably meant to be.
struct Correction {
  std::vector<Token> words;  ///< in place of those that are wrong; empty: nobody knows
  std::string hint;
};

Correction correct_command(Interpreter& interpreter, Token word) {
  if (find_keyword(classes(), word)) return {{"define", word}, fmt::format("did you mean 'define {}'?", word)};
  if (find_keyword(shape_kinds(), word)) {
    return {{"define", "shape", word}, fmt::format("did you mean 'define shape {}'?", word)};
  }
  constexpr std::string_view commands_known[] = {"define", "transform", "render", "camera", "ambient"};
  std::string_view const nearest = interpreter.nearest(word, commands_known);
  if (!nearest.empty()) return {{nearest}, did_you_mean(nearest)};
  return {{}, "a line starts with define, transform, render or camera; comments with '#'"};
}

Correction correct_class(Interpreter& interpreter, Token word) {
  if (find_keyword(shape_kinds(), word)) {
    return {{"define", "shape", word}, fmt::format("did you mean 'define shape {}'?", word)};
  }
  std::vector<std::string_view> known;
  for (Keyword const& keyword : classes()) known.push_back(keyword.word);
  std::string_view const nearest = interpreter.nearest(word, known);
  if (!nearest.empty()) return {{"define", nearest}, did_you_mean(nearest)};
  return {{}, "'define' is followed by material, shape, light, camera or background"};
}

}  // namespace

std::string did_you_mean(std::string_view name) {
  return name.empty() ? std::string() : fmt::format("did you mean {}?", in_quotes(name));
}

Interpreter::Interpreter(Source const& source_, EsdfOptions const& options_)
    : source(source_),
      options(options_),
      diagnostics_(source_.name, options_.max_diagnostics),
      magenta_(std::make_shared<Material>("undefined", Rgb(1, 0, 1), Rgb(1, 0, 1), Rgb(0), 1)) {}

void Interpreter::run(DrawFunction const* draw) {
  draw_ = draw;
  // Large files are lists of shapes. A triangle's line has some 70 bytes or more.
  constexpr std::size_t bytes_per_shape = 64;
  scene.shapes.reserve(source.text.size() / bytes_per_shape);
  LineReader reader(source.text);
  Line line;
  while (!is_stopped_ && reader.next(line)) {
    TokenTraits const traits = tokenize(line.text, tokens_);
    if (tokens_.empty()) continue;
    if (!options.keep_going && diagnostics_.has_all_errors()) {
      stopped_at_ = line.number;
      break;
    }
    diagnostics_.begin_line(line);
    if (!check_tokens(traits)) continue;
    drop_semicolon();
    if (!tokens_.empty()) execute();
  }
}

void Interpreter::drop_semicolon() {
  Token& last = tokens_.back();
  if (last.back() != ';') return;
  std::size_t const end = last.find_last_not_of(';') + 1;
  error(Code::semicolon, last.substr(end), "';' at the end of a line", "leave it out: a statement ends with its line");
  last = last.substr(0, end);
  if (last.empty()) tokens_.pop_back();
}

bool Interpreter::report_spaces_around_equals() {
  Token const line = span_of(tokens_.front(), tokens_.back());
  if (line.find('"') != Token::npos) return false;  // a file's name may have them
  auto const is_name = [&](Token token) {           // which may be any word
    return std::ranges::any_of(all_kinds,
                               [&](Kind kind) { return defined_name(kind, tokens_).data() == token.data(); });
  };
  for (std::size_t i = 3; i < tokens_.size(); ++i) {
    if (is_name(tokens_[i])) continue;
    bool const is_before = tokens_[i].front() == '=' && !has_key(tokens_[i - 1]) && !looks_like_number(tokens_[i - 1]);
    bool const is_after = tokens_[i].back() == '=' && i + 1 < tokens_.size() && !has_key(tokens_[i + 1]);
    if (!is_before && !is_after) continue;
    Token const word = is_before ? tokens_[i - 1] : tokens_[i].substr(0, tokens_[i].size() - 1);
    Token const value = is_after ? tokens_[i + 1] : tokens_[i].substr(1);
    error(Code::spaces_around_equals,
          span_of(is_before ? tokens_[i - 1] : tokens_[i], is_after ? tokens_[i + 1] : tokens_[i]), "spaces around '='",
          fmt::format("write it without spaces: {}", in_quotes(fmt::format("{}={}", word, value))));
    mark_faulty(tokens_);
    return true;
  }
  return false;
}

bool Interpreter::report_unseen_character() {
  for (Token const token : tokens_) {
    auto const unseen = find_unseen_character(token);
    if (!unseen) continue;
    error(Code::control_character, unseen->at, fmt::format("{} U+{:04X}", unseen->name, unseen->value),
          unseen->is_blank ? "write an ordinary space instead" : "delete it: it cannot be seen");
    mark_faulty(split_at_unseen_characters(tokens_));
    return true;
  }
  return false;
}

bool Interpreter::check_tokens(TokenTraits const& traits) {
  if (is_conflict_marker(tokens_[0])) {
    error(Code::conflict_marker, span_of(tokens_.front(), tokens_.back()), "git conflict marker",
          "resolve the conflict: keep one of the two versions, remove the markers");
    return false;
  }
  if (traits.has_brace) {
    std::string_view const line = span_of(tokens_.front(), tokens_.back());
    std::size_t const open = line.find("{{");
    std::size_t const close = open == Token::npos ? open : line.find("}}", open);
    if (close != Token::npos) {
      Token const placeholder = line.substr(open, close + 2 - open);
      error(Code::placeholder, placeholder, fmt::format("unsubstituted placeholder {}", in_quotes(placeholder)),
            "this file is a template: fill it in first");
      mark_faulty(tokens_);
      return false;
    }
  }
  if (traits.has_equals && report_spaces_around_equals()) return false;
  if (traits.has_control) {
    for (Token const token : tokens_) {
      auto const at = std::find_if(token.begin(), token.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; });
      if (at == token.end()) continue;
      error(Code::control_character, Token(&*at, 1),
            fmt::format("control character U+{:04X}", static_cast<unsigned>(*at)));
      mark_faulty(tokens_);
      return false;
    }
  }
  if (traits.has_non_ascii) {
    for (Token const token : tokens_) {
      if (is_utf8(token)) continue;
      constexpr std::string_view message = "not UTF-8";
      constexpr std::string_view hint = "save the file as UTF-8; it looks like Latin-1 or Windows-1252";
      if (options.strict) {
        error(Code::not_utf8, token, std::string(message), std::string(hint));
        return false;
      }
      if (!has_bad_encoding_) warning(Code::not_utf8, token, std::string(message), std::string(hint));
      has_bad_encoding_ = true;
    }
    if (report_unseen_character()) return false;
  }
  return true;
}

void Interpreter::execute() {
  std::span<Token const> const tokens = tokens_;
  bool const is_define = tokens[0] == "define";
  if (is_define && tokens.size() == 1) {
    error(Code::wrong_count, place_after(tokens[0]), "define: expected a kind of thing to define, found nothing",
          "'define' is followed by material, shape, light, camera or background");
    return;
  }
  std::size_t const at = is_define ? 1 : 0;
  Token const word = tokens[at];
  Keyword const* const keyword = find_keyword(is_define ? classes() : commands(), word);
  if (!keyword) {
    std::vector<std::string> const lower = lower_keywords(tokens);
    bool const is_upper = lower.size() > at && lower[at] != word;
    auto [meant, hint] = is_upper    ? Correction{{lower.begin(), lower.end()},
                                               fmt::format("keywords are lower case: {}", fmt::join(lower, " "))}
                         : is_define ? correct_class(*this, word)
                                     : correct_command(*this, word);
    error(is_define ? Code::unknown_definition : Code::unknown_statement, word,
          is_define ? fmt::format("cannot define {}: unknown kind", in_quotes(word))
                    : fmt::format("unknown statement {}", in_quotes(word)),
          std::move(hint));
    if (meant.empty()) return;
    std::span<Token const> const rest = tokens.subspan(is_upper ? lower.size() : at + 1);
    meant.insert(meant.end(), rest.begin(), rest.end());
    mark_faulty(meant);
    return;
  }
  if (!keyword->is_standard &&
      !dialect(span_of(tokens[0], word), is_define ? fmt::format("'define {}'", word) : fmt::format("'{}'", word))) {
    return;
  }
  if (has_rendered_ && keyword->execute != esdf::render) is_animated_ = true;
  keyword->execute(*this, {keyword->word, word, tokens.subspan(at + 1)});
}

void Interpreter::mark_faulty(std::span<Token const> definition) {
  for (Kind const kind : all_kinds) {
    Token const name = defined_name(kind, definition);
    if (!name.empty()) mark_faulty(kind, name);
  }
}

void Interpreter::error(Code code, Token at, std::string message, std::string hint) {
  diagnostics_.add(Severity::error, code, at, std::move(message), std::move(hint));
}

void Interpreter::warning(Code code, Token at, std::string message, std::string hint) {
  diagnostics_.add(Severity::warning, code, at, std::move(message), std::move(hint));
}

bool Interpreter::dialect(Token at, std::string_view form) {
  diagnostics_.add(options.strict ? Severity::error : Severity::note, Code::not_standard, at,
                   fmt::format("{} is not part of the standard", form));
  return !options.strict;
}

bool Interpreter::dialect_warning(Code code, Token at, std::string message, std::string hint) {
  diagnostics_.add(options.strict ? Severity::error : Severity::warning, code, at, std::move(message), std::move(hint));
  return !options.strict;
}

std::vector<Diagnostic> Interpreter::take_diagnostics() {
  std::vector<Diagnostic> found = std::move(diagnostics_).finish(stopped_at_);
  if (options.keep_going) {
    for (Diagnostic& diagnostic : found) {
      if (diagnostic.severity == Severity::error) diagnostic.severity = Severity::warning;
    }
  }
  return found;
}

std::shared_ptr<Material> const& Interpreter::material(Token name) {
  if (last_material_ && name == (*last_material_)->name()) return *last_material_;
  if (auto* const found = scene.materials.find(name)) return *(last_material_ = found);
  if (!is_faulty(Kind::material, name))
    report_undefined(Code::undefined_material, "material", {Kind::material}, name, scene.materials);
  return magenta_;
}

void Interpreter::define(Token name, std::shared_ptr<Shape> shape) {
  if (scene.shapes.insert(shape)) return;
  report_duplicate(Kind::shape, name);
  scene.shapes.insert_or_replace(std::move(shape));
}

void Interpreter::tell(EsdfStatement::Kind kind, std::string_view name) const {
  if (options.on_statement) options.on_statement({diagnostics_.line().number, kind, std::string(name)});
}

void Interpreter::define(Token name, std::shared_ptr<Material> material) {
  tell(EsdfStatement::Kind::material, name);
  if (scene.materials.insert(material)) return;
  report_duplicate(Kind::material, name);
  scene.materials.insert_or_replace(std::move(material));
}

void Interpreter::define(Token name, Camera camera) {
  tell(EsdfStatement::Kind::camera, name);
  if (scene.cameras.contains(name)) report_duplicate(Kind::camera, name);
  scene.cameras.insert_or_replace(std::move(camera));
}

void Interpreter::define(Token name, Light light) {
  tell(EsdfStatement::Kind::light, name);
  if (is_light(name)) report_duplicate(Kind::light, name);
  scene.lights.insert_or_replace(std::move(light));
}

void Interpreter::define(Token name, EnvironmentLight environment) {
  tell(EsdfStatement::Kind::environment, name);
  if (scene.environment && scene.environment->name != name) {
    std::string const& first = scene.environment->name;
    std::size_t const line = find_definition(Kind::light, first, Lines::before);
    error(Code::second_environment, name, fmt::format("there is an environment already: {}", in_quotes(first)),
          line == 0 ? std::string() : fmt::format("it is defined in line {}; a scene has one", line));
  } else if (scene.environment || scene.lights.contains(name)) {
    report_duplicate(Kind::light, name);
  }
  scene.environment = std::move(environment);
}

void Interpreter::render(RenderCommand command, Token at) {
  Line const& line = diagnostics_.line();
  command.location = {source.name, line.number, static_cast<std::size_t>(at.data() - line.text.data()) + 1};
  tell(EsdfStatement::Kind::render, command.camera);
  has_rendered_ = true;
  scene.renders.push_back(std::move(command));
  if (draw_ && options.adjust) options.adjust(scene);
  if (draw_ && !(*draw_)(scene, scene.renders.back())) is_stopped_ = true;
}

void Interpreter::report_duplicate(Kind kind, Token name) {
  std::size_t const line = find_definition(kind, name, Lines::before);
  error(Code::already_defined, name, fmt::format("{} {} is already defined", name_of(kind), in_quotes(name)),
        line == 0 ? std::string() : fmt::format("first defined in line {}", line));
}

bool Interpreter::is_light(Token name) const {
  return scene.lights.contains(name) || (scene.environment && scene.environment->name == name);
}

std::string Interpreter::defined_as_another_kind(Token name) {
  auto const defined = [&](Kind kind) {
    std::size_t const line = find_definition(kind, name, Lines::before);
    return fmt::format("{} is a {}{}", in_quotes(name), name_of(kind),
                       line == 0 ? std::string() : fmt::format(", defined in line {}", line));
  };
  if (scene.materials.contains(name)) return defined(Kind::material);
  if (scene.shapes.contains(name)) return defined(Kind::shape);
  if (is_light(name)) return defined(Kind::light);
  if (scene.cameras.contains(name)) return defined(Kind::camera);
  return {};
}

std::string Interpreter::defined_later(Kind kind, Token name) {
  std::size_t const line = find_definition(kind, name, Lines::after);
  return line == 0 ? std::string() : fmt::format("it is defined later, in line {}: statements run in order", line);
}

std::size_t Interpreter::find_definition(Kind kind, Token name, Lines where) {
  if (diagnostics_.has_all_errors()) return 0;
  auto const current = static_cast<std::size_t>(diagnostics_.line().text.data() - source.text.data());
  bool const is_after = where == Lines::after;
  std::string_view const text =
      is_after ? std::string_view(source.text).substr(current) : std::string_view(source.text).substr(0, current);
  std::size_t const lines_before = is_after ? diagnostics_.line().number - 1 : 0;
  LineReader reader(text);
  Line line;
  std::vector<Token> tokens;
  while (reader.next(line)) {
    if (line.text.size() > search_budget_) return 0;
    search_budget_ -= line.text.size();
    // Most lines do not hold the name at all, and a search for it is quicker than cutting them into tokens.
    if (line.text.find(name) == std::string_view::npos) continue;
    tokenize(line.text, tokens);
    if (defined_name(kind, tokens) == name) return lines_before + line.number;
  }
  return 0;
}

}  // namespace lichtraum::esdf
