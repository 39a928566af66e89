#include <sys/stat.h>

#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/temporary_folder.hpp"

// Sizes at which anything quadratic would take hours, and anything recursive would run out of stack; and what keeps its
// reader waiting.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// Sanitizers, which see what is wrong with a tenth as well, and take twenty times as long, get that.
#ifdef LICHTRAUM_SANITIZED
constexpr int million = 100'000;
#else
constexpr int million = 1'000'000;
#endif

std::string name(int i) { return "c" + std::to_string(i); }

}  // namespace

TEST_CASE("composites nested 100,000 deep", "[unit][esdf][hostile]") {
  std::string text = red + "define shape sphere c0 0 0 0 1 red\n";
  for (int i = 1; i <= 100'000; ++i) {
    text += "define shape composite " + name(i) + ' ' + name(i - 1) + '\n';
    text += "transform " + name(i) + " translate 1 0 0\n";
  }
  Scene const scene = scene_of(text);
  CHECK(scene.shapes.size() == 100'001);
  CHECK(scene.roots().size() == 1);
}

TEST_CASE("a chain of composites that redefinitions turn round", "[unit][esdf][hostile]") {
  constexpr int count = 100'000;
  std::string text = red;
  for (int i = 0; i < count; ++i) text += "define shape sphere " + name(i) + " 0 0 0 1 red\n";
  // The first in the registry holds the second, and so on: the last to be destroyed is the top of the chain.
  for (int i = count - 2; i >= 0; --i) text += "define shape composite " + name(i) + ' ' + name(i + 1) + '\n';
  Scene const scene = scene_of(text, keep_going);
  CHECK(scene.roots().size() == 1);
}

TEST_CASE("a composite with a million children", "[unit][esdf][hostile]") {
  std::string text = red + "define shape sphere s 0 0 0 1 red\ndefine shape composite c";
  for (int i = 0; i < million; ++i) text += " s";
  Scene const scene = scene_of(text);
  CHECK(dynamic_cast<Composite const&>(**scene.shapes.find("c")).children().size() == million);
}

TEST_CASE("a million mistakes", "[unit][esdf][hostile]") {
  std::string text = red;
  for (int i = 0; i < million / 10; ++i)
    text += "define shape sphere sphere_number_" + std::to_string(i) + " 0 0 0 1 red\n";
  for (int i = 0; i < million; ++i) text += "transform sphere_numbre_" + std::to_string(i) + " scale 2\n";
  CHECK(findings(text).size() == 101);
  auto const kept = findings(text, keep_going);
  REQUIRE(kept.size() == 101);
  CHECK(kept[0].hint == "did you mean 'sphere_number_0'?");
  CHECK(kept[100].message == "too many to show: " + std::to_string(million - 100) + " more errors");
}

TEST_CASE("a million undefined children in one line", "[unit][esdf][hostile]") {
  std::string text = "define shape composite c";
  for (int i = 0; i < million; ++i) text += " x" + std::to_string(i);
  CHECK(findings(text).size() == 101);
  CHECK(findings(text, keep_going).size() == 101);
}

TEST_CASE("a million duplicates", "[unit][esdf][hostile]") {
  std::string text = red;
  for (int i = 0; i < million; ++i) text += "define shape sphere s 0 0 0 1 red\n";
  Scene const scene = scene_of(text, keep_going);
  CHECK(scene.shapes.size() == 1);
}

TEST_CASE("a million dialects and unnamed lights", "[unit][esdf][hostile]") {
  std::string text;
  for (int i = 0; i < million; ++i) text += "ambient 1 0 0\n";
  Scene const scene = scene_of(text);
  CHECK(scene.lights.size() == million);
  CHECK(findings(text).size() == 100);
}

TEST_CASE("lines of 10 MB", "[unit][esdf][hostile]") {
  constexpr std::size_t size = 10 * million;
  CHECK(findings("#" + std::string(size, 'x')).empty());
  CHECK(findings(std::string(size, ' ')).empty());
  CHECK(findings("define camera eye 45" + std::string(size, '\t')).empty());
  CHECK(findings(std::string(size, 'x')).size() == 1);
  CHECK(findings("define camera eye 4" + std::string(size, '5')).size() == 1);
  CHECK(findings("define camera eye 4." + std::string(size, '5')).empty());
  CHECK(findings("define camera " + std::string(size, 'x') + " 45").empty());
  CHECK(findings("define shape sphere s 0 0 0 1 " + std::string(size, 'x')).size() == 1);
  std::string braces;
  while (braces.size() < size) braces += "{{ ";
  CHECK(findings("x " + braces).size() == 1);
  std::string numbers = "define material a";
  while (numbers.size() < size) numbers += " 1";
  CHECK(findings(numbers).size() == 1);
  std::string words = "render eye";
  while (words.size() < size) words += " x";
  CHECK(findings(eye + words).size() == 1);
}

TEST_CASE("ten million empty lines, and lone carriage returns", "[unit][esdf][hostile]") {
  for (std::string const end : {"\n", "\r", "\r\n"}) {
    std::string text;
    for (int i = 0; i < 10 * million; ++i) text += end;
    auto const found = findings(text + "nonsense");
    REQUIRE(found.size() == 1);
    CHECK(found[0].location.line == 10 * million + 1);
  }
}

TEST_CASE("an animation of many frames", "[unit][esdf][hostile]") {
  std::string text = red + eye + "define shape sphere s 0 0 0 1 red\n";
  for (int i = 0; i < 100'000; ++i) text += "render eye a.png 8 8\ntransform s rotate 1 y\n";
  EsdfScript const script = EsdfScript::from_text(text, "s.sdf");
  int frames = 0;
  script.play([&](Scene const&, RenderCommand const&) { return ++frames, true; });
  CHECK(frames == 100'000);
}

TEST_CASE("what is no file is not waited for", "[unit][esdf][hostile]") {
  TemporaryFolder const folder;
  REQUIRE(::mkfifo((folder / "silent.obj").c_str(), 0600) == 0);
  REQUIRE(::mkfifo((folder / "silent.hdr").c_str(), 0600) == 0);
  for (std::string const line : {"define shape mesh m silent.obj\n", "define light environment e silent.hdr\n"}) {
    try {
      EsdfScript::from_text(line, "s.sdf", {}, folder.path());
      FAIL("it was read");
    } catch (SceneError const& error) {
      REQUIRE(count_errors(error.diagnostics()) == 1);
      CHECK_THAT(error.diagnostics().back().message, contains_text("it is not a regular file"));
      CHECK(error.diagnostics().back().code == DiagnosticCode::unreadable_file);
    }
  }
}
