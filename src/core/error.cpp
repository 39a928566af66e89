#include "lichtraum/error.hpp"

#include <algorithm>
#include <string_view>

#include "core/printable.hpp"

namespace lichtraum {
namespace {

constexpr std::string_view indentation = "    ";
// How much of a line is shown on either side of the marked place.
constexpr std::size_t characters_before = 60;
constexpr std::size_t characters_after = 100;
constexpr std::size_t longest_sequence = 4;  // bytes of a UTF-8 character

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The part of a line around the marked bytes, [begin, end), in bytes.
struct Excerpt {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Generous and in bytes, so that a line of a megabyte costs no more than others; the characters are counted afterwards.
Excerpt excerpt_around(std::string_view line, std::size_t marked) {
  Excerpt result{0, line.size()};
  std::size_t const before = characters_before * longest_sequence;
  std::size_t const after = characters_after * longest_sequence;
  if (marked > before) result.begin = marked - before;
  if (line.size() - marked > after) result.end = marked + after;
  for (int i = 0; i < 3 && result.begin > 0 && result.begin < marked && is_continuation(line[result.begin]); ++i) {
    ++result.begin;
  }
  return result;
}

/// The source line, and under it the caret.
std::string quote(Diagnostic const& diagnostic) {
  std::string_view const line = diagnostic.source_line;
  if (line.empty()) return "";
  bool const has_caret = diagnostic.location.column > 0;
  std::size_t const marked = has_caret ? std::min(diagnostic.location.column - 1, line.size()) : 0;
  std::size_t const marked_end = std::min(marked + std::max<std::size_t>(diagnostic.length, 1), line.size());

  Excerpt const excerpt = excerpt_around(line, marked);
  auto const characters = printable_characters(line.substr(excerpt.begin, excerpt.end - excerpt.begin));
  // Index of the character that `byte` (of the line) belongs to.
  auto const character_at = [&](std::size_t byte) {
    auto const after = std::upper_bound(characters.begin(), characters.end(), byte - excerpt.begin,
                                        [](std::size_t b, PrintableCharacter const& c) { return b < c.first_byte; });
    return static_cast<std::size_t>(after - characters.begin()) - 1;
  };
  std::size_t const caret = marked < line.size() ? character_at(marked) : characters.size();
  std::size_t const first = caret > characters_before ? caret - characters_before : 0;
  std::size_t const last = std::min(characters.size(), caret + characters_after);
  bool const cut_left = excerpt.begin > 0 || first > 0;
  bool const cut_right = excerpt.end < line.size() || last < characters.size();

  std::string source(indentation);
  std::string carets(indentation);
  if (cut_left) {
    source += "...";
    carets += "   ";
  }
  for (std::size_t i = first; i < last; ++i) {
    source += characters[i].text;
    if (i < caret) carets += characters[i].text == "\t" ? '\t' : ' ';
  }
  if (cut_right) source += "...";
  carets += '^';
  if (marked_end > marked) {
    std::size_t const marked_last = std::min(marked_end, excerpt.end) - 1;
    carets.append(std::min(character_at(marked_last), last - 1) - caret, '~');
  }
  return has_caret ? source + '\n' + carets + '\n' : source + '\n';
}

std::string join(std::vector<Diagnostic> const& diagnostics) {
  std::string result;
  for (Diagnostic const& diagnostic : diagnostics) result += format_diagnostic(diagnostic);
  return result;
}

}  // namespace

std::string_view severity_text(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

std::string format_diagnostic(Diagnostic const& diagnostic) {
  SourceLocation const& location = diagnostic.location;
  std::string result = printable(location.file);
  if (location.line > 0) result += ':' + std::to_string(location.line);
  if (location.line > 0 && location.column > 0) result += ':' + std::to_string(location.column);
  if (!result.empty()) result += ": ";
  result += severity_text(diagnostic.severity);
  result += ": " + printable(diagnostic.message);
  if (diagnostic.code != DiagnosticCode::none) result.append(" [").append(code_text(diagnostic.code)).append("]");
  result += '\n' + quote(diagnostic);
  if (!diagnostic.hint.empty()) result += "  hint: " + printable(diagnostic.hint) + '\n';
  return result;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : Error(ErrorKind::scene, join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace lichtraum
