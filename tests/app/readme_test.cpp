#include <filesystem>
#include <regex>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"

// What README.md shows is true.

namespace {

std::string replace_all(std::string text, std::string const& from, std::string const& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

TEST_CASE("README.md shows the scene that made its picture", "[app][docs]") {
  std::string const scene = read_project_file("scenes/hello.sdf");
  CHECK(read_project_file("README.md").find("```\n" + scene + "```\n") != std::string::npos);
}

TEST_CASE("the commands in README.md are understood", "[app][docs]") {
  Lichtraum const lichtraum;
  // A faulty scene shows that the command line was understood, without drawing for long.
  lichtraum.folder.write("scene.sdf", "define nonsense\n");
  lichtraum.folder.write("model.glb", "no model");
  lichtraum.folder.write("planes.exr", "no planes");
  std::filesystem::create_directory_symlink(project_path("scenes"), lichtraum.folder / "scenes");  // for the window
  std::string const readme = read_project_file("README.md");
  std::regex const command("`lichtraum ([^`<]*?)( <[^`]*)?`");
  int count = 0;
  for (std::sregex_iterator it(readme.begin(), readme.end(), command), end; it != end; ++it) {
    std::string words = (*it)[1];
    if (words == "doctor" || words == "render") continue;  // long, and tested by itself; the name of the command
    words = replace_all(words, "*.sdf", "scene.sdf");
    words = replace_all(words, " --device gpu", " --device reference");  // not every machine has one
    INFO(words);
    bool const reads_scene = words.find("scene.sdf") != std::string::npos ||
                             words.find("model.glb") != std::string::npos || words.find("render - ") == 0 ||
                             words.find("denoise planes.exr") == 0;
    Process process = lichtraum.process(words);
    process.input = "define nonsense\n";
    process.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
    int const code = run_process(process).exit_code;
    bool const opens_window = words.find("view ") == 0;  // which is refused without a display
    CHECK(code == (opens_window ? 69 : reads_scene ? 65 : 0));
    ++count;
  }
  CHECK(count >= 10);
}

TEST_CASE("README.md shows mistakes as the program does", "[app][docs]") {
  std::string const readme = read_project_file("README.md");
  std::string const prompt = "$ lichtraum check scene.sdf\n";
  std::size_t const begin = readme.find(prompt);
  REQUIRE(begin != std::string::npos);
  std::string const shown = readme.substr(begin + prompt.size(), readme.find("```", begin) - begin - prompt.size());

  Lichtraum const lichtraum;
  std::string scene = read_project_file("scenes/hello.sdf");
  std::size_t const last_white = scene.find("300 0 300        white") + std::string("300 0 300        whit").size();
  scene.erase(last_white, 1);
  scene = replace_all(scene, "red   -7 9 6   0.72 0.1 0.12", "red -7 9 6 0.72 0.1");
  lichtraum.folder.write("scene.sdf", scene);
  auto const result = lichtraum("check scene.sdf");
  CHECK(result.exit_code == 65);
  CHECK(result.err + result.out == shown);
}
