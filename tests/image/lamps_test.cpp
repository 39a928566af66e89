/// Surfaces that shine, as paths find them: where analysis says what they must show and light.

#include <algorithm>
#include <cmath>
#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/path_pictures.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("paths: a lamp's emission lights what faces it", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  auto const spot = [](std::string const& lamp) {
    Scene const scene = scene_of(R"(
define material matt 0 0 0  0.5 0.5 0.5  0 0 0 1
define material lamp 0 0 0  0 0 0  0 0 0 1  emission 2 2 2
define shape box floor -9 -1 -9  9 0 9 matt
)" + lamp + R"(
define camera eye 0.01
transform eye rotate -45 1 0 0
transform eye translate 0 0.5 0.5
)");
    return mean_of(trace(scene, path_request(scene, {32, 32}, 64, 1)));
  };
  // Over a small matt spot: the form factor of a square of 2 x 2 at a distance of 1 is that of four squares of 1 x 1
  // over a corner, of a disc or a ball of radius 1 at 1 and 2 the sine of half the angle as which it is seen, squared.
  double const a = 1 / std::sqrt(2.0);
  double const square = 4 / (2 * 3.14159265358979) * (a * std::atan(a) + a * std::atan(a));
  Mean const triangles =
      spot("define shape triangle p -1 1 -1  1 1 -1  1 1 1 lamp\ndefine shape triangle q -1 1 -1  1 1 1  -1 1 1 lamp");
  Mean const box = spot("define shape box p -1 1 -1  1 1.1 1 lamp");
  Mean const flat = spot("define shape box p -1 1 -1  1 1 1 lamp");
  Mean const ball = spot("define shape sphere p 0 2 0  1 lamp");
  Mean const egg = spot(
      "define shape sphere p 0 0 0  1 lamp\ntransform p scale 0.5 0.5 0.25\ntransform p rotate 90 1 0 0\n"
      "transform p scale 2 4 2\ntransform p translate 0 2 0");
  Mean const cylinder = spot("define shape cylinder p 0 1 0  0 1.1 0  1 lamp");
  INFO("triangles " << triangles.value << ", box " << box.value << " and " << flat.value << ", ball " << ball.value
                    << " and " << egg.value << ", cylinder " << cylinder.value << " +- " << cylinder.error);
  CHECK(triangles.value == Approx(0.5 * 2 * square).margin(3.5 * triangles.error));
  CHECK(box.value == Approx(0.5 * 2 * square).margin(3.5 * box.error));
  CHECK(flat.value == Approx(0.5 * 2 * square).margin(3.5 * flat.error));
  CHECK(ball.value == Approx(0.5 * 2 * 0.25).margin(3.5 * ball.error));
  CHECK(egg.value == Approx(0.5 * 2 * 0.25).margin(3.5 * egg.error));
  CHECK(cylinder.value == Approx(0.5 * 2 * 0.5).margin(3.5 * cylinder.error));
  // What is small is seldom met: lamps that are looked for are less noisy than a cylinder, which is found by chance.
  Mean const small_ball = spot("define shape sphere p 0 2 0  0.2 lamp");
  Mean const small_box = spot("define shape box p -0.2 2 -0.2  0.2 2.1 0.2 lamp");
  Mean const small_cylinder = spot("define shape cylinder p 0 2 0  0 2.1 0  0.2 lamp");
  CHECK(small_ball.value == Approx(0.5 * 2 * 0.01).margin(3.5 * small_ball.error));
  CHECK(small_cylinder.value == Approx(0.5 * 2 * 0.04 / 4.04).margin(3.5 * small_cylinder.error));
  CHECK(small_ball.error < 0.1 * small_cylinder.error);
  CHECK(small_box.error < 0.1 * small_cylinder.error);
}

TEST_CASE("paths: lamps of too many triangles to look for count in full, whatever else has their material",
          "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Two triangles, doubled twenty times: a sheet of 10 x 10 just above the floor.
  double const tile = 10.0 / 1024;
  std::string const s = "0.009765625";  // the same
  std::string text = R"(
define material matt 0 0 0  0.5 0.5 0.5  0 0 0 1
define material lamp 0 0 0  0 0 0  0 0 0 1  emission 2 2 2
define shape plane floor 0 0 0  0 1 0 matt
define shape sphere hidden 0 -20 0  1 lamp
define camera eye 0.01
transform eye rotate -90 1 0 0
transform eye translate 0 0.1 0
)";
  text += "define shape triangle t 0 0 0  " + s + " 0 0  " + s + " 0 " + s + " lamp\n";
  text += "define shape triangle u 0 0 0  " + s + " 0 " + s + "  0 0 " + s + " lamp\ndefine shape composite g0 t u\n";
  for (int level = 0; level < 20; ++level) {
    std::string const whole = "g" + std::to_string(level + 1), half = "h" + std::to_string(level);
    std::string const shift = std::to_string(tile * (1 << level / 2));
    text += "define shape composite " + half + " g" + std::to_string(level) + "\n";
    text += "transform " + half + " translate " + (level % 2 == 0 ? shift + " 0 0" : "0 0 " + shift) + "\n";
    text += "define shape composite " + whole + " g" + std::to_string(level) + " " + half + "\n";
  }
  text += "transform g20 translate -5 0.2 -5\n";
  Scene const scene = scene_of(text);
  Mean const seen = mean_of(trace(scene, path_request(scene, {32, 32}, 64, 1)));
  double const side = 5, slant = std::hypot(side, 0.2);
  double const form_factor = 4 / 3.14159265358979 * side / slant * std::atan(side / slant);
  INFO(seen.value << " +- " << seen.error);
  CHECK(seen.value == Approx(0.5 * 2 * form_factor).margin(3.5 * seen.error));
  CHECK(seen.error < 0.01);
}

TEST_CASE("paths: a clear coat dims what shines below it, most at grazing angles", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  for (double const degrees : {0., 60., 80.}) {
    INFO(degrees);
    Scene scene = scene_of(R"(
define material lamp 0 0 0  0 0 0  0 0 0 1
define shape plane sheet 0 0 0  0 0 1 lamp
define camera eye 0.01
transform eye translate 0 0 1
transform eye rotate )" + std::to_string(degrees) +
                           " 1 0 0\n");
    PbrModel lamp = pbr(Rgb(0), 0, 1);  // of a black dielectric: what it reflects is black, as nothing else is there
    lamp.emissive = Rgb(2);
    lamp.clearcoat = 0.75;
    **scene.materials.find("lamp") = Material("lamp", lamp);
    double const cosine = std::cos(degrees * 3.14159265358979 / 180);
    double const fresnel = 0.04 + 0.96 * std::pow(1 - cosine, 5);
    Mean const seen = mean_of(trace(scene, path_request(scene, {8, 8}, 16, 2)));
    CHECK(seen.value == Approx(2 * (1 - 0.75 * fresnel)).epsilon(1e-3));
  }
}

TEST_CASE("what shines beyond all measure leaves no pixel without a number", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(R"(
define material matt 0 0 0  0.5 0.5 0.5  0.3 0.3 0.3 20
define material lamp 0 0 0  0 0 0  0 0 0 1  emission 1e30 1e30 1e30
define shape box floor -9 -1.2 -9  9 -1 9 matt
define shape triangle panel -1 1 -6  1 1 -6  1 1 -4 lamp
define shape sphere ball 0 0 -6 0.7 lamp
define light environment sky 1e30 1e30 1e30 brightness=1e6
define camera eye 50
)");
  for (auto const integrator : {Integrator::path, Integrator::whitted}) {
    RenderRequest request = path_request(scene, {24, 18}, 32, 8);
    request.integrator = integrator;
    Image const image = trace(scene, request);
    CHECK(std::ranges::all_of(image.data(), [](float value) { return std::isfinite(value) && value >= 0; }));
  }
}
