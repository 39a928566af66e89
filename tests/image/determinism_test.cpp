#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/path_pictures.hpp"
#include "support/path_scenes.hpp"
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

// Two tiles of 64 pixels in each direction, where many samples are traced.
constexpr Resolution four_tiles{101, 67};

RenderRequest seeded_request(Scene const& scene, Integrator integrator, Resolution resolution = {201, 97}) {
  RenderRequest request = whole_picture(scene.cameras.front(), resolution);
  request.integrator = integrator;
  request.sampling = {Sampling::Pattern::seeded, 5};
  request.seed = 42;
  return request;
}

std::string bytes_of(Image const& image) {
  std::string bytes(image.data().size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), image.data().data(), bytes.size());
  return bytes;
}

/// All that can be read from a film, bit by bit.
bool same_bytes(Film const& a, Film const& b) {
  if (a.region() != b.region() || a.planes() != b.planes() || a.samples() != b.samples()) return false;
  for (FilmPlane const plane : a.planes().list()) {
    auto const x = a.values(plane), y = b.values(plane);
    if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) != 0) return false;
    if (!std::ranges::equal(a.numbers(plane), b.numbers(plane))) return false;
  }
  return true;
}

PlaneSet all_planes() {
  PlaneSet planes;
  for (std::size_t i = 0; i < plane_count; ++i) planes.add(FilmPlane(i));
  return planes;
}

/// Every device with every traversal, and the reference tracer if it has the integrator.
template <class Check>
void for_each_renderer(Integrator integrator, Check const& check) {
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [layout, traversal] : layouts_of(device)) {
      INFO(device.name << ", " << layout);
      check(*make_renderer(device, traversal));
    }
  }
  if (integrator != Integrator::whitted) return;
  INFO("reference");
  check(*make_renderer(reference_device()));
}

}  // namespace

TEST_CASE("a picture put together from regions is the same bytes", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  RenderRequest const request = seeded_request(scene, integrator);
  for (DeviceInfo const& device : opencl_devices()) {
    INFO(device.name);
    auto const renderer = make_renderer(device);
    renderer->set_scene(scene);
    Image whole;
    RayCounts const rays = render_image(*renderer, request, whole).statistics.rays;
    for (auto const& [width, height] : {std::pair(201, 1), std::pair(1, 97), std::pair(64, 64), std::pair(33, 20)}) {
      Image pieces(request.resolution);
      RayCounts sum;
      for (int y = 0; y < 97; y += height) {
        for (int x = 0; x < 201; x += width) {
          RenderRequest piece = request;
          piece.region = {x, y, std::min(width, 201 - x), std::min(height, 97 - y)};
          Image part;
          sum += render_image(*renderer, piece, part).statistics.rays;
          for (int row = 0; row < part.height(); ++row) {
            std::copy_n(part.pixel(0, row), 3 * part.width(), pieces.pixel(x, y + row));
          }
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
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  RenderRequest request = seeded_request(scene, integrator);
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
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  for_each_renderer(integrator, [&](Renderer& renderer) {
    renderer.set_scene(scene);
    RenderRequest request = seeded_request(scene, integrator, four_tiles);
    request.planes = all_planes();
    Film grown;
    std::uint64_t rays = 0;
    for (int const count : {2, 3, 15, 16, 17, 40, 40}) {
      request.sampling.count = count;
      Film all;
      renderer.render(request, all);
      rays = renderer.render(request, grown).statistics.rays.camera;
      INFO(count << " samples");
      CHECK(same_bytes(grown, all));
    }
    CHECK(rays == 0);  // it had them all

    // Of another region, it is begun anew.
    request.region = {3, 2, 30, 20};
    Film all;
    renderer.render(request, all);
    renderer.render(request, grown);
    CHECK(same_bytes(grown, all));
  });
}

TEST_CASE("what is stopped keeps the blocks of samples that are whole", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  for_each_renderer(integrator, [&](Renderer& renderer) {
    renderer.set_scene(scene);
    RenderRequest request = seeded_request(scene, integrator, four_tiles);
    request.sampling.count = 100;
    double const after = 0.7;
    Film film;
    auto const result = renderer.render(request, film, [&](RenderProgress const& p) { return p.fraction < after; });
    REQUIRE(!result.complete);
    CHECK(film.samples().count() >= 64);
    CHECK(film.samples().count() % Film::block_size == 0);
    request.samples = SampleRange{0, film.samples().end};
    Film expected;
    renderer.render(request, expected);
    CHECK(same_bytes(film, expected));
    request.samples.reset();
    renderer.render(request, film);
    Film all;
    renderer.render(request, all);
    CHECK(same_bytes(film, all));
  });
}

TEST_CASE("what is traced in one launch a block can be stopped as well", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  for_each_renderer(Integrator::path, [&](Renderer& renderer) {
    renderer.set_scene(scene);
    RenderRequest request = seeded_request(scene, Integrator::path, {8, 8});
    request.sampling.count = 5 * Film::block_size;
    Film film;
    auto const result = renderer.render(request, film, [&](RenderProgress const& p) { return p.fraction < 0.3; });
    CHECK(!result.complete);
    CHECK(film.samples().count() == 2 * Film::block_size);
  });
}

TEST_CASE("ranges of samples that are traced apart merge to the bytes of all", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  for_each_renderer(integrator, [&](Renderer& renderer) {
    renderer.set_scene(scene);
    for (Sampling const sampling : {Sampling{Sampling::Pattern::seeded, 70}, Sampling{Sampling::Pattern::grid, 81}}) {
      RenderRequest request = seeded_request(scene, integrator, four_tiles);
      request.sampling = sampling;
      request.planes = all_planes();
      Film all;
      renderer.render(request, all);
      auto const range = [&](int first, int end) {
        request.samples = SampleRange{first, end};
        Film part;
        REQUIRE(renderer.render(request, part).complete);
        return part;
      };
      Film merged = range(0, 16);
      Film later = range(48, 64);
      later.merge(range(64, sampling.count));
      Film between = range(16, 48);
      between.merge(later);
      merged.merge(between);
      CHECK(merged.samples() == SampleRange{0, sampling.count});
      CHECK(same_bytes(merged, all));
      CHECK_THROWS_AS(merged.merge(later), std::invalid_argument);
      request.samples = SampleRange{8, 16};
      Film film;
      CHECK_THROWS_AS(renderer.render(request, film), Error);
    }
  });
}

namespace {

/// Checks that no more than a share of the pixels depends on the layout of the tree: by more than `tolerance` of their
/// value.
void check_same_in_layouts(Scene const& scene, RenderRequest const& request, double allowed_share, float tolerance) {
  for (DeviceInfo const& device : opencl_devices()) {
    Image const scalar = render_on(device, scene, request, Traversal::scalar);
    for (auto const& [layout, traversal] : layouts_of(device).subspan(1)) {
      INFO(device.name << ", " << layout);
      Image const image = render_on(device, scene, request, traversal);
      std::size_t different = 0;
      for (std::size_t i = 0; i < image.data().size(); i += 3) {
        auto const is_same = [&](float a, float b) { return std::abs(a - b) <= tolerance * std::abs(b); };
        different += std::equal(&image.data()[i], &image.data()[i] + 3, &scalar.data()[i], is_same) ? 0 : 1;
      }
      CHECK(double(different) <= allowed_share * double(image.data().size() / 3));
    }
  }
}

}  // namespace

TEST_CASE("every layout of the tree draws the same bytes, but for pixels at edges", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = mixed_scene();
  Integrator const integrator = GENERATE(Integrator::whitted, Integrator::path);
  check_same_in_layouts(scene, seeded_request(scene, integrator), 0.001, 0);
}

TEST_CASE("every layout traces the same paths, but for those that meet edges", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  for (PathScene const& drawn : path_scenes()) {
    INFO(drawn.name);
    RenderRequest request = path_request(drawn.scene, {32, 24}, 8, drawn.max_depth);
    request.ground = drawn.ground;
    // What several panes let through is multiplied in the order of the visits.
    check_same_in_layouts(drawn.scene, request, 0.001, 1e-5f);
  }
}

// Not a test of its own: what the next one runs in processes with another number of threads.
TEST_CASE("write the picture to the file that LICHTRAUM_TEST_PICTURE names", "[.][thread-count-child]") {
  char const* const path = std::getenv(picture_variable);
  REQUIRE(path);
  Scene const scene = mixed_scene();
  std::string bytes;
  for (DeviceInfo const& device : opencl_devices()) {
    for (Integrator const integrator : {Integrator::whitted, Integrator::path}) {
      bytes += bytes_of(render_on(device, scene, seeded_request(scene, integrator)));
    }
  }
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
  CHECK(one.size() == 2 * opencl_devices().size() * 201 * 97 * 3 * sizeof(float));
  CHECK(picture_with("2") == one);
  CHECK(picture_with("5") == one);
}
