#include <filesystem>
#include <set>
#include <string>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/pseudo_terminal.hpp"
#include "support/skip.hpp"

TEST_CASE("a scene names its pictures below the output folder", "[app][output]") {
  Lichtraum const lichtraum;
  std::filesystem::create_directories(lichtraum.folder / "out/sub");
  std::filesystem::create_directory(lichtraum.folder / "other");
  auto const draws = [&](std::string const& words, std::string const& file) {
    return lichtraum.render("- " + words, "define camera eye 60 4 3\nrender eye " + file + "\n").exit_code;
  };
  auto const exists = [&](char const* name) { return std::filesystem::exists(lichtraum.folder / name); };
  CHECK(draws("--output-dir out", "a.ppm") == 0);
  CHECK(exists("out/a.ppm"));
  CHECK(draws("--output-dir out", "sub/a.ppm") == 0);
  CHECK(exists("out/sub/a.ppm"));
  CHECK(draws("--output-dir out -o b.png", "a.ppm") == 0);
  CHECK(exists("out/b.png"));
  std::string const absolute = (lichtraum.folder / "other/a.ppm").string();
  CHECK(draws("--output-dir out", absolute) == 65);
  CHECK(!exists("other/a.ppm"));
  CHECK(draws("--output-dir out --allow-path other", absolute) == 0);
  CHECK(exists("other/a.ppm"));
  CHECK(draws("--output-dir out --allow-path sub --allow-path other", "../other/b.ppm") == 0);
  CHECK(exists("other/b.ppm"));
  std::filesystem::create_directory_symlink(lichtraum.folder / "other", lichtraum.folder / "out/link");
  CHECK(draws("--output-dir out", "link/c.ppm") == 65);
  CHECK(!exists("other/c.ppm"));
  CHECK(draws("--format exr", "a.ppm") == 0);
  CHECK(decode(lichtraum.folder.read("a.exr")).width == 4);
}

TEST_CASE("a name without a known extension becomes a PNG, and that is said", "[app][output]") {
  Lichtraum const lichtraum;
  auto const result = lichtraum.render("-", "define camera eye 60 4 3\nrender eye image\n");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, contains_text("'image.png' is written instead"));
  CHECK(decode(lichtraum.folder.read("image.png")).width == 4);
}

TEST_CASE("a file without render draws its first camera to <scene>.png", "[app][output]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("my.scene.sdf", "define camera a 60 4 3\ndefine camera b 60 5 3\n");
  CHECK(lichtraum.render("my.scene.sdf").exit_code == 0);
  CHECK(decode(lichtraum.folder.read("my.scene.png")).width == 4);
}

TEST_CASE("what follows -- are files, whatever they begin with", "[app][output]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("-q.sdf", ball_scene);
  CHECK(lichtraum.render("-- -q.sdf").exit_code == 0);
  CHECK(decode(lichtraum.folder.read("ball.ppm")).width == 32);
  CHECK(lichtraum("check -- -q.sdf").exit_code == 0);
  CHECK(lichtraum("check --").exit_code == 64);
  CHECK_THAT(lichtraum("check -- -q.sdf --strict").err, contains_text("--strict"));  // which is no file
}

TEST_CASE("a window is opened on a file that is there", "[app][view]") {
  Lichtraum const lichtraum;
  Process process = lichtraum.process("view nope.sdf");
  process.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  auto const result = run_process(process);
  CHECK(result.exit_code == 66);
  CHECK(result.err == "lichtraum: error: cannot open 'nope.sdf': No such file or directory [E0206]\n");
}

TEST_CASE("a terminal is spared the bytes of a picture", "[app][output]") {
  if (!has_pseudo_terminals()) SKIP_TEST("there are no pseudo-terminals here");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const result = run_in_terminal({}, lichtraum.process("render --device reference a.sdf -o -"));
  CHECK(result.exit_code == 64);
  CHECK_THAT(result.out, contains_text("lichtraum preview"));
  CHECK(result.out.find("PNG\r\n") == std::string::npos);
}

TEST_CASE("an animation draws its pictures in order", "[app][output]") {
  Lichtraum const lichtraum;
  std::string const move = std::string(ball_scene) + "transform ball translate 9 0 0\n";
  std::string const scene = move + "render eye late.ppm 32 24\n";
  REQUIRE(lichtraum.render("-", scene).exit_code == 0);
  CHECK(red_in_the_middle(decode(lichtraum.folder.read("ball.ppm"))) > 0);
  CHECK(red_in_the_middle(decode(lichtraum.folder.read("late.ppm"))) == 0);
  REQUIRE(lichtraum.render("- -o %03d.png", scene).exit_code == 0);
  CHECK(decode(lichtraum.folder.read("001.png")).values == decode(lichtraum.folder.read("ball.ppm")).values);
  CHECK(decode(lichtraum.folder.read("002.png")).values == decode(lichtraum.folder.read("late.ppm")).values);
  // On standard output one follows the other.
  auto const both = lichtraum.render("- -o - --format ppm", scene);
  CHECK(both.out == lichtraum.folder.read("ball.ppm") + lichtraum.folder.read("late.ppm"));
  auto const same = lichtraum.render("-", move + "render eye ball.ppm 32 24\n");
  CHECK(same.exit_code == 0);
  CHECK_THAT(same.err, contains_text("several pictures are called 'ball.ppm'"));
  CHECK(lichtraum.folder.read("ball.ppm") == lichtraum.folder.read("late.ppm"));
  // Of two scenes as well, but not of two that have pictures of their own.
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("b.sdf", move + "render eye late.ppm 32 24\n");
  CHECK_THAT(lichtraum.render("a.sdf b.sdf").err, contains_text("several pictures are called 'ball.ppm'"));
  lichtraum.folder.write("b.sdf",
                         std::string(ball_scene).replace(std::string(ball_scene).find("ball.ppm"), 8, "b.ppm"));
  CHECK(lichtraum.render("a.sdf b.sdf").err.find("several pictures") == std::string::npos);
  REQUIRE(lichtraum.render("- -o 100%%-%d.png", ball_scene).exit_code == 0);
  CHECK(std::filesystem::exists(lichtraum.folder / "100%-1.png"));
}

TEST_CASE("models that share a name get pictures of their own", "[app][output]") {
  Lichtraum const lichtraum;
  std::string const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::string const stl =
      "solid t\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid t\n";
  for (char const* const folder : {"pictures", "chair/new", "table/new", "table/old"}) {
    std::filesystem::create_directories(lichtraum.folder / folder);
  }
  for (char const* const file : {"chair/new/scene.obj", "table/new/scene.obj", "table/old/scene.obj", "lamp.obj"}) {
    lichtraum.folder.write(file, triangle);
  }
  lichtraum.folder.write("lamp.stl", stl);
  struct Case {
    std::string inputs;
    std::set<std::string> pictures;
    bool is_warned_of = false;
  };
  Case const cases[] = {
      {"chair/new/scene.obj", {"scene.png"}},
      {"chair/new/scene.obj lamp.obj", {"lamp.png", "scene.png"}},
      {"table/new/scene.obj table/old/scene.obj", {"new_scene.png", "old_scene.png"}},
      {"chair/new/scene.obj table/new/scene.obj lamp.obj", {"chair_new_scene.png", "lamp.png", "table_new_scene.png"}},
      {"lamp.obj lamp.stl", {"lamp_obj.png", "lamp_stl.png"}},
      // One file is drawn as often as it is named, and its picture is the same.
      {"lamp.obj ./lamp.obj", {"lamp.png"}, true},
      {"lamp.obj chair/../lamp.obj lamp.stl", {"lamp_obj.png", "lamp_stl.png"}, true},
  };
  for (Case const& c : cases) {
    CAPTURE(c.inputs);
    auto const result = lichtraum.render("--device reference --size 4x4 --output-dir pictures " + c.inputs);
    CHECK(result.exit_code == 0);
    CHECK((result.err.find("several pictures are called") != std::string::npos) == c.is_warned_of);
    std::set<std::string> found;
    for (auto const& entry : std::filesystem::directory_iterator(lichtraum.folder / "pictures")) {
      found.insert(entry.path().filename().string());
      std::filesystem::remove(entry.path());
    }
    CHECK(found == c.pictures);
    auto const check = lichtraum("check --size 4x4 --output-dir pictures " + c.inputs);
    for (std::string const& picture : c.pictures) CHECK_THAT(check.out, contains_text("pictures/" + picture));
  }
}

TEST_CASE("a file is kept whose name is that of an unfinished picture", "[app][output]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.partial.png", ball_scene);
  auto const result = lichtraum.render("ball.partial.png -o ball.png");
  CHECK(result.exit_code == 73);
  CHECK_THAT(result.err, contains_text("'ball.partial.png' is read for this picture"));
  CHECK(lichtraum.folder.read("ball.partial.png") == ball_scene);
  lichtraum.folder.write("other.partial.ppm", "somebody's");
  CHECK(lichtraum.render("ball.partial.png -o other.ppm").exit_code == 0);
  CHECK(lichtraum.folder.read("other.partial.ppm") == "somebody's");
}
