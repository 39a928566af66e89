#include <sys/stat.h>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/skip.hpp"

namespace {

/// A ball beside the middle of a picture of that size.
std::string scene_of(int width, int height) {
  return "define material red 1 0 0 0.5 0 0 0 0 0 1\ndefine shape sphere ball 0.5 0 -3 0.5 red\n"
         "define light ambient sky 1 1 1\ndefine background 0 0 1\ndefine camera eye 60 " +
         std::to_string(width) + " " + std::to_string(height) + "\n";
}

/// Without OpenCL, as most of what thumbnails are needs none.
ProcessResult thumbnail(Lichtraum const& lichtraum, std::vector<std::string> const& arguments) {
  Process process = lichtraum.process("thumbnail --device reference");
  process.arguments.insert(process.arguments.end(), arguments.begin(), arguments.end());
  process.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  return run_process(process);
}

bool is_one_line(std::string const& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

}  // namespace

TEST_CASE("a thumbnail fits into a square and keeps the picture's proportions", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  auto const size_of = [&](int width, int height, std::vector<std::string> const& words = {}) {
    lichtraum.folder.write("scene.sdf", scene_of(width, height));
    std::vector<std::string> arguments = words;
    arguments.insert(arguments.end(), {"scene.sdf", "small.png"});
    auto const result = thumbnail(lichtraum, arguments);
    REQUIRE(result.exit_code == 0);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    auto const picture = decode(lichtraum.folder.read("small.png"));
    return std::pair(picture.width, picture.height);
  };
  CHECK(size_of(1280, 720) == std::pair(256, 144));
  CHECK(size_of(100, 400) == std::pair(64, 256));
  CHECK(size_of(16, 8) == std::pair(256, 128));
  CHECK(size_of(9999, 2) == std::pair(256, 1));
  CHECK(size_of(200, 100, {"--size", "32"}) == std::pair(32, 16));
  CHECK(size_of(200, 100, {"--size", "1"}) == std::pair(1, 1));
  lichtraum.folder.write("scene.sdf", "define camera eye 60\nrender eye a.png\n");  // a size of none
  REQUIRE(thumbnail(lichtraum, {"scene.sdf", "small.png"}).exit_code == 0);
  auto const picture = decode(lichtraum.folder.read("small.png"));
  CHECK(std::pair(picture.width, picture.height) == std::pair(256, 192));
}

TEST_CASE("a thumbnail is the scene's first picture, antialiased", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write(
      "film.sdf", scene_of(200, 100) + "render eye a.ppm\ntransform ball translate 9 0 0\n" + "render eye b.ppm\n");
  REQUIRE(thumbnail(lichtraum, {"--size", "64", "film.sdf", "small.png"}).exit_code == 0);
  REQUIRE(lichtraum.render("film.sdf --size 64x32 --samples 3x3").exit_code == 0);
  CHECK(decode(lichtraum.folder.read("small.png")).values == decode(lichtraum.folder.read("a.ppm")).values);
}

TEST_CASE("a model's thumbnail is drawn by paths, and denoised", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  if (lichtraum("devices --json").out.find("\"cpu\"") == std::string::npos) SKIP_TEST("no OpenCL device");
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0});
  lichtraum.folder.write("square.glb", writer.glb());
  REQUIRE(lichtraum("thumbnail square.glb small.png --size 64").exit_code == 0);
  REQUIRE(lichtraum("render square.glb -o large.png --size 64x48 --samples 16 --depth 8 --denoise builtin").exit_code ==
          0);
  CHECK(decode(lichtraum.folder.read("small.png")).values == decode(lichtraum.folder.read("large.png")).values);
}

TEST_CASE("a thumbnail's files are called as file managers call them", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  std::string const name = "50% größer #1.sdf";
  lichtraum.folder.write(name, scene_of(20, 10));
  std::string const folder = lichtraum.folder.path();
  // What is there already is replaced, and a PNG whatever it is called.
  lichtraum.folder.write(".tmp.XYZ", "");
  REQUIRE(thumbnail(lichtraum, {name, ".tmp.XYZ"}).exit_code == 0);
  std::string const picture = lichtraum.folder.read(".tmp.XYZ");
  CHECK(picture.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  for (std::string const start : {"file://", "file:", "FILE://localhost"}) {
    INFO(start);
    REQUIRE(thumbnail(lichtraum, {start + folder + "/50%25%20gr%C3%B6%C3%9fer%20%231.sdf", "uri.png"}).exit_code == 0);
    CHECK(lichtraum.folder.read("uri.png") == picture);
    std::filesystem::remove(lichtraum.folder / "uri.png");
  }
  // A path is no URI: nothing in it is decoded.
  CHECK(thumbnail(lichtraum, {folder + "/50%25%20gr%C3%B6%C3%9fer%20%231.sdf", "uri.png"}).exit_code == 66);
  CHECK(lichtraum.folder.names() == std::vector<std::string>{".tmp.XYZ", name});
}

TEST_CASE("a thumbnail that fails leaves the old one, and says why in one line", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", scene_of(20, 10));
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  lichtraum.folder.write("bad.glb", "glTF");
  lichtraum.folder.write("old.png", "old");
  auto const fails = [&](int code, std::vector<std::string> const& arguments, std::string const& message) {
    INFO(message);
    auto const result = thumbnail(lichtraum, arguments);
    CHECK(result.exit_code == code);
    CHECK(result.out.empty());
    if (code != 65 && code != 69) CHECK(is_one_line(result.err));
    CHECK_THAT(result.err, contains_text(message));
  };
  fails(64, {}, "no file is given");
  fails(64, {"scene.sdf"}, "expected two files");
  fails(64, {"scene.sdf", "old.png", "old.png"}, "expected two files");
  for (char const* const size : {"0", "-1", "2049", "256x256", "", "99999999999"}) {
    fails(64, {"scene.sdf", "old.png", "--size", size}, "--size: expected a whole number from 1 to 2048");
  }
  fails(65, {"bad.sdf", "old.png"}, "bad.sdf:1:8: error: ");
  fails(65, {"bad.glb", "old.png"}, "bad.glb");
  fails(66, {"none.sdf", "old.png"}, "none.sdf");
  fails(66, {"file:///none/a%20b.sdf", "old.png"}, "/none/a b.sdf");
  fails(66, {"file://elsewhere/scene.sdf", "old.png"}, "another machine, 'elsewhere'");
  fails(66, {"file:///tmp/a%00b", "old.png"}, "names no file");
  fails(69, {"--device", "abacus", "scene.sdf", "old.png"}, "'abacus'");
  fails(73, {"scene.sdf", "missing/small.png"}, "missing");
  fails(73, {"scene.sdf", "."}, "'.'");
  CHECK(lichtraum.folder.read("old.png") == "old");
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"bad.glb", "bad.sdf", "old.png", "scene.sdf"});
}

TEST_CASE("a thumbnail takes no more than 4 GiB of memory", "[app][thumbnail]") {
  Lichtraum const lichtraum;
  std::filesystem::resize_file(lichtraum.folder.write("huge.sdf", ""), std::uintmax_t(5) << 30);  // it takes no room
  auto const result = thumbnail(lichtraum, {"huge.sdf", "small.png"});
  CHECK(result.exit_code == 74);  // and 65 without a limit
  CHECK(is_one_line(result.err));
  CHECK_THAT(result.err, contains_text("cannot read 'huge.sdf': not enough memory"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"huge.sdf"});
}

TEST_CASE("a thumbnail that takes longer than 20 s is given up", "[app][thumbnail][long]") {
  Lichtraum const lichtraum;
  REQUIRE(::mkfifo((lichtraum.folder / "silent.sdf").c_str(), 0600) == 0);
  auto const result = thumbnail(lichtraum, {"silent.sdf", "small.png"});
  CHECK(result.exit_code == 70);
  CHECK(is_one_line(result.err));
  CHECK_THAT(result.err, contains_text("no thumbnail after 20 s"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"silent.sdf"});
}
