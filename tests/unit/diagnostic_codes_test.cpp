#include <algorithm>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/project_files.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("codes have a letter and a number of their own, in order", "[unit][codes]") {
  std::string last;
  std::set<std::string_view> titles;
  for (DiagnosticCodeEntry const& entry : diagnostic_codes) {
    INFO(entry.text);
    CHECK(code_text(entry.code) == entry.text);
    if (entry.code == DiagnosticCode::none) continue;
    REQUIRE(entry.text.size() == 5);
    CHECK((entry.text[0] == 'E' || entry.text[0] == 'W'));
    std::string const number(entry.text.substr(1));
    CHECK(number.find_first_not_of("0123456789") == std::string::npos);
    CHECK(number > last);
    CHECK(titles.insert(entry.title).second);
    last = number;
  }
}

TEST_CASE("a finding keeps its code when it becomes an error or a warning; notes have none", "[unit][codes][esdf]") {
  std::string const dialect = "define light lamp 1 1 1 1 1 1\n";
  auto const note = findings(dialect);
  REQUIRE(note.size() == 1);
  CHECK(note[0].severity == Severity::note);
  CHECK(note[0].code == DiagnosticCode::none);
  EsdfOptions strict;
  strict.strict = true;
  auto const refused = findings(dialect, strict);
  REQUIRE(refused.size() == 1);
  CHECK(format_diagnostic(refused[0]).find(" is not part of the standard [E0315]\n") != std::string::npos);

  std::string const negative = red + "define shape sphere s 0 0 0 -1 red\n";
  CHECK(findings(negative).at(0).severity == Severity::warning);
  CHECK(findings(negative).at(0).code == DiagnosticCode::negative_radius);
  CHECK(findings(negative, strict).at(0).severity == Severity::error);
  CHECK(findings(negative, strict).at(0).code == DiagnosticCode::negative_radius);

  EsdfOptions keep_going;
  keep_going.keep_going = true;
  auto const kept = findings("nonsense\n", keep_going);
  CHECK(kept.at(0).severity == Severity::warning);
  CHECK(kept.at(0).code == DiagnosticCode::unknown_statement);
}

TEST_CASE("all that the loader finds has a code, but notes", "[unit][codes][esdf]") {
  // Each text of esdf_diagnostics.txt, and what is cut off after many.
  std::string const file = read_project_file("tests/unit/esdf_diagnostics.txt");
  for (std::size_t at = 0; at < file.size();) {
    std::size_t const arrow = file.find("-->\n", at);
    REQUIRE(arrow != std::string::npos);
    for (Diagnostic const& found : findings(file.substr(at, arrow - at))) {
      INFO(found.message);
      CHECK((found.code == DiagnosticCode::none) == (found.severity == Severity::note));
    }
    std::size_t const end = file.find("---\n", arrow);
    at = end == std::string::npos ? file.size() : end + 4;
  }
  std::string many;
  for (int i = 0; i < 101; ++i) many += "nonsense\n";
  CHECK(findings(many).back().code == DiagnosticCode::too_many_findings);
}
