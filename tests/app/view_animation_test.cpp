#ifdef LICHTRAUM_HAS_WINDOW
#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

namespace {

/// A white square of a size that goes from the left to the right for two seconds, before a camera. At rest it is higher
/// up.
std::string moving_model(float size) {
  lichtraum::testing::GltfWriter writer;
  float const s = 0.5f * size;
  writer.add_mesh({-s, -s, 0, s, -s, 0, s, s, 0, -s, -s, 0, s, s, 0, -s, s, 0});
  writer.json["nodes"][0]["translation"] = {-4, 1, 0};
  writer.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 10}}});
  writer.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.2}, {"znear", 0.1}}}}};
  writer.json["scenes"] = {{{"nodes", {0, 1}}}};
  int const times = writer.add_accessor<float>("SCALAR", 1, {0, 2});
  int const places = writer.add_vec3({-4, 0, 0, 4, 0, 0});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  return writer.glb();
}

/// Where bright pixels are in the picture right of the panel and above the time line, in the mean.
struct Square {
  double column = 0, row = 0, pixels = 0;
};
Square square_in(DecodedImage const& image) {
  Square square;
  for (int y = 120; y < 420; ++y) {
    for (int x = 270; x < 640; ++x) {
      if (image.at(x, y, 0) < 60) continue;
      square.column += x;
      square.row += y;
      ++square.pixels;
    }
  }
  square.column /= square.pixels;
  square.row /= square.pixels;
  return square;
}

/// How many pixels differ in columns [left, right), rows [top, bottom).
int differences(DecodedImage const& a, DecodedImage const& b, int left, int right, int top, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) count += a.at(x, y, 0) != b.at(x, y, 0);
  }
  return count;
}
int panel_differences(DecodedImage const& a, DecodedImage const& b) { return differences(a, b, 0, 258, 0, 480); }

}  // namespace

TEST_CASE("the window plays an animation, and goes through it frame by frame", "[app][view]") {
  for (char const* const program : {"Xvfb", "xdotool", "ffmpeg"}) {
    if (!is_installed(program)) SKIP_TEST(std::string(program) + " is not installed");
  }
  Lichtraum const lichtraum;
  lichtraum.folder.write("moving.glb", moving_model(2));
  lichtraum.folder.write("smaller.glb", moving_model(1.4f));
  Process process;
  process.arguments = {project_path("tests/app/view_animation_in_xvfb.sh"), LICHTRAUM_PROGRAM, lichtraum.folder.path()};
  process.timeout_seconds = 400;
  auto const result = run_process(process);
  std::filesystem::path const artifacts = artifact_path("view_animation");
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
  CHECK(lichtraum.folder.read("log.txt").starts_with("lichtraum: error: nothing is saved"));

  auto const square = [&](std::string const& name) {
    Square const found = square_in(decode(lichtraum.folder.read(name + ".png")));
    INFO(name);
    REQUIRE(found.pixels > 0);
    return found;
  };
  auto const column = [&](std::string const& name) { return square(name).column; };
  double const opened = column("opened"), stepped = column("stepped"), back = column("back");
  // Of 50 frames that take it across, so many steps, to half a pixel.
  CHECK(stepped > opened + 20);
  CHECK(stepped - back == Approx((stepped - opened) / 10).margin(0.5));
  // Its start is not where it is at rest, and is found again.
  CHECK(square("start").row > square("opened").row + 15);
  CHECK(column("start_again") == Approx(opened).margin(0.1));
  CHECK(column("turned") != Approx(opened).margin(1));  // Shift and an arrow move the camera
  CHECK(column("straight") == Approx(opened).margin(0.1));
  CHECK(column("paused") != Approx(opened).margin(1));
  CHECK(column("late") > opened + 150);
  // What was set of the lens stays, though the model's camera has another in each frame.
  auto const shot = [&](std::string const& name) { return decode(lichtraum.folder.read(name + ".png")); };
  CHECK(panel_differences(shot("lens"), shot("sliders")) > 0);
  CHECK(panel_differences(shot("lens_before"), shot("lens")) == 0);
  // What is read again is at the time that was shown.
  CHECK(square("smaller").pixels < 0.7 * square("lens_before").pixels);
  CHECK(column("smaller") == Approx(column("lens_before")).margin(0.5));
  // Messages leave the time line free.
  CHECK(differences(shot("told"), shot("smaller"), 262, 640, 300, 430) > 0);
  CHECK(differences(shot("told"), shot("smaller"), 262, 640, 436, 472) == 0);
}
#endif
