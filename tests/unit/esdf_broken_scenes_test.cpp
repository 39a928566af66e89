#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/read_file.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// How far somebody has to look for a mistake: scenes are broken by one slip of a hand each, and the first error must
// be where that was.

using namespace lichtraum;
using namespace lichtraum::test;
namespace fs = std::filesystem;

namespace {

constexpr int scene_count = 40;
constexpr int found_at_least = 38;

using Random = std::mt19937;

/// A place from `begin` to before `end`. The standard's distributions differ between libraries.
std::size_t choose(Random& random, std::size_t begin, std::size_t end) { return begin + random() % (end - begin); }

/// The files below a folder that load, in a fixed order.
std::vector<std::string> good_scenes(fs::path const& folder) {
  std::vector<fs::path> paths;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    fs::path const extension = entry.path().extension();
    if (extension == ".sdf" || extension == ".txt") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (fs::path const& path : paths) {
    std::string text = read_file(path);
    if (text.find('\r') == std::string::npos && loads(text)) texts.push_back(std::move(text));
  }
  return texts;
}

struct Edit {
  std::string text;
  std::size_t line = 0;  ///< from 1
  std::string before, after;
};

/// Where the words of a line are, up to a comment: begin and end.
std::vector<std::pair<std::size_t, std::size_t>> words_of(std::string const& line) {
  std::vector<std::pair<std::size_t, std::size_t>> words;
  std::size_t const end = std::min(line.find('#'), line.size());
  for (std::size_t at = 0; at < end;) {
    std::size_t const begin = line.find_first_not_of(" \t", at);
    if (begin >= end) break;
    at = std::min(line.find_first_of(" \t#", begin), end);
    words.emplace_back(begin, at);
  }
  return words;
}

/// One slip in a word, or between two.
std::string slipped(Random& random, std::string line) {
  auto const words = words_of(line);
  auto const [begin, end] = words[choose(random, 0, words.size())];
  std::size_t const at = choose(random, begin, end);
  switch (random() % 8) {
    case 0:  // a key missed
      return line.erase(at, 1);
    case 1:  // the key beside
      return line.replace(at, 1, 1, char('a' + random() % 26));
    case 2:  // two keys at once
      return line.insert(at, 1, char('a' + random() % 26));
    case 3:  // two keys in the wrong order
      if (at + 1 < end) std::swap(line[at], line[at + 1]);
      return line;
    case 4:  // a word forgotten
      return line.erase(begin, end - begin);
    case 5:  // a word twice
      return line.insert(end, " " + line.substr(begin, end - begin));
    case 6:  // no blank between two words
      return end < line.size() ? line.erase(end, 1) : line;
    default:  // another keyboard's decimal point
      std::replace(line.begin(), line.end(), '.', ',');
      return line;
  }
}

/// A scene that has errors by one slip in one line.
Edit broken(Random& random, std::vector<std::string> const& scenes) {
  for (;;) {
    std::string const& scene = scenes[choose(random, 0, scenes.size())];
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 0; i + 1 < scene.size(); ++i) {
      if (scene[i] == '\n') begins.push_back(i + 1);
    }
    std::size_t const number = choose(random, 0, begins.size());
    std::size_t const begin = begins[number];
    std::string const line = scene.substr(begin, scene.find('\n', begin) - begin);
    if (words_of(line).empty()) continue;
    Edit edit{scene, number + 1, line, slipped(random, line)};
    edit.text.replace(begin, line.size(), edit.after);
    if (!loads(edit.text)) return edit;
  }
}

std::size_t first_error_line(std::string const& text) {
  for (Diagnostic const& d : findings(text)) {
    if (d.severity == Severity::error) return d.location.line;
  }
  return 0;
}

void check_where_errors_are(std::vector<std::string> const& scenes) {
  REQUIRE(scenes.size() >= 10);
  Random random(1);
  int found = 0;
  std::string missed;
  for (int i = 0; i < scene_count; ++i) {
    Edit const edit = broken(random, scenes);
    std::size_t const line = first_error_line(edit.text);
    if (line == edit.line) {
      ++found;
    } else {
      missed += "line " + std::to_string(edit.line) + ", found in " + std::to_string(line) + ":\n  " + edit.before +
                "\n  " + edit.after + "\n";
    }
  }
  INFO(missed);
  CHECK(found >= found_at_least);
}

}  // namespace

TEST_CASE("the first error is in the line that was broken", "[unit][esdf][broken]") {
  check_where_errors_are(good_scenes(project_path("scenes")));
}

TEST_CASE("the first error is in the line that was broken, in real scenes", "[unit][esdf][broken][corpus]") {
  char const* const corpus = std::getenv("LICHTRAUM_CORPUS");
  if (!corpus) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real scene files");
  check_where_errors_are(good_scenes(fs::path(corpus) / "esdf"));
}
