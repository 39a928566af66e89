#include <algorithm>
#include <cmath>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

namespace {

/// A ball beside the middle, on a floor.
constexpr char const* scene_without_camera =
    "define material red 0 0 0  0.8 0.1 0.1  0 0 0  1\n"
    "define material grey 0 0 0  0.5 0.5 0.5  0 0 0  1\n"
    "define shape sphere ball 0.5 0 0  1 red\n"
    "define shape box floor -60 -2 -60  60 -1 60 grey\n"
    "define light diffuse sun 3 6 5  1 1 1\n"
    "define background 0.1 0.2 0.4\n";
constexpr char const* camera = "define camera eye 50 320 240\ntransform eye translate 0 0.5 6\n";

/// Mean of the differences, of 255, in rows [first, last).
double difference(DecodedImage const& a, DecodedImage const& b, int first = 0, int last = 240) {
  double sum = 0;
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < 320; ++x) {
      for (int channel = 0; channel < 3; ++channel) sum += std::abs(double(a.at(x, y, channel) - b.at(x, y, channel)));
    }
  }
  return sum / (3.0 * 320 * (last - first));
}

ProcessResult run_without_display(Lichtraum const& lichtraum, std::string const& words) {
  Process process = lichtraum.process(words);
  process.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  return run_process(process);
}

}  // namespace

TEST_CASE("without a display or without its program, a window is refused in one line", "[app][view]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", std::string(scene_without_camera) + camera);
  auto const result = run_without_display(lichtraum, "view scene.sdf");
  CHECK(result.exit_code == 69);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(lichtraum("view -").exit_code == 64);
  CHECK(lichtraum("view scene.sdf --nonsense").exit_code == 64);
}

TEST_CASE("what a window cannot show is refused before anything is drawn", "[app][view]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", std::string(scene_without_camera) + camera);
  for (char const* const words :
       {"scene.sdf scene.sdf --show --output-dir .", "- --show", "scene.sdf --show --turntable 3",
        "scene.sdf --show --region 0,0,8,8", "scene.sdf --show --planes depth"}) {
    INFO(words);
    auto const result = lichtraum(std::string("render ") + words);
    CHECK(result.exit_code == 64);
    CHECK_THAT(result.err, contains_text("--show: "));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  }
  CHECK(!std::filesystem::exists(lichtraum.folder / "scene.png"));
}

TEST_CASE("without a display, --show draws the picture and then says what is missing", "[app][view]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", std::string(scene_without_camera) + camera);
  auto const result = run_without_display(lichtraum, "render -q scene.sdf --show");
  CHECK(result.exit_code == 69);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(decode(lichtraum.folder.read("scene.png")).width == 320);
}

#ifdef LICHTRAUM_HAS_WINDOW
namespace {

/// Why no script can use a window; empty when one can.
std::string obstacle() {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) return std::string(program) + " is not installed";
  }
  return {};
}

/// Runs a script of this folder that uses a window, and keeps the pictures that it makes.
void use_window(Lichtraum const& lichtraum, char const* script, std::initializer_list<char const*> pictures) {
  Process process;
  process.arguments = {project_path("tests/app/" + std::string(script)), LICHTRAUM_PROGRAM, lichtraum.folder.path()};
  process.timeout_seconds = 150;
  auto const result = run_process(process);
  std::filesystem::path const artifacts = artifact_path("view");
  std::filesystem::create_directories(artifacts);
  for (char const* const name : pictures) {
    std::error_code ignored;
    std::filesystem::copy_file(lichtraum.folder / name, artifacts / name,
                               std::filesystem::copy_options::overwrite_existing, ignored);
  }
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
}

}  // namespace

TEST_CASE("a window is opened, turned, saved to, and closed", "[app][view]") {
  if (!obstacle().empty()) SKIP_TEST(obstacle());
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", std::string(scene_without_camera) + camera);
  use_window(lichtraum, "view_in_xvfb.sh", {"opened.png", "turned.png", "saved.png", "faulty.png", "shown.png"});
  CHECK(lichtraum.folder.read("exit_code") == "0\n");
  CHECK(!lichtraum.folder.read("class").empty());  // StartupWMClass of lichtraum.desktop

  auto const shot = [&](char const* name) { return decode(lichtraum.folder.read(name)); };
  auto const drawn = [&](std::string const& scene) {
    lichtraum.folder.write("drawn.sdf", scene);
    REQUIRE(lichtraum("render -q drawn.sdf --samples 256 -o drawn.png").exit_code == 0);
    return shot("drawn.png");
  };
  // What is seen is what is rendered: first through the scene's camera, then through the one that was copied.
  CHECK(difference(shot("opened.png"), drawn(std::string(scene_without_camera) + camera)) < 0.5);
  CHECK(difference(shot("turned.png"), shot("opened.png")) > 5);
  CHECK(difference(shot("turned.png"), drawn(scene_without_camera + lichtraum.folder.read("camera.sdf"))) < 0.5);
  CHECK(difference(shot("turned.png"), shot("scene_view_0001.png")) < 0.5);
  CHECK(!std::filesystem::exists(lichtraum.folder / "scene_view_0002.png"));
  // The ball has become green, seen from where it was; the mistake is shown below, over a picture that stays.
  CHECK(shot("turned.png").at(170, 120, 0) > shot("turned.png").at(170, 120, 1));
  CHECK(shot("saved.png").at(170, 120, 1) > shot("saved.png").at(170, 120, 0));
  CHECK(difference(shot("faulty.png"), shot("saved.png"), 0, 120) < 0.5);
  CHECK(difference(shot("faulty.png"), shot("saved.png"), 180, 240) > 5);
  CHECK(difference(shot("copied.png"), shot("turned.png"), 180, 240) > 1);
  // The list of keys has room in a small window.
  CHECK(difference(shot("keys.png"), shot("without_keys.png"), 60, 180) > 5);
  CHECK(difference(shot("keys.png"), shot("without_keys.png"), 0, 2) == 0);
  CHECK(difference(shot("keys.png"), shot("without_keys.png"), 238, 240) == 0);
  // What was read goes away.
  CHECK(difference(shot("told.png"), shot("turned.png"), 180, 240) > 1);
  CHECK(difference(shot("untold.png"), shot("turned.png")) < 0.5);
  CHECK(difference(shot("dismissed.png"), shot("saved.png")) < 0.5);
  CHECK(lichtraum.folder.read("exit_code_shown") == "0\n");
  CHECK(difference(shot("shown.png"), shot("written.png")) == 0);  // and not of more samples than were asked for
  CHECK(shot("shown.png").at(170, 120, 1) > shot("shown.png").at(170, 120, 0));
  CHECK_THAT(lichtraum.folder.read("log.txt"), contains_text("nonsense"));
}

TEST_CASE("a window keeps in view what it showed, and frames what stands on a floor", "[app][view]") {
  if (!obstacle().empty()) SKIP_TEST(obstacle());
  Lichtraum const lichtraum;
  lichtraum.folder.write("scene.sdf", std::string(scene_without_camera) + camera);
  use_window(lichtraum, "view_camera_in_xvfb.sh", {"square.png", "wide.png", "framed.png"});
  CHECK(lichtraum.folder.read("exit_code") == "0\n");
  auto const shot = [&](char const* name) { return decode(lichtraum.folder.read(name)); };
  // The wide picture is the square one, and more at its sides.
  auto const square = shot("square.png"), wide = shot("wide.png");
  double sum = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 240; ++x) sum += std::abs(double(square.at(x, y, 0) - wide.at(x + 120, y, 0)));
  }
  CHECK(sum / (240 * 240) < 0.5);
  // The ball fills the picture's height, as seen from the side: the floor's size plays no role.
  auto const framed = shot("framed.png");
  int red = 0;
  for (int y = 0; y < 240; ++y) red += framed.at(240, y, 0) > 2 * framed.at(240, y, 1);
  CHECK(red > 100);
}

TEST_CASE("a window on a scene with mistakes waits until they are mended, and goes to other files", "[app][view]") {
  if (!obstacle().empty()) SKIP_TEST(obstacle());
  Lichtraum const lichtraum;
  std::string const scene = std::string(scene_without_camera) + camera;
  lichtraum.folder.write("broken.sdf", scene + "define nonsense\n");
  lichtraum.folder.write("faulty.stl", "no triangles\n");
  lichtraum.folder.write("last.sdf", scene + "define background 0.9 0.8 0\n");
  use_window(lichtraum, "view_files_in_xvfb.sh", {"message.png", "mended.png", "skipped.png", "back.png"});
  CHECK(lichtraum.folder.read("exit_code_broken") == "65\n");  // of one that is not watched
  CHECK(lichtraum.folder.read("exit_code") == "0\n");
  CHECK_THAT(lichtraum.folder.read("log.txt"), contains_text("nonsense"));
  lichtraum.folder.write("scene.sdf", scene);
  REQUIRE(lichtraum("render -q scene.sdf --samples 256 -o drawn.png").exit_code == 0);
  auto const shot = [&](char const* name) { return decode(lichtraum.folder.read(name)); };
  CHECK(difference(shot("message.png"), shot("drawn.png")) > 5);
  CHECK(difference(shot("mended.png"), shot("drawn.png")) < 0.5);
  CHECK(shot("skipped.png").at(10, 10, 0) > 200);  // the next file's background, with the message of the one between
  CHECK_THAT(lichtraum.folder.read("log.txt"), contains_text("faulty.stl"));
  CHECK(difference(shot("skipped.png"), shot("mended.png"), 180, 240) > 5);
  CHECK(difference(shot("back.png"), shot("drawn.png")) < 0.5);
}
#endif
