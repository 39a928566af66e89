/// Pictures of lines: every layout agrees with the reference renderer.

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

/// A walk whose vertices have colours far apart, so that what is between them shows.
std::string walk_ply(std::size_t count) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
      count, count - 1);
  std::mt19937 random(7);
  auto const coordinate = [&random] { return double(random()) / 2147483648.0 - 1; };
  for (std::size_t i = 0; i < count; ++i) {
    double const x = coordinate(), y = coordinate(), z = coordinate();
    text += fmt::format("{} {} {} {} {} {}\n", x, y, z, i % 2 * 255, i % 3 * 127, i % 5 * 63);
  }
  for (std::size_t i = 0; i + 1 < count; ++i) text += fmt::format("{} {}\n", i, i + 1);
  return text;
}

}  // namespace

TEST_CASE("lines look alike on the reference renderer and on every device, in every layout", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  TemporaryFolder const folder;
  folder.write("walk.ply", walk_ply(40));
  // With colours, twice the same, stretched, in one material, and beside a cylinder that has no colours.
  EsdfScript const script = EsdfScript::from_file(folder.write("scene.sdf", R"(
define material red 0.2 0 0  0.8 0.1 0.1  0.3 0.3 0.3  20
define light diffuse sun 3 5 9  1 1 1
define light ambient sky 0.4 0.4 0.4
define shape mesh walk walk.ply
define shape mesh stretched walk.ply
define shape mesh plain walk.ply red
define shape composite once walk
define shape composite again walk
define shape cylinder stick -4 -1.3 0  4 -1.3 0  0.2 red
transform stretched scale 1 2 0.5
transform stretched translate 3 0 0
transform plain translate -3 0 0
transform again rotate 70 1 1 0
transform again translate 0 2 -1
define shape composite all once again stretched plain stick
define camera eye 60
transform eye translate 0 0.5 6
)"));
  Scene const& scene = script.scene();
  RenderRequest request = whole_picture(scene.cameras.front(), {160, 120});
  request.max_depth = 2;
  check_layouts(scene, request, "lines");
}
