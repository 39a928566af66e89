#include <filesystem>
#include <string>
#include <vector>

#include "core/read_file.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/project_files.hpp"

// What docs/ESDF.md and scenes/ show is true.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct Block {
  std::string tag;
  std::string text;
};

/// The fenced blocks of a Markdown text.
std::vector<Block> fenced_blocks(std::string const& markdown) {
  std::vector<Block> blocks;
  std::string const fence = "```";
  std::size_t at = 0;
  while ((at = markdown.find("\n" + fence, at)) != std::string::npos) {
    std::size_t const tag = at + 1 + fence.size();
    std::size_t const begin = markdown.find('\n', tag) + 1;
    std::size_t const end = markdown.find(fence + "\n", begin);
    REQUIRE(end != std::string::npos);
    blocks.push_back({markdown.substr(tag, begin - 1 - tag), markdown.substr(begin, end - begin)});
    at = end + fence.size();
  }
  return blocks;
}

std::string formatted(std::vector<Diagnostic> const& diagnostics) {
  std::string result;
  for (Diagnostic const& diagnostic : diagnostics) result += format_diagnostic(diagnostic);
  return result;
}

/// Everything found in `text`, notes included.
std::string all_findings(std::string const& text) {
  try {
    return formatted(EsdfScript::from_text(text, "scene.sdf").diagnostics());
  } catch (SceneError const& error) {
    return formatted(error.diagnostics());
  }
}

}  // namespace

TEST_CASE("the examples of docs/ESDF.md are right", "[unit][esdf][docs]") {
  auto const blocks = fenced_blocks(read_project_file("docs/ESDF.md"));
  int scenes = 0;
  int errors = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    INFO(blocks[i].text);
    if (blocks[i].tag == "esdf") {
      CHECK(all_findings(blocks[i].text).empty());
      Scene const scene = scene_of(blocks[i].text);
      CHECK_FALSE(scene.renders.empty());
      CHECK_FALSE(scene.roots().empty());
      ++scenes;
    } else if (blocks[i].tag == "esdf-dialect") {
      CHECK(loads(blocks[i].text));
      CHECK_FALSE(findings(blocks[i].text).empty());
      CHECK(shown(blocks[i].text).empty());
      ++scenes;
    } else if (blocks[i].tag == "esdf-error") {
      REQUIRE(i + 1 < blocks.size());
      REQUIRE(blocks[i + 1].tag == "text");
      CHECK(all_findings(blocks[i].text) == blocks[i + 1].text);
      ++errors;
    }
  }
  CHECK(scenes >= 7);
  CHECK(errors >= 3);
}

TEST_CASE("the scenes beside the program are free of problems", "[unit][esdf][docs]") {
  int count = 0;
  for (auto const& entry : std::filesystem::directory_iterator(project_path("scenes"))) {
    if (entry.path().extension() != ".sdf") continue;
    INFO(entry.path());
    CHECK(shown(read_file(entry.path())).empty());
    ++count;
  }
  CHECK(count > 0);
}
