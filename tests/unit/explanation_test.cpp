#include "lichtraum/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "core/utf8.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/model.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

constexpr std::string_view triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::vector<Explanation> all_explanations() {
  std::vector<Explanation> all;
  for (ExplanationGroup const& group : explanation_groups()) {
    all.insert(all.end(), group.explanations.begin(), group.explanations.end());
  }
  return all;
}

DiagnosticCodeEntry const& entry_of(DiagnosticCode code) { return diagnostic_codes[std::size_t(code)]; }

bool has_word(std::string_view command, std::string_view word) { return command.find(word) != std::string_view::npos; }

/// A folder with the files that examples name.
void write_neighbours(TemporaryFolder const& folder) {
  for (char const* const name : {"teapot.obj", "robot.obj"}) folder.write(name, triangle_obj);
  folder.write("steel.mtl", "newmtl steel\nKd 0.5 0.5 0.5\n");
  constexpr std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  auto const bytes = std::bit_cast<std::array<char, sizeof corners>>(corners);
  folder.write("triangle.bin", std::string_view(bytes.data(), bytes.size()));
}

/// What a loader finds in an example, under the options of its command, as codes.
std::set<std::string_view> codes_found(std::string_view text, std::string_view command) {
  TemporaryFolder const folder;
  write_neighbours(folder);
  std::string const file(command.substr(command.rfind(' ') + 1));
  EsdfOptions options;
  options.strict = has_word(command, "--strict");
  if (has_word(command, "--material-extras reflectance,transmittance")) {
    options.material_extras = {MaterialExtra::reflectance, MaterialExtra::transmittance};
  }
  std::vector<Diagnostic> found;
  try {
    found = file == "scene.sdf" ? EsdfScript::from_text(std::string(text), file, options, folder.path()).diagnostics()
                                : import_model(folder.write(file, text)).diagnostics;
  } catch (SceneError const& error) {
    found = error.diagnostics();
  }
  std::set<std::string_view> codes;
  for (Diagnostic const& diagnostic : found) {
    INFO(format_diagnostic(diagnostic));
    if (diagnostic.severity == Severity::note) continue;
    // The letter is that of the severity: no example needs --keep-going, and --strict is for what it makes an error.
    CHECK(code_text(diagnostic.code).substr(0, 1) == (diagnostic.severity == Severity::error ? "E" : "W"));
    codes.insert(code_text(diagnostic.code));
  }
  return codes;
}

std::string page() {
  std::string text =
      "# Diagnostics\n"
      "What the codes of errors and warnings mean, as `lichtraum explain E0412` says it. A code keeps its meaning: "
      "texts may be "
      "worded\nbetter, but the number of one that is no longer used is never given to another. `E` is for errors and "
      "`W` for "
      "warnings;\n`--strict` may make a warning an error, and `--keep-going` an error a warning, of the same code.\n\n"
      "This page is made from the tables in `src/explain/`; `LICHTRAUM_WRITE_DOCS=1 build/dev/tests/unit_tests "
      "\"[codes]\"`\nwrites it anew.\n";
  for (ExplanationGroup const& group : explanation_groups()) {
    text += fmt::format("\n## {}\n", group.title);
    for (Explanation const& e : group.explanations) {
      text += fmt::format("\n### {}: {}\n{}", entry_of(e.code).text, entry_of(e.code).title, e.text);
      if (e.example.empty()) continue;
      std::string const how = e.command == Explanation{}.command ? "For example" : fmt::format("With `{}`", e.command);
      text += fmt::format("\n{}:\n```\n{}```\nInstead:\n```\n{}```\n", how, e.example, e.instead);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("every code has an explanation that fits a terminal", "[unit][codes]") {
  auto const all = all_explanations();
  CHECK(all.size() + 1 == std::size(diagnostic_codes));
  for (DiagnosticCodeEntry const& entry : diagnostic_codes) {
    INFO(entry.text);
    Explanation const* const explanation = explanation_of(entry.code);
    CHECK((explanation == nullptr) == (entry.code == DiagnosticCode::none));
    if (!explanation) continue;
    CHECK(explanation->example.empty() == explanation->instead.empty());
    CHECK(explanation->text.size() > 40);
    for (std::string_view text : {explanation->text, explanation->example, explanation->instead}) {
      CHECK(is_utf8(text));
      for (std::size_t end = 0; !text.empty(); text.remove_prefix(end + 1)) {
        end = text.find('\n');
        REQUIRE(end != std::string_view::npos);
        CHECK(end <= 80);
      }
    }
  }
}

TEST_CASE("each explanation's example has that finding and no other, and is right instead", "[unit][codes]") {
  std::set<std::string_view> without;
  for (Explanation const& explanation : all_explanations()) {
    std::string_view const code = code_text(explanation.code);
    INFO(code);
    if (explanation.example.empty()) {
      without.insert(code);
      std::string text(explanation.text);
      std::replace(text.begin(), text.end(), '\n', ' ');
      CHECK_THAT(text, contains_text("For example, "));
    }
    // What a picture shows is tested with the program.
    if (explanation.example.empty() || has_word(explanation.command, "lichtraum render")) continue;
    CHECK(codes_found(explanation.example, explanation.command) == std::set{code});
    CHECK(codes_found(explanation.instead, explanation.command).empty());
  }
  // Too long for a page, of bytes that are no text, of several files, or of what a machine has.
  CHECK(without == std::set<std::string_view>{"E0102", "W0205", "E0206", "E0207", "E0208", "E0209", "E0820", "E0313",
                                              "W0314", "W0817", "W0818", "W0819", "W0821", "W0822", "W0825", "W0905",
                                              "E1003", "W1004", "E1010", "W1011", "W1013", "W1108", "W1109", "W1303"});
}

TEST_CASE("what a page cannot show has its code, too", "[unit][codes]") {
  using Codes = std::set<std::string_view>;
  CHECK(codes_found("camera e\x1Bye 45\n", "scene.sdf") == Codes{"E0313"});
  CHECK(codes_found("camera k\xFCgel 45\n", "scene.sdf") == Codes{"W0314"});
  std::string const cut_off("glTF\2\0\0\0", 8);
  CHECK(codes_found(cut_off, "lichtraum check model.glb") == Codes{"E1003"});
  CHECK(codes_found(std::string(84, '\0') + "?", "lichtraum check model.stl") == Codes{"W1303", "E0901"});
  std::string const spectral = "newmtl steel\nKd spectral steel.rfl\n";
  TemporaryFolder const folder;
  folder.write("spectral.mtl", spectral);
  auto const model = folder.write("model.obj", "mtllib spectral.mtl\nusemtl steel\n" + std::string(triangle_obj));
  auto const found = import_model(model).diagnostics;
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == DiagnosticCode::unread_color);
}

TEST_CASE("docs/DIAGNOSTICS.md says what the tables say", "[unit][codes][docs]") {
  std::string const path = project_path("docs/DIAGNOSTICS.md");
  if (std::getenv("LICHTRAUM_WRITE_DOCS")) std::ofstream(path, std::ios::binary) << page();
  CHECK(read_project_file("docs/DIAGNOSTICS.md") == page());
}
