#include <algorithm>

#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// So many spheres in one place, behind the camera.
std::string spheres_behind(int count) {
  std::string text =
      "define camera eye 50\ndefine light ambient sky 1 1 1\ndefine material grey 1 1 1  1 1 1  0 0 0  1\n";
  for (int i = 0; i < count; ++i) text += "define shape sphere s" + std::to_string(i) + " 0 0 9 1 grey\n";
  return text;
}

/// The largest part of the picture that was drawn between two reports of progress.
double largest_step(DeviceInfo const& device, int spheres) {
  Scene const scene = scene_of(spheres_behind(spheres));
  auto const renderer = make_renderer(device);
  renderer->set_scene(scene);
  double largest = 0, done = 0;
  Image image;
  render_image(*renderer, whole_picture(scene.cameras.front(), {128, 128}), image, {},
               [&](RenderProgress const& progress) {
                 largest = std::max(largest, progress.fraction - done);
                 done = progress.fraction;
                 return true;
               });
  return largest;
}

}  // namespace

TEST_CASE("tiles are small where a ray may meet very many leaves", "[image][tiles]") {
  REQUIRE_OPENCL_DEVICE();
  DeviceInfo const device = opencl_devices().front();
  CHECK(largest_step(device, 1) == 1);
  // 10,000 leaves of four: one tile's rays may meet 80 million.
  CHECK(largest_step(device, 40000) <= 8000.0 / (128 * 128));
}
