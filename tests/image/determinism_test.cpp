#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr char const* picture_variable = "LICHTRAUM_TEST_PICTURE";

Scene mixed_scene() {
  return scene_of(
      "define material red    0.9 0.2 0.1  0.9 0.2 0.1  0.5 0.5 0.5  30\n"
      "define material mirror 0.1 0.1 0.1  0.1 0.1 0.1  0.8 0.8 0.8  100 reflect=0.8\n"
      "define material glass  0 0 0  0 0 0  1 1 1  200 reflect=0.1 transmit=0.9 ior=1.5\n"
      "define shape sphere m -1.3 0.2 0 1.2 mirror\n"
      "define shape sphere g 1.3 0.2 1 1.1 glass\n"
      "define shape box floor -30 -2 -30 30 -1 30 red\n"
      "define shape triangle t 0 0 -2  3 0 -3  0 3 -3 red\n"
      "define light ambient sky 0.2 0.2 0.25\n"
      "define light diffuse key -6 9 8  0.6 0.55 0.5\n"
      "define light diffuse fill 7 5 6  0.2 0.3 0.4\n"
      "define background 0.3 0.4 0.6\n"
      "define camera eye 45\ntransform eye rotate -8 1 0 0\ntransform eye translate 0 1 8\n");
}

RenderRequest seeded_request(Scene const& scene) {
  RenderRequest request = whole_picture(scene.cameras.front(), {201, 97});
  request.sampling = {Sampling::Pattern::seeded, 5};
  request.seed = 42;
  request.transfer = Transfer::srgb;
  return request;
}

std::string bytes_of(Image const& image) {
  std::string bytes(image.data().size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), image.data().data(), bytes.size());
  return bytes;
}

}  // namespace

TEST_CASE("a picture put together from regions is the same bytes", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  RenderRequest const request = seeded_request(scene);
  for (DeviceInfo const& device : opencl_devices()) {
    INFO(device.name);
    auto const renderer = make_renderer(device);
    renderer->set_scene(scene);
    Image whole(request.resolution);
    RayCounts const rays = renderer->render(request, whole).statistics.rays;
    for (auto const& [width, height] : {std::pair(201, 1), std::pair(1, 97), std::pair(64, 64), std::pair(33, 20)}) {
      Image pieces(request.resolution);
      RayCounts sum;
      for (int y = 0; y < 97; y += height) {
        for (int x = 0; x < 201; x += width) {
          RenderRequest piece = request;
          piece.region = {x, y, std::min(width, 201 - x), std::min(height, 97 - y)};
          sum += renderer->render(piece, pieces).statistics.rays;
        }
      }
      CHECK(bytes_of(pieces) == bytes_of(whole));
      CHECK(sum.total() == rays.total());
    }
  }
}

TEST_CASE("rendering again gives the same bytes, another seed others", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  RenderRequest request = seeded_request(scene);
  for (DeviceInfo const& device : opencl_devices()) {
    std::string const first = bytes_of(render_on(device, scene, request));
    CHECK(bytes_of(render_on(device, scene, request)) == first);
    RenderRequest other = request;
    other.seed += std::uint64_t(1) << 32;
    CHECK(bytes_of(render_on(device, scene, other)) != first);
  }
}

TEST_CASE("samples added to those before give the bytes of all at once", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  std::vector<DeviceInfo> devices = opencl_devices();
  devices.push_back(reference_device());
  for (DeviceInfo const& device : devices) {
    for (Traversal const traversal : {Traversal::scalar, Traversal::wide, Traversal::packet}) {
      INFO(device.name);
      auto const renderer = make_renderer(device, traversal);
      renderer->set_scene(scene);
      RenderRequest request = seeded_request(scene);
      Accumulation sums;
      std::uint64_t rays = 0;
      for (int const count : {1, 2, 3, 8, 8}) {
        request.sampling.count = count;
        Image all, added;
        renderer->render(request, all);
        rays = renderer->refine(request, sums, added).statistics.rays.camera;
        CHECK(bytes_of(added) == bytes_of(all));
      }
      if (device.kind != DeviceKind::reference) CHECK(rays == 0);  // it had them all

      // Stopped, or of another size, nothing is left to go on from.
      Image image;
      request.sampling.count = 64;
      CHECK(!renderer->refine(request, sums, image, [](RenderProgress const&) { return false; }).complete);
      CHECK(sums.count == 0);
      request.sampling.count = 2;
      renderer->refine(request, sums, image);
      request.resolution = {40, 30};
      request.region = {0, 0, 40, 30};
      Image all;
      renderer->render(request, all);
      renderer->refine(request, sums, image);
      CHECK(bytes_of(image) == bytes_of(all));
      if (device.kind == DeviceKind::reference) break;  // it has one way to trace
    }
  }
}

TEST_CASE("every layout of the tree draws the same bytes, but for pixels at edges", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  RenderRequest const request = seeded_request(scene);
  for (DeviceInfo const& device : opencl_devices()) {
    if (device.kind != DeviceKind::cpu) continue;  // the others have one layout
    INFO(device.name);
    Image const scalar = render_on(device, scene, request, Traversal::scalar);
    for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
      Image const image = render_on(device, scene, request, traversal);
      std::size_t different = 0;
      for (std::size_t i = 0; i < image.data().size(); i += 3) {
        different += std::equal(&image.data()[i], &image.data()[i] + 3, &scalar.data()[i]) ? 0 : 1;
      }
      INFO(int(traversal.grouping));
      CHECK(different <= image.data().size() / 3 / 1000);
    }
  }
}

// Not a test of its own: what the next one runs in processes with another number of threads.
TEST_CASE("write the picture to the file that LICHTRAUM_TEST_PICTURE names", "[.][thread-count-child]") {
  char const* const path = std::getenv(picture_variable);
  REQUIRE(path);
  Scene const scene = mixed_scene();
  std::string bytes;
  for (DeviceInfo const& device : opencl_devices()) bytes += bytes_of(render_on(device, scene, seeded_request(scene)));
  write_file_atomically(path, bytes);
}

TEST_CASE("a picture is the same bytes for any number of PoCL's threads", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  TemporaryFolder const folder;
  std::string const program = std::filesystem::read_symlink("/proc/self/exe").string();
  auto const picture_with = [&](std::string const& threads) {
    std::string const command = fmt::format("POCL_MAX_PTHREAD_COUNT={} {}='{}' '{}' '[thread-count-child]' > /dev/null",
                                            threads, picture_variable, (folder / threads).string(), program);
    REQUIRE(std::system(command.c_str()) == 0);
    return folder.read(threads);
  };
  std::string const one = picture_with("1");
  CHECK(one.size() == opencl_devices().size() * 201 * 97 * 3 * sizeof(float));
  CHECK(picture_with("2") == one);
  CHECK(picture_with("5") == one);
}
