#include "lichtraum/error.hpp"

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

Diagnostic at(std::size_t column, std::size_t length, std::string line) {
  return {Severity::error, DiagnosticCode::none, {"a.sdf", 3, column}, length, "wrong", std::move(line), ""};
}

/// The lines of the formatted text.
std::vector<std::string> lines_of(Diagnostic const& diagnostic) {
  std::vector<std::string> lines;
  std::string const text = format_diagnostic(diagnostic);
  REQUIRE(!text.empty());
  REQUIRE(text.back() == '\n');
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace

TEST_CASE("a diagnostic shows place, line, caret and hint", "[unit][error]") {
  Diagnostic const diagnostic{Severity::error,         DiagnosticCode::unknown_definition,
                              {"scene.sdf", 12, 8},    5,
                              "unknown class 'lihgt'", "define lihgt sun",
                              "did you mean 'light'?"};
  CHECK(format_diagnostic(diagnostic) ==
        "scene.sdf:12:8: error: unknown class 'lihgt' [E0302]\n"
        "    define lihgt sun\n"
        "           ^~~~~\n"
        "  hint: did you mean 'light'?\n");
}

TEST_CASE("what a diagnostic does not have is left out", "[unit][error]") {
  CHECK(format_diagnostic({Severity::warning, DiagnosticCode::none, {"a", 0, 0}, 1, "odd", "", ""}) ==
        "a: warning: odd\n");
  CHECK(format_diagnostic({Severity::note, DiagnosticCode::none, {"a", 5, 0}, 1, "odd", "text", ""}) ==
        "a:5: note: odd\n    text\n");
  CHECK(format_diagnostic({Severity::error, DiagnosticCode::none, {"", 0, 0}, 1, "odd", "", "h"}) ==
        "error: odd\n  hint: h\n");
}

TEST_CASE("carets keep to tabs, characters and the end of the line", "[unit][error]") {
  CHECK(lines_of(at(4, 2, "\t\tabc"))[2] == "    \t\t ^~");
  // Columns count bytes, carets count characters: two bytes each for ö and ß.
  auto const umlauts = lines_of(at(9, 7, "größe größe x"));
  CHECK(umlauts[0] == "a.sdf:3:9: error: wrong");
  CHECK(umlauts[1] == "    größe größe x");
  CHECK(umlauts[2] == "          ^~~~~");
  CHECK(lines_of(at(4, 1, "abc"))[2] == "       ^");    // just behind: something is missing there
  CHECK(lines_of(at(400, 9, "abc"))[2] == "       ^");  // beyond
  CHECK(lines_of(at(2, 400, "abc"))[2] == "     ^~");   // longer than the line
  CHECK(lines_of(at(2, 0, "abc"))[2] == "     ^");
  CHECK(lines_of(at(4, 1, "größe"))[2] == "      ^");  // in the middle of ö
}

TEST_CASE("bytes that could harm a terminal or mislead are made harmless", "[unit][error]") {
  auto const lines = lines_of(at(6, 1,
                                 "a\x1b[2J"
                                 "\xff"
                                 "b\xe2\x80\xae"
                                 "c\x7f"
                                 "\xc0\xaf"));
  CHECK(lines[1] == "    a?[2J?b?c???");
  CHECK(lines[2] == "         ^");
  Diagnostic diagnostic = at(1, 1, "x");
  diagnostic.location.file = "a\nb";
  diagnostic.message = "unknown '\x1b[31m\xc2\x9b'";
  diagnostic.hint = "\r!";
  CHECK(format_diagnostic(diagnostic) == "a?b:3:1: error: unknown '?[31m?'\n    x\n    ^\n  hint: ?!\n");
  CHECK(lines_of(at(1, 1, std::string("\0x", 2)))[1] == "    ?x");
}

TEST_CASE("of a very long line only the part around the place is shown", "[unit][error]") {
  std::string line(1'000'000, 'x');
  std::size_t const place =
      GENERATE(std::size_t(1), std::size_t(500'000), std::size_t(999'998), std::size_t(1'000'001));
  if (place < line.size()) line.replace(place - 1, 3, "BAD");
  auto const lines = lines_of(at(place, 3, line));
  REQUIRE(lines.size() == 3);
  CHECK(lines[1].size() < 200);
  CHECK(lines[2].size() < 200);
  std::size_t const caret = lines[2].find('^');
  if (place < line.size()) {
    CHECK(lines[1].substr(caret, 3) == "BAD");
    CHECK(lines[2].substr(caret) == "^~~");
  } else {
    CHECK(caret == lines[1].size());
  }
  CHECK((lines[1].substr(0, 7) == "    ...") == (place > 100));
  bool const is_cut_right = lines[1].substr(lines[1].size() - 3) == "...";
  CHECK(is_cut_right == (place < 999'000));
}

TEST_CASE("a long line of long characters is cut between them", "[unit][error]") {
  for (std::size_t shift = 0; shift < 4; ++shift) {
    std::string line(shift, 'x');
    for (int i = 0; i < 1000; ++i) line += "\xf0\x9f\x92\xa1";
    std::size_t const column = shift + 4 * 500 + 1;
    auto const lines = lines_of(at(column, 4, line));
    CHECK(lines[1].find('?') == std::string::npos);
    CHECK(lines[2].find('^') == 4 + 3 + 60);
    CHECK(lines[2].back() == '^');
  }
}

TEST_CASE("a scene error carries and joins its diagnostics", "[unit][error]") {
  SceneError const error({at(1, 1, "abc"), at(2, 2, "abc")});
  CHECK(error.kind() == ErrorKind::scene);
  CHECK(error.diagnostics().size() == 2);
  CHECK(std::string(error.what()) == format_diagnostic(at(1, 1, "abc")) + format_diagnostic(at(2, 2, "abc")));
}
