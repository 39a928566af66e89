#ifdef LICHTRAUM_HAS_WINDOW
#include <algorithm>
#include <cmath>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

namespace {

/// A ball on the right, where no panel covers it, that belongs to a pair; nothing around it.
constexpr char const* scene =
    "define material red 0.02 0 0  0.8 0.1 0.1  0 0 0  1\n"
    "define shape sphere ball 1 0 0  0.8 red\n"
    "define shape box block -0.4 -1.2 -2  2.4 -0.9 0.5 red\n"
    "define shape composite pair ball block\n"
    "define light diffuse lamp 3 4 6  1 1 1\ndefine light ambient sky 1 1 1\n"
    "define camera eye 50 640 480\ntransform eye translate 0 0 6\n";

struct Area {
  int x0, y0, x1, y1;
};
/// Right of the panel, below the numbers.
constexpr Area picture{350, 100, 640, 480};
constexpr Area rows{9, 74, 240, 212};

/// Mean of the differences, of 255. `b` begins `b_left` pixels farther to the right.
double difference(DecodedImage const& a, DecodedImage const& b, Area const& area, int b_left = 0) {
  double sum = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      for (int c = 0; c < 3; ++c) sum += std::abs(double(a.at(x, y, c) - b.at(x - b_left, y, c)));
    }
  }
  return sum / (3.0 * (area.x1 - area.x0) * (area.y1 - area.y0));
}

/// Pixels in the colour of outlines.
int outlined(DecodedImage const& image, Area const& area) {
  int count = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      count += image.at(x, y, 0) == 255 && image.at(x, y, 1) == 160 && image.at(x, y, 2) == 30;
    }
  }
  return count;
}

/// What `script` of tests/app/ does to a window that shows scene.sdf of the folder.
ProcessResult run_in_xvfb(char const* script, Lichtraum const& lichtraum, int timeout_seconds) {
  lichtraum.folder.write("scene.sdf", scene);
  Process process;
  process.arguments = {project_path("tests/app/" + std::string(script)), LICHTRAUM_PROGRAM, lichtraum.folder.path()};
  process.timeout_seconds = timeout_seconds;
  return run_process(process);
}

}  // namespace

TEST_CASE("text and widgets grow with the scale that was asked for", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_scale_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  std::filesystem::path const artifacts = artifact_path("view_scale");
  std::filesystem::create_directories(artifacts);
  for (std::string const name : {"opened.png", "chosen.png"}) {
    std::filesystem::copy_file(std::filesystem::path(lichtraum.folder.path()) / name, artifacts / name,
                               std::filesystem::copy_options::overwrite_existing);
  }
  auto const opened = decode(lichtraum.folder.read("opened.png")), chosen = decode(lichtraum.folder.read("chosen.png"));
  // The row is where it is at scale 1, twice as far from the corner.
  CHECK(outlined(opened, {700, 200, 1280, 960}) == 0);
  CHECK(outlined(chosen, {700, 200, 1280, 960}) > 200);
}

TEST_CASE("names are shown in the letters of Latin, Greek and Cyrillic", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf")) {
    SKIP_TEST("fonts-dejavu-core is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_names_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  auto const shot = [&](std::string const& name) { return decode(lichtraum.folder.read(name + "_unfolded.png")); };
  CHECK(difference(shot("ball"), shot("box"), rows) == 0);  // a question mark each
  CHECK(difference(shot("zhe"), shot("ball"), rows) > 0);
  CHECK(difference(shot("stroke"), shot("ball"), rows) > 0);
  CHECK(difference(shot("stroke"), shot("zhe"), rows) > 0);
}

TEST_CASE("labels of a glTF material can be told apart, and are shown whole under the mouse", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0});
  writer.json["materials"] = {{{"name", "paint"}}};
  writer.json["meshes"][0]["primitives"][0]["material"] = 0;
  lichtraum.folder.write("model.gltf", writer.text());
  auto const result = run_in_xvfb("view_labels_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  REQUIRE(result.exit_code == 0);
  auto const shot = [&](std::string const& name) { return decode(lichtraum.folder.read(name + ".png")); };
  DecodedImage const material = shot("material"), told = shot("told");
  double labels = 0;  // of the least and the greatest thickness of iridescence, in two rows
  for (int y = 943; y < 958; ++y) {
    for (int x = 190; x < 250; ++x) labels += std::abs(double(material.at(x, y, 0) - material.at(x, y + 23, 0)));
  }
  CHECK(labels > 1000);
  CHECK(difference(told, material, {280, 862, 400, 884}) > 20);  // beside the panel
}

TEST_CASE("a window is no larger than its display, and that is said", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_size_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  CHECK(result.exit_code == 0);
  CHECK_THAT(lichtraum.folder.read("log.txt"), contains_text("--size: the window is 400x300"));
}

TEST_CASE("a window that is resized faster than it can follow stays open", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_resize_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  CHECK(result.exit_code == 0);
}

TEST_CASE("a window is gone at once when it is closed, though its scene is still being read", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_reading_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  CHECK(result.exit_code == 0);
}

TEST_CASE("a window that was large gives the memory of its picture back", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_memory_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  CHECK(result.exit_code == 0);
}

TEST_CASE("changes that are not saved are told of before they go, by whatever way", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg", "python3"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  lichtraum.folder.write("second.sdf", scene);
  auto const result = run_in_xvfb("view_edits_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  REQUIRE(result.exit_code == 0);
  CHECK(lichtraum.folder.read("exit_code") == "0\n");
  auto const shot = [&](std::string const& name) { return decode(lichtraum.folder.read(name + ".png")); };
  Area const message{270, 420, 640, 480};
  CHECK(difference(shot("told_of_step"), shot("changed"), message) > 5);
  CHECK(difference(shot("told_of_close"), shot("changed"), message) > 5);
}

TEST_CASE("a number that is typed changes nothing but what it is of", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  std::string const lamp = "diffuse lamp 3 4 6  ", white = "1 1 1";
  std::string lit = scene;
  lit.replace(lit.find(lamp + white) + lamp.size(), white.size(), "7.2 1 1.2");
  lichtraum.folder.write("lit.sdf", lit);
  auto const result = run_in_xvfb("view_typing_in_xvfb.sh", lichtraum, 200);
  INFO(result.out + result.err + lichtraum.folder.read("log.txt"));
  REQUIRE(result.exit_code == 0);
  // Its first key, a 0, makes blue the brightest channel for a moment.
  CHECK_THAT(lichtraum.folder.read("out.txt"), contains_text("define light diffuse lamp  3 4 6  3.6 1 1.2\n"));
}

TEST_CASE("the panel selects objects, changes lights and shows depth, normals and objects", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  auto const result = run_in_xvfb("view_panel_in_xvfb.sh", lichtraum, 400);
  std::filesystem::path const artifacts = artifact_path("view_panel");
  std::filesystem::create_directories(artifacts);
  for (auto const& entry : std::filesystem::directory_iterator(lichtraum.folder.path())) {
    std::error_code ignored;
    if (entry.path().extension() != ".png") continue;
    std::filesystem::copy_file(entry.path(), artifacts / entry.path().filename(),
                               std::filesystem::copy_options::overwrite_existing, ignored);
  }
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(lichtraum.folder.read("exit_code") == "0\n");

  auto const shot = [&](std::string const& name) { return decode(lichtraum.folder.read(name + ".png")); };
  auto const opened = shot("opened");
  CHECK(outlined(opened, picture) == 0);
  // The numbers are where the panel leaves room for them.
  for (int y = 10; y < 90; ++y) {
    for (int x = 262; x < 285; ++x) REQUIRE(opened.at(x, y, 0) < 100);
  }
  // A click on the picture outlines the ball, not the block, and opens the tree down to it.
  auto const picked = shot("picked");
  CHECK(outlined(picked, {350, 100, 640, 300}) > 150);
  CHECK(outlined(picked, {560, 310, 640, 480}) == 0);
  CHECK(difference(picked, opened, rows) > 1);
  CHECK(outlined(shot("nothing"), picture) == 0);
  CHECK(difference(shot("nothing"), opened, picture) < 0.1);
  // A click on a row of the tree outlines all below it.
  auto const chosen = shot("chosen");
  CHECK(difference(shot("unfolded"), shot("nothing"), rows) > 0.5);
  CHECK(outlined(chosen, {350, 100, 640, 300}) > 100);
  CHECK(outlined(chosen, {350, 310, 640, 480}) > 100);
  // A slider takes the lamp's light away, and what the surface itself shows stays; and back.
  auto const dark = shot("dark");
  CHECK(opened.at(546, 227, 0) > 100);
  CHECK((dark.at(546, 227, 0) >= 3 && dark.at(546, 227, 0) < 12));
  CHECK(difference(shot("reset"), opened, picture) < 0.1);
  CHECK_THAT(lichtraum.folder.read("out.txt"), contains_text("define light diffuse lamp  3 4 6  1 1 1\n"));
  // What the menu offers is done; what it opened closes again.
  CHECK(difference(shot("keys"), shot("reset"), picture) > 5);
  CHECK(difference(shot("closed"), shot("reset"), picture) < 0.1);
  // The other views are what --planes draws.
  for (std::string const plane : {"depth", "normal", "object"}) {
    REQUIRE(lichtraum("render -q scene.sdf --planes " + plane + " --size 380x480 -o drawn.png").exit_code == 0);
    INFO(plane);
    CHECK(difference(shot(plane), shot("drawn"), picture, 260) < 0.1);
    CHECK(difference(shot(plane), opened, picture) > 5);
  }
  CHECK(difference(shot("picture"), opened, picture) < 0.1);
  // What helps to find one's way comes and goes.
  for (std::string const key : {"g", "x", "e"}) {
    INFO(key);
    CHECK(difference(shot("overlay_" + key), opened, picture) > 0.2);
    CHECK(difference(shot("without_" + key), opened, picture) < 0.1);
  }
  // Dragging a material's red down by a quarter takes as much from the picture, and no other colour.
  auto const material = shot("material");
  CHECK(material.at(546, 227, 0) < 0.85f * opened.at(546, 227, 0));
  CHECK(material.at(546, 227, 0) > 0.5f * opened.at(546, 227, 0));
  CHECK(material.at(546, 227, 1) == opened.at(546, 227, 1));
  // The scene that was saved is drawn so, and the other one is as it was.
  CHECK(lichtraum.folder.read("scene.sdf") == scene);
  CHECK_THAT(lichtraum.folder.read("scene_edited_0001.sdf"), contains_text(" 0.1 0.1  0 0 0  1\n"));  // no other digits
  REQUIRE(lichtraum("render -q scene_edited_0001.sdf --samples 256 --size 380x480 -o drawn.png").exit_code == 0);
  CHECK(difference(material, shot("drawn"), picture, 260) < 0.1);
  // Exposure develops the same picture again.
  CHECK(difference(shot("development"), material, picture) < 0.1);
  CHECK(shot("underexposed").at(546, 227, 0) < 0.1f * material.at(546, 227, 0));
}
#endif
