/// The path integrator where analysis says what it must show, and where Whitted's says it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lichtraum/error.hpp"
#include "lichtraum/model.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/gltf_import.hpp"
#include "support/path_pictures.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr char const* ambient_light = "define light ambient sky 1 1 1\n";

/// At most, in any channel of a pixel.
float differs_by(Image const& a, Image const& b) {
  float most = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
    }
  }
  return most;
}

/// The mean is that, within three and a half of its deviations, and those are small enough to say something.
void check_mean(Image const& image, double expected, double largest_error = 0.004) {
  Mean const mean = mean_of(image);
  INFO("mean " << mean.value << " +- " << mean.error << ", expected " << expected);
  CHECK(std::abs(mean.value - expected) <= 3.5 * mean.error + 1e-5);
  CHECK(mean.error <= largest_error * expected + 1e-6);
}

/// A ball that fills the picture.
std::string ball(std::string const& material) {
  return "define material m " + material + "\ndefine shape sphere ball 0 0 0 1 m\n" +
         "define camera eye 20\ntransform eye translate 0 0 3\n";
}

/// Whitted's picture of the same rays.
void check_is_whitteds(Scene const& scene, RenderRequest request, std::string const& name, double share) {
  Image const paths = trace(scene, request);
  request.integrator = Integrator::whitted;
  check_picture(paths, trace(scene, request), name, share);
}

/// As `emission` in the material's line would.
void let_shine(Scene& scene, char const* material, Rgb const& emission) {
  Material& m = **scene.materials.find(material);
  PhongModel model = m.phong();
  model.emission = emission;
  m = Material(m.name(), model);
}

/// A level floor below a pane; lights, if any, are above it, and the camera is between.
std::string below_pane(std::string const& more) {
  return R"(
define material grey 0 0 0  0.5 0.5 0.5  0 0 0 1
define material glass 0 0 0  0 0 0  0 0 0 1
define material lamp 0 0 0  0 0 0  0 0 0 1
define shape plane floor 0 -1 0  0 1 0 grey
define shape triangle pane -90 1 -90  90 1 -90  0 1 90 glass
define camera eye 40
transform eye rotate -40 1 0 0
)" + more;
}

PbrModel clear_glass(Rgb const& color = Rgb(1)) {
  PbrModel glass = pbr(color, 0, 0);
  glass.transmission = 1;
  return glass;
}

double root_mean_square(Image const& a, Image const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data().size(); ++i) {
    double const difference = double(a.data()[i]) - b.data()[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / double(a.data().size()));
}

}  // namespace

TEST_CASE("paths: a convex matt body shows its reflectance in ambient light", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(ball("0.3 0.3 0.3  0.5 0.5 0.5  0 0 0 1") + ambient_light);
  Mean const mean = mean_of(trace(scene, path_request(scene, {16, 16}, 4, 16)));
  CHECK(mean.least == Approx(0.5).margin(1e-4));  // each path does: it is scattered once, and nothing is in its way
  CHECK(mean.most == Approx(0.5).margin(1e-4));
}

TEST_CASE("paths: what is white shows the ambient light, whatever is in its way", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const white = "1 1 1  1 1 1  0 0 0 1";
  SECTION("ball") {
    Scene const scene = scene_of(ball(white) + ambient_light);
    Mean const mean = mean_of(trace(scene, path_request(scene, {16, 16}, 4, 64)));
    CHECK(mean.least == Approx(1).margin(1e-4));
    CHECK(mean.most == Approx(1).margin(1e-4));
  }
  SECTION("between walls") {
    // The camera looks into a corner of three planes with a ball in it.
    Scene const scene = scene_of(std::string(ambient_light) + "define material m " + white + R"(
define shape box floor -4 -1.2 -4  4 -1 4 m
define shape box left  -1.4 -1 -4  -1.2 4 4 m
define shape box back  -4 -1 -1.4  4 4 -1.2 m
define shape sphere ball -0.2 -0.2 -0.2 0.8 m
define camera eye 30
transform eye rotate 45 0 1 0
transform eye translate 3 0 3
)");
    check_mean(trace(scene, path_request(scene, {32, 32}, 64, 64)), 1);
  }
}

TEST_CASE("paths: glass and mirrors in ambient light keep all of it", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Background is what they show, so that it is the same everywhere.
  std::string const around = std::string(ambient_light) + "define background 1 1 1\n";
  for (std::string const material : {"0 0 0  0 0 0  0 0 0 1 reflect=1", "0 0 0  0 0 0  0 0 0 1 transmit=1 ior=1.5",
                                     "0 0 0  1 1 1  0 0 0 1 reflect=0.3 transmit=0.4 ior=1.3"}) {
    INFO(material);
    Scene const scene = scene_of(ball(material) + around);
    check_mean(trace(scene, path_request(scene, {32, 32}, 64, 64)), 1);
  }
}

TEST_CASE("paths: what clear glass absorbs does not depend on the way, however short its distance", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  for (double const distance : {1., 1e-30, 1e-40}) {
    INFO(distance);
    Scene scene = scene_of(ball("0 0 0  0 0 0  0 0 0 1") + ambient_light + "define background 1 1 1\n");
    PbrModel glass = pbr(Rgb(1), 0, 0);
    glass.transmission = glass.thickness = 1;
    glass.attenuation_distance = distance;
    **scene.materials.find("m") = Material("m", glass);
    check_mean(trace(scene, path_request(scene, {32, 32}, 64, 64)), 1);
  }
}

TEST_CASE("paths: a closed body that shines within shows the sum of all bounces", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(
      "define material m 0 0 0  0.5 0.5 0.5  0 0 0 1\n"
      "define shape sphere hollow 0 0 0 2 m\ndefine camera eye 60\n");
  let_shine(scene, "m", Rgb(0.3));
  check_mean(trace(scene, path_request(scene, {16, 16}, 64, 64)), 0.3 / (1 - 0.5));
  // Cut short: emission of the wall that is seen, and of the one after that, ...
  check_mean(trace(scene, path_request(scene, {16, 16}, 64, 0)), 0.3);
  check_mean(trace(scene, path_request(scene, {16, 16}, 64, 2)), 0.3 * 1.75);
}

TEST_CASE("paths: a limit dims light that was scattered on its way, and no other", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene hollow = scene_of(
      "define material m 0 0 0 0.5 0.5 0.5 0 0 0 1 emission 1 1 1\ndefine shape sphere body 0 0 0 2 m\n"
      "define camera eye 60\n");
  RenderRequest request = path_request(hollow, {16, 16}, 16, 2);
  request.max_indirect = 0.1;
  // What is seen, what lights that, and what lights that in turn.
  CHECK(mean_of(trace(hollow, request)).value == Approx(1 + 0.5 + 0.1).epsilon(1e-5));
  // The reference's uniform directions make the third part differ from path to path, 0 to 0.1; without a limit it is
  // 0.25.
  CHECK(mean_of(render_reference(hollow, request)).value == Approx(1.55).margin(0.06));

  Scene const room = scene_of(
      "define material m 0 0 0 0.8 0.6 0.4 0 0 0 1\ndefine shape box floor -3 -2 -9 3 -1 -1 m\n"
      "define shape sphere ball 0 0 -5 1 m\ndefine light diffuse lamp 3 5 0 1 1 1 radius=1\ndefine camera eye 60\n");
  request = path_request(room, {48, 32}, 16, 4);
  Image const all = trace(room, request);
  request.max_indirect = 1e30;
  CHECK(differs_by(trace(room, request), all) == 0);
  request.max_indirect = 1e-6;
  Image const dimmed = trace(room, request);
  request.max_depth = 1;
  Image const direct = trace(room, request);
  CHECK(mean_of(all).value > 1.05 * mean_of(direct).value);
  CHECK(differs_by(dimmed, direct) < 1e-5f);
}

TEST_CASE("paths: a room is as bright wherever it is", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // A box of a unit's size whose lamp, two triangles, hangs a hundredth below the ceiling.
  auto const mean_at = [](double x, double y, double z) {
    auto const at = [&](double a, double b, double c) { return fmt::format(" {} {} {}", x + a, y + b, z + c); };
    auto const box = [&](char const* name, double a, double b, double c, double d, double e, double f) {
      return fmt::format("define shape box {}{}{} grey\n", name, at(a, b, c), at(d, e, f));
    };
    auto const triangle = [&](char const* name, double a, double b, double c, double d) {
      return fmt::format("define shape triangle {}{}{}{} lamp\n", name, at(0.3, 0.99, 0.3), at(a, 0.99, b),
                         at(c, 0.99, d));
    };
    Scene const scene = scene_of(
        "define material grey 0 0 0  0.6 0.6 0.6  0 0 0 1\n"
        "define material lamp 0 0 0  0 0 0  0 0 0 1  emission 10 10 10\n" +
        box("floor", -1, -1, -1, 2, 0, 1) + box("ceiling", -1, 1, -1, 2, 2, 1) + box("left", -1, -1, -1, 0, 2, 1) +
        box("right", 1, -1, -1, 2, 2, 1) + box("back", -1, -1, -1, 2, 2, 0) + triangle("one", 0.7, 0.3, 0.7, 0.7) +
        triangle("two", 0.7, 0.7, 0.3, 0.7) + "define camera eye 60\ntransform eye translate" + at(0.5, 0.5, 1.4) +
        "\n");
    return mean_of(trace(scene, path_request(scene, {48, 48}, 256, 6)));
  };
  Mean const near = mean_at(0, 0, 0);
  CHECK(near.value > 0.3);
  for (double const away : {10.0, 30.0, 100.0}) {
    INFO(away);
    CHECK(mean_at(away, away, away).value == Approx(near.value).epsilon(0.003));
  }
}

TEST_CASE("paths: what shines is in the albedo, so that denoising keeps its edges", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(
      "define material m 0 0 0  0.5 0.4 0.3  0 0 0 1\n"
      "define shape sphere hollow 0 0 0 2 m\ndefine camera eye 60\n");
  let_shine(scene, "m", Rgb(0.1, 0.2, 3));
  RenderRequest request = path_request(scene, {8, 8}, 4, 1);
  request.planes = {FilmPlane::albedo};
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  Film film;
  renderer->render(request, film);
  auto const sums = film.floats(FilmPlane::albedo);
  for (std::size_t i = 0; i < sums.size(); ++i) CHECK(sums[i] == Approx(4 * std::array{0.6, 0.6, 1.0}[i % 3]));
}

TEST_CASE("paths: without scattering only what shines is seen", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const dark = scene_of(ball("1 1 1  1 1 1  0 0 0 1") + ambient_light);
  CHECK(mean_of(trace(dark, path_request(dark, {8, 8}, 4, 0))).most == 0);
  Scene lamp = scene_of(ball("1 1 1  0 0 0  0 0 0 1"));
  let_shine(lamp, "m", Rgb(3));
  Mean const mean = mean_of(trace(lamp, path_request(lamp, {8, 8}, 4, 16)));
  CHECK(mean.least == Approx(3));
  CHECK(mean.most == Approx(3));
  Scene const empty = scene_of("define background 0.2 0.2 0.2\ndefine camera eye 45\n" + std::string(ambient_light));
  CHECK(mean_of(trace(empty, path_request(empty, {8, 8}, 4, 0))).value == Approx(0.2));
}

TEST_CASE("paths: what ends before it meets a lamp is not lit by it, whichever way the lamp is found",
          "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const floor =
      "define material grey 0 0 0  0.5 0.5 0.5  0 0 0 1\ndefine shape plane floor 0 -1 0  0 1 0 grey\n"
      "define camera eye 50\ntransform eye rotate -20 1 0 0\n";
  SECTION("environment") {
    Scene scene = scene_of(floor);
    EnvironmentMap map{4, 2, std::vector<float>(24, 0.1f)};
    map.radiance[3] = 20;  // what is brighter than the mean is looked for
    scene.environment = EnvironmentLight{"made here", std::make_shared<EnvironmentMap const>(map), 0, 1};
    CHECK(mean_of(trace(scene, path_request(scene, {16, 16}, 16, 0))).most == 0);
    CHECK(mean_of(trace(scene, path_request(scene, {16, 16}, 16, 1))).value > 0.01);
  }
  SECTION("light without a size") {
    Scene const scene = scene_of(floor + "define light diffuse key 1 3 2  1 1 1\n");
    for (auto const draw : {+[](Scene const&s, RenderRequest const&r) { return trace(s, r); },
                            +[](Scene const&s, RenderRequest const&r) { return render_reference(s, r); }}) {
      CHECK(mean_of(draw(scene, path_request(scene, {16, 16}, 16, 0))).most == 0);
      CHECK(mean_of(draw(scene, path_request(scene, {16, 16}, 16, 1))).value > 0.01);
    }
  }
  SECTION("triangle") {
    Scene scene = scene_of(floor +
                           "define material lamp 0 0 0  0 0 0  0 0 0 1\n"
                           "define shape triangle lamp -1 3 -4  1 3 -4  0 3 -2 lamp\n");
    let_shine(scene, "lamp", Rgb(5));
    CHECK(mean_of(trace(scene, path_request(scene, {16, 16}, 16, 0))).most == 0);
    CHECK(mean_of(trace(scene, path_request(scene, {16, 16}, 16, 1))).value > 0.01);
  }
}

TEST_CASE("paths: direct light of point lights on matt surfaces is Whitted's", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const things = R"(
define material grey 0.5 0.5 0.5  0.6 0.5 0.4  0 0 0 1
define shape box floor -9 -2 -9  9 -1 9 grey
define shape sphere ball 0 0 -1 1 grey
define background 0.1 0.2 0.3
define light diffuse key -6 9 8  0.9 0.8 0.7
define camera eye 50
transform eye translate 0 0.5 5
)";
  SECTION("one light leaves nothing to chance") {
    Scene const scene = scene_of(things);
    check_is_whitteds(scene, path_request(scene, {64, 48}, 1, 1), "path_direct", 0.002);
  }
  SECTION("of several, one is chosen") {
    Scene const scene = scene_of(things +
                                 "define light diffuse fill 7 5 6  0.2 0.3 0.4\n"
                                 "define light diffuse back 0 6 -8  0.3 0.1 0.1\n");
    RenderRequest request = path_request(scene, {24, 18}, 1024, 1);
    Image const paths = trace(scene, request);
    request.integrator = Integrator::whitted;
    Image const whitted = trace(scene, request);
    CHECK(root_mean_square(paths, whitted) < 0.003);
  }
  SECTION("what is scattered again adds to it") {
    // A plane sees nothing but the light, so depth 2 and more change nothing.
    Scene const scene = scene_of(
        "define material grey 0.5 0.5 0.5  0.6 0.5 0.4  0 0 0 1\n"
        "define shape plane floor 0 -1 0  0 1 0 grey\ndefine light diffuse key 1 3 2  1 1 1\n"
        "define camera eye 50\ntransform eye rotate -20 1 0 0\n");
    check_is_whitteds(scene, path_request(scene, {32, 24}, 1, 2), "path_plane", 0);
    check_is_whitteds(scene, path_request(scene, {32, 24}, 1, 8), "path_plane_deep", 0);
  }
}

TEST_CASE("paths: mirrors and glass are Whitted's", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // What is seen in them shines by itself: light does not pass glass on its way from a lamp to matt surfaces.
  std::string const things = R"(
define material red   0 0 0  0 0 0  0 0 0 1
define material blue  0 0 0  0 0 0  0 0 0 1
define shape box floor -9 -2 -9  9 -1 9 red
define shape sphere far 1 0.5 -4 1.5 blue
define background 0.3 0.4 0.6
define camera eye 50
transform eye translate 0 0.5 5
)";
  auto const scene_with = [&](std::string const& more) {
    Scene scene = scene_of(things + more);
    let_shine(scene, "red", {0.9, 0.2, 0.1});
    let_shine(scene, "blue", {0.1, 0.3, 0.9});
    return scene;
  };
  SECTION("mirror") {
    Scene const scene = scene_with(
        "define material m 0 0 0  0 0 0  0 0 0 1 reflect=0.8\n"
        "define shape sphere a -1 0 0 0.9 m\ndefine shape sphere b 1 0 0 0.9 m\n");
    check_is_whitteds(scene, path_request(scene, {64, 48}, 1, 5), "path_mirror", 0.01);
  }
  SECTION("glass") {
    Scene const scene = scene_with(
        "define material m 0 0 0  0 0 0  0 0 0 1 transmit=0.9 ior=1.5\n"
        "define shape sphere a -1 0 0 0.9 m\n"
        "define shape box b 0.3 -0.9 -0.5  1.5 0.6 0.5 m\n");
    check_is_whitteds(scene, path_request(scene, {64, 48}, 1, 5), "path_glass", 0.02);
  }
  SECTION("both, by chance") {
    Scene const scene = scene_of(things +
                                 "define material m 0 0 0  0 0 0  0 0 0 1 reflect=0.3 transmit=0.6 ior=1.5\n"
                                 "define shape sphere a 0 0 0 0.9 m\n");
    RenderRequest request = path_request(scene, {24, 18}, 1024, 4);
    Image const paths = trace(scene, request);
    request.integrator = Integrator::whitted;
    CHECK(root_mean_square(paths, trace(scene, request)) < 0.005);
  }
}

TEST_CASE("paths: what blends covers its share of the background", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  testing::GltfWriter writer;
  auto& primitive = writer.add_mesh({-9, -9, 0, 9, -9, 0, 0, 9, 0});
  primitive["material"] = 0;
  writer.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.8, 0.8, 0.8, 0.5}}}},
                               {"alphaMode", "BLEND"},
                               {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}};
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"aspectRatio", 1}}}}};
  writer.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 1}}});
  Model model = testing::import_model(writer);
  model.scene.background = Rgb(0.2);
  RenderRequest request = path_request(model.scene, {16, 16}, 15, 16);  // no power of two: some noise is left
  check_mean(trace(model.scene, request), 0.5 * 0.8 + 0.5 * 0.2, 0.01);
  request.planes = {FilmPlane::radiance, FilmPlane::alpha};
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(model.scene);
  Film film;
  renderer->render(request, film);
  double alpha = 0;
  for (float const value : film.values(FilmPlane::alpha)) alpha += value / 256;
  CHECK(alpha == Approx(0.5).margin(0.02));
}

TEST_CASE("paths: lights without a size are seen through panes, in their colour", "[image][path][panes]") {
  REQUIRE_OPENCL_DEVICE();
  auto const picture = [](Material::Model const& model) {
    Scene scene = scene_of(below_pane("define light diffuse sun 0 1e6 0  0.8 0.8 0.8\n"));
    *(*scene.materials.find("glass")) = Material("glass", model);
    return trace(scene, path_request(scene, {8, 8}, 1, 1));
  };
  auto const check_all = [](Image const& image, Rgb const& expected) {
    for (int c = 0; c < 3; ++c) {
      CHECK(image.pixel(1, 1)[c] == Approx(expected[c]).epsilon(1e-4));
      CHECK(image.pixel(6, 6)[c] == Approx(expected[c]).epsilon(1e-4));
    }
  };
  check_all(picture(clear_glass({0.9, 0.5, 0.1})), 0.5 * 0.8 * 0.96 * Rgb(0.9, 0.5, 0.1));
  check_all(picture(PhongModel{.kd = Rgb(0), .transmit = 0.75}), Rgb(0.5 * 0.8 * 0.75));
  check_all(picture(PhongModel{.kd = Rgb(0), .transmit = 0.75, .ior = 1.01}), Rgb(0));
  PbrModel rough = clear_glass();
  rough.roughness = 0.1;
  check_all(picture(rough), Rgb(0));
}

TEST_CASE("paths: what chrome throws on the ground of a lamp without a size has no dots", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Smoother ones make fewer dots, which are brighter.
  PbrModel chrome = pbr(Rgb(0.9), 1, 0.1);
  SECTION("by itself") {}
  SECTION("as a clear coat") {
    chrome = pbr(Rgb(0), 0, 1);
    chrome.specular = 0;
    chrome.clearcoat = 1;
    chrome.clearcoat_roughness = 0.1;
  }
  Scene scene = scene_of(R"(
define material floor 0 0 0  0.6 0.6 0.6  0 0 0 1
define material chrome 0 0 0  0.6 0.6 0.6  0 0 0 1
define shape box ground -4 -1 -4  4 0 4 floor
define shape sphere ball 0 1 0 1 chrome
define light diffuse lamp 2 3 2  1 1 1
define camera eye 30
transform eye rotate -50 1 0 0
transform eye translate 0 4.5 5.5
)");
  **scene.materials.find("chrome") = Material("chrome", chrome);
  // The lower third shows the ground, which is lit everywhere.
  Image const image = trace(scene, path_request(scene, {48, 36}, 256, 3));
  double most = 0;
  for (int y = 24; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) most = std::max(most, double(image.pixel(x, y)[0]));
  }
  CHECK(most < 0.64);  // 0.6 is the ground in full light; a coat's dots add a tenth, chrome's much more
  CHECK(most > 0.5);
}

TEST_CASE("paths: a pane keeps no light, whether it is looked for or met", "[image][path][panes]") {
  REQUIRE_OPENCL_DEVICE();
  // A white pane over a white floor: all that is reflected and passed comes back in the end. The window of the
  // environment is looked for, the other half is met by chance.
  Scene scene = scene_of(below_pane(""));
  PbrModel glass = clear_glass();
  SECTION("clear") {}
  SECTION("of one colour, and partly matt") { glass.transmission = 0.4; }
  SECTION("that reflects one channel more") { glass.specular_color = {20, 1, 1}; }  // the others lose as much
  SECTION("that blends") {
    glass.alpha = 0.5;
    glass.alpha_mode = AlphaMode::blend;
  }
  SECTION("that is nothing") { glass.ior = 1; }
  *(*scene.materials.find("glass")) = Material("glass", glass);
  *(*scene.materials.find("grey")) = Material("grey", PhongModel{.kd = Rgb(1)});
  EnvironmentMap map{4, 2, std::vector<float>(24, 1)};
  scene.environment = EnvironmentLight{"made here", std::make_shared<EnvironmentMap const>(map), 0, 1};
  // What is reflected comes from a table, what passes from the formula: they agree to some 0.0002.
  Mean const mean = mean_of(trace(scene, path_request(scene, {32, 32}, 256, 128)));
  CHECK(mean.error < 1.5e-3);
  CHECK(std::abs(mean.value - 1) < 3.5 * mean.error + 5e-4);
}

TEST_CASE("paths: an environment of one colour lights like ambient light of it", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const body = ball("0.3 0.3 0.3  0.5 0.5 0.5  0 0 0 1");
  Scene const scene = scene_of(body + "define light environment sky 2 1 1 brightness=0.5 rotation=77\n");
  RenderRequest request = path_request(scene, {16, 16}, 4, 16);
  Mean const mean = mean_of(trace(scene, request));
  CHECK(mean.least == Approx(0.5).margin(1e-4));
  CHECK(mean.most == Approx(0.5).margin(1e-4));
  Scene const seen = scene_of(body + "define light environment sky 2 1 1\ntransform eye translate 9 0 0\n");
  request = path_request(seen, {4, 4}, 1, 16);
  request.background = Background::environment();
  Image const sky = trace(seen, request);
  CHECK(sky.pixel(1, 2)[0] == Approx(2).margin(1e-6));
  CHECK(sky.pixel(1, 2)[2] == Approx(1).margin(1e-6));
}

TEST_CASE("paths: noise falls at least as the square root of the samples", "[image][path][statistics]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(R"(
define material grey   0 0 0  0.7 0.6 0.5  0 0 0 1
define material glossy 0 0 0  0.2 0.2 0.3  0.5 0.5 0.5 40
define shape box floor -9 -2 -9  9 -1 9 grey
define shape box wall  -9 -2 -3  9 5 -2.5 grey
define shape sphere ball -0.8 0 0 1 glossy
define shape sphere other 1.2 -0.2 0.5 0.8 grey
define light ambient sky 0.6 0.7 0.9
define light diffuse key -6 9 8  0.9 0.8 0.7
define light diffuse fill 7 5 6  0.2 0.3 0.4
define camera eye 50
transform eye translate 0 0.5 5
)");
  RenderRequest request = path_request(scene, {24, 18}, 4096, 6);
  request.seed = 1000;
  Image const converged = trace(scene, request);
  double error[2] = {0, 0};
  int const counts[2] = {16, 256};
  for (int i = 0; i < 2; ++i) {
    for (int seed = 1; seed <= 3; ++seed) {
      request.sampling.count = counts[i];
      request.seed = std::uint64_t(seed);
      error[i] += root_mean_square(trace(scene, request), converged) / 3;
    }
  }
  double const slope = std::log(error[1] / error[0]) / std::log(16.0);
  INFO(error[0] << " with 16 samples, " << error[1] << " with 256");
  CHECK(slope <= -0.5);
  CHECK(error[0] < 0.1);
}

TEST_CASE("paths: no sample of a real model is infinite or no number", "[image][path][corpus][long]") {
  REQUIRE_OPENCL_DEVICE();
  char const* const corpus = std::getenv("LICHTRAUM_CORPUS");
  if (!corpus) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real models");
  std::filesystem::path const folder = std::filesystem::path(corpus) / "gltf/khr-sample-assets";
  std::vector<std::filesystem::path> models;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (is_model_file(entry.path())) models.push_back(entry.path());
  }
  std::ranges::sort(models);
  auto const renderer = make_renderer(opencl_devices().front());
  std::size_t drawn = 0;
  for (auto const& path : models) {
    INFO(path.string());
    try {
      Model const model = import_model(path);
      renderer->set_scene(model.scene);
      Film film;
      RenderRequest const request = path_request(model.scene, {16, 16}, 16, 16);
      CHECK(renderer->render(request, film).statistics.rays.not_finite == 0);
      ++drawn;
    } catch (Error const&) {
      // What cannot be imported is another test's.
    }
  }
  CHECK(drawn > 20);
}
