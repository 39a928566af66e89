#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "core/read_file.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// Real scene files, whose folder LICHTRAUM_CORPUS names. esdf_corpus_outcomes.tsv says for each whether it loads, or
// with how many errors it does not. A change of an outcome is a decision: run with LICHTRAUM_WRITE_OUTCOMES=1, and look
// at the difference. The number of files that load may only rise.

using namespace lichtraum;
using namespace lichtraum::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t files_that_load = 483;
constexpr char const* outcomes_file = "tests/unit/esdf_corpus_outcomes.tsv";

using Table = std::map<std::string, std::string>;

std::string outcome_of(std::string const& text) {
  EsdfOptions options;
  options.max_diagnostics = 1'000'000;
  try {
    EsdfScript::from_text(text, "s.sdf", options).play([](Scene const&, RenderCommand const&) { return true; });
    return "loads";
  } catch (SceneError const& error) {
    return "errors: " + std::to_string(count_errors(error.diagnostics()));
  }
}

Table read_outcomes() {
  std::istringstream in(read_project_file(outcomes_file));
  Table table;
  std::string line;
  while (std::getline(in, line)) {
    std::size_t const tab = line.find('\t');
    if (tab != std::string::npos) table[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return table;
}

}  // namespace

TEST_CASE("real scene files load as they did", "[unit][esdf][corpus]") {
  char const* const corpus = std::getenv("LICHTRAUM_CORPUS");
  if (!corpus) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real scene files");
  Table outcomes;
  std::size_t loading = 0;
  for (auto const& entry : fs::directory_iterator(fs::path(corpus) / "esdf")) {
    std::string const name = entry.path().filename().string();
    if (name == "INDEX.tsv" || name == "FAMILIES.tsv") continue;
    std::string const text = read_file(entry.path());
    std::string const outcome = outcome_of(text);
    outcomes[name] = outcome;
    loading += outcome == "loads" ? 1 : 0;

    // Whatever is wrong with it, the rest of it can be kept, unless it is another kind of file altogether.
    EsdfOptions keep_going;
    keep_going.keep_going = true;
    INFO(name);
    CHECK((loads(text, keep_going) || outcome == "errors: 1"));
  }
  if (std::getenv("LICHTRAUM_WRITE_OUTCOMES")) {
    std::ofstream out(project_path(outcomes_file));
    for (auto const& [name, outcome] : outcomes) out << name << '\t' << outcome << '\n';
  }
  std::cout << loading << " of " << outcomes.size() << " real scene files load\n";
  CHECK(loading >= files_that_load);
  Table const expected = read_outcomes();
  for (auto const& [name, outcome] : outcomes) {
    INFO(name);
    auto const found = expected.find(name);
    CHECK((found == expected.end() ? "not in the table" : found->second) == outcome);
  }
  CHECK(expected.size() == outcomes.size());
}
