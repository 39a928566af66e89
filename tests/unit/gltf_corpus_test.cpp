#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <deque>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "lichtraum/gltf.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/gltf_triangles.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
namespace fs = std::filesystem;

// Models that nobody here wrote: real ones, and ones that were made to break a loader. They lie in
// $LICHTRAUM_CORPUS/gltf; INDEX.tsv there names class and path of each.

namespace {

fs::path corpus_folder() {
  char const* folder = std::getenv("LICHTRAUM_CORPUS");
  return folder ? fs::path(folder) / "gltf" : fs::path();
}

fs::path const outcomes_file = project_path("tests/unit/gltf_corpus_outcomes.tsv");

std::vector<std::string> split(std::string const& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
  return cells;
}

/// What becomes of one model: "ok", "warned" or "error", and the triangles stored and drawn.
std::string outcome_of(fs::path const& path) {
  try {
    Model const model = import_gltf(path);
    FlatScene const flat = flatten(model.scene.roots());
    std::size_t stored = 0;
    for (auto const& object : flat.objects) stored += object.triangles.size();
    std::size_t drawn = flat.objects[0].triangles.size();
    for (auto const& instance : flat.instances) drawn += flat.objects[instance.object].triangles.size();
    std::ostringstream out;
    out << (model.diagnostics.empty() ? "ok" : "warned") << '\t' << stored << '\t' << drawn;
    return out.str();
  } catch (Error const& error) {
    return std::string(error.what()).empty() ? "an error without words" : "error\t\t";
  }
}

/// A process that finds out the same, and may use ten seconds and a gigabyte.
struct Child {
  std::string path;
  pid_t process;
  int outcome;  // a pipe's end
};

Child start_child(fs::path const& folder, std::string const& path) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  pid_t const child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
#ifndef LICHTRAUM_SANITIZED                                 // AddressSanitizer's shadow is terabytes
    rlimit const memory{rlim_t(5) << 28, rlim_t(5) << 28};  // 1 GB, and the program itself
    ::setrlimit(RLIMIT_AS, &memory);
    rlimit const time{10, 10};
    ::setrlimit(RLIMIT_CPU, &time);
#endif
    std::string const outcome = outcome_of(folder / path);
    [[maybe_unused]] auto const written = ::write(ends[1], outcome.data(), outcome.size());
    ::_exit(0);
  }
  ::close(ends[1]);
  return {path, child, ends[0]};
}

/// What it found, or how it ended, if not well.
std::string outcome_of(Child const& child) {
  std::string outcome;
  char buffer[256];
  for (ssize_t count; (count = ::read(child.outcome, buffer, sizeof buffer)) > 0;)
    outcome.append(buffer, std::size_t(count));
  ::close(child.outcome);
  int status = 0;
  ::waitpid(child.process, &status, 0);
  if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? outcome : "exited with " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

TEST_CASE("every model of the corpus ends as it did: drawn, drawn with warnings, or a clear error", "[corpus][gltf]") {
  fs::path const folder = corpus_folder();
  if (folder.empty()) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real models");
  std::ifstream index(folder / "INDEX.tsv");
  REQUIRE(index);
  std::map<std::string, std::string> found;
  std::string line;
  std::getline(index, line);
  std::deque<Child> children;
  auto const finish_first = [&] {
    found[children.front().path] = outcome_of(children.front());
    children.pop_front();
  };
  while (std::getline(index, line)) {
    if (children.size() >= std::thread::hardware_concurrency()) finish_first();
    children.push_back(start_child(folder, split(line).at(1)));
  }
  while (!children.empty()) finish_first();
  REQUIRE(found.size() > 1000);

  std::map<std::string, std::string> recorded;
  std::ifstream in(outcomes_file);
  while (std::getline(in, line)) {
    std::size_t const tab = line.find('\t');
    recorded[line.substr(0, tab)] = line.substr(tab + 1);
  }
  for (auto const& [path, outcome] : found) {
    INFO(path);
    CHECK(outcome == recorded[path]);
  }
  if (found != recorded) {  // for `git diff --no-index`, and to become the new record when the change is meant
    fs::create_directories(artifact_path(""));
    std::ofstream out(artifact_path("gltf_corpus_outcomes.tsv"));
    for (auto const& [path, outcome] : found) out << path << '\t' << outcome << '\n';
  }
}

TEST_CASE("every encoding of one set of triangles gives exactly these", "[corpus][gltf]") {
  fs::path const folder = corpus_folder();
  if (folder.empty()) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real models");
  std::ifstream in(folder / "own/equiv/expected.json");
  REQUIRE(in);
  auto const expected = nlohmann::json::parse(in);
  std::size_t compared = 0;
  for (auto const& [name, entry] : expected["files"].items()) {
    if (!fs::exists(folder / "own/equiv" / name)) continue;
    // A list of triangles, or words about the set that most of them show: "base", "base + base translated (10,0,0)".
    auto triangles = entry.is_string() ? expected["base"] : entry;
    if (entry.is_string() && entry.get<std::string>().find("translated (10,0,0)") != std::string::npos) {
      for (auto triangle : expected["base"]) {
        for (auto& corner : triangle) corner[0] = corner[0].get<double>() + 10;
        triangles.push_back(triangle);
      }
    }
    ModelOptions options;
    options.allowed_paths = {folder / "own/equiv"};  // one of them refers to a file above its folder
    std::vector<testing::Corners> found = testing::world_triangles(load_gltf(folder / "own/equiv" / name, options));
    INFO(name);
    REQUIRE(found.size() == triangles.size());
    ++compared;
    for (auto const& triangle : triangles) {
      testing::Corners wanted;
      for (std::size_t i = 0; i < 3; ++i) wanted[i] = {triangle[i][0], triangle[i][1], triangle[i][2]};
      auto const same = std::find_if(found.begin(), found.end(), [&](testing::Corners const& candidate) {
        return testing::is_same_triangle(candidate, wanted, 2e-6);
      });
      INFO(triangle.dump());
      REQUIRE(same != found.end());
      found.erase(same);
    }
  }
  CHECK(compared >= 30);
}
