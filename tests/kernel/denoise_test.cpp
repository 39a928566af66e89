#include "lichtraum/denoise.hpp"

#include <cmath>
#include <random>

#include "cl/tile_tracer.hpp"
#include "denoise/noise_planes.hpp"
#include "lichtraum/renderer.hpp"
#include "support/catch.hpp"
#include "support/noisy_room.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("the filter against noise gives the host's bytes on a device", "[kernel][denoise]") {
  NEEDS_OPENCL_DEVICE();
  DeviceList const list = find_devices();
  for (RayGrouping const grouping : {RayGrouping::one, RayGrouping::packet}) {  // a pixel a work-item, and sixteen
    TileTracer tracer(select_device(list, test_device_name().value()), grouping);
    for (Resolution const size : {Resolution{1, 1}, {1, 40}, {40, 1}, {15, 9}, {16, 9}, {17, 9}, {160, 100}}) {
      if (size.width == 160 && scaled_count(100) < 100) continue;
      INFO(size.width << "x" << size.height << ", grouping " << int(grouping));
      NoisyPicture picture = NoisyRoom(size, 4).picture;
      if (size.width == 160) {
        // Far from any picture: of any size, and nothing where it should be something.
        std::mt19937 generator(3);
        for (float& value : picture.radiance) value *= std::ldexp(1.0f, int(generator() % 100) - 50);
        for (int i = 0; i < 100; ++i) picture.depth[generator() % picture.depth.size()] = 0;
      }
      NoisePlanes planes = noise_planes(picture);
      tracer.filter_noise(planes);
      CHECK(radiance_of(planes, picture) == filter_noise(picture));
    }
  }
}

TEST_CASE("each renderer filters noise, without a scene", "[kernel][denoise]") {
  NoisyRoom const room({20, 12}, 4);
  auto const expected = filter_noise(room.picture);
  CHECK(make_renderer(reference_device())->filter_noise(room.picture) == expected);
  NEEDS_OPENCL_DEVICE();
  CHECK(make_renderer(select_device(find_devices(), test_device_name().value()))->filter_noise(room.picture) ==
        expected);
}
