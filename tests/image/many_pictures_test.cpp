/// A program that draws all day long does not grow.

#include <cstdlib>
#include <fstream>
#include <string>

#include "lichtraum/device.hpp"
#include "lichtraum/renderer.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// Of this process, without files: kB.
long memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "RssAnon:") {
      long kilobytes = 0;
      status >> kilobytes;
      return kilobytes;
    }
  }
  return 0;
}

int picture_count() {
  char const* const count = std::getenv("LICHTRAUM_PICTURES");
  return count ? std::atoi(count) : 3000;
}

/// A scene is read, prepared and drawn, again and again, in two forms that share nothing.
void draw_many(Renderer& renderer, int count) {
  long before = 0;
  Image image;
  for (int i = 0; i < count; ++i) {
    std::string const place = i % 2 == 0 ? "0 0 0" : "0.5 0 0";
    Scene const scene =
        scene_of("define material red 0.8 0.1 0.1  0.8 0.1 0.1  0 0 0  1\ndefine shape sphere a " + place +
                 "  0.8 red\ndefine shape box b -1 -2 -1  1 -1 1 red\ndefine shape composite c a b\n"
                 "define camera eye 50\ntransform eye translate 0 1 6\n");
    renderer.set_scene(renderer.prepare(scene));
    REQUIRE(render_image(renderer, whole_picture(scene.cameras.front(), {8, 6}), image).complete);
    if (i == count / 10) before = memory();
  }
  INFO(renderer.device().name << ", " << count << " pictures, from " << before << " kB to " << memory() << " kB");
  CHECK(before > 0);
  CHECK(memory() <= before + before / 20);
}

}  // namespace

TEST_CASE("memory does not grow from picture to picture", "[image][soak]") {
  REQUIRE_OPENCL_DEVICE();
  std::ifstream const status("/proc/self/status");
  if (!status) SKIP_TEST("no /proc");
  draw_many(*make_renderer(reference_device()), picture_count());
  draw_many(*make_renderer(opencl_devices().front()), picture_count());
}
