/// Pictures of point clouds: every layout agrees with the reference renderer.

#include <fmt/format.h>

#include <random>

#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::string cloud_ply(std::size_t count) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
      count);
  std::mt19937 random(7);
  auto const coordinate = [&random] { return double(random()) / 2147483648.0 - 1; };
  for (std::size_t i = 0; i < count; ++i) {
    double const x = coordinate(), y = coordinate(), z = coordinate();
    text += fmt::format("{} {} {} {} {} {}\n", x, y, z, i % 256, (i * 7) % 256, (i * 31) % 256);
  }
  return text;
}

}  // namespace

TEST_CASE("point clouds look alike on the reference renderer and on every device, in every layout", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  TemporaryFolder const folder;
  folder.write("cloud.ply", cloud_ply(300));
  // With colours, stretched, in one material, and beside spheres that have no colours of their own.
  EsdfScript const script = EsdfScript::from_file(folder.write("scene.sdf", R"(
define material red 0.2 0 0  0.8 0.1 0.1  0.3 0.3 0.3  20
define light diffuse sun 3 5 9  1 1 1
define light ambient sky 0.4 0.4 0.4
define shape mesh cloud cloud.ply
define shape mesh stretched cloud.ply
define shape mesh plain cloud.ply red
define shape sphere ball 0 -11 0 9 red
transform stretched scale 1 2 0.5
transform stretched translate 3 0 0
transform plain translate -3 0 0
define shape composite all cloud stretched plain ball
define camera eye 60
transform eye translate 0 0.5 6
)"));
  Scene const& scene = script.scene();
  RenderRequest request = whole_picture(scene.cameras.front(), {160, 120});
  request.max_depth = 2;
  check_layouts(scene, request, "points");
}
