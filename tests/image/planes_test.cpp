#include <sys/resource.h>

#include <cmath>

#include "lichtraum/drawn_objects.hpp"
#include "lichtraum/seen_point.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/textured_meshes.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Resolution const small_size{160, 120};

/// Shapes of each kind; a part that occurs four times (an instance on the device: it has more than eight primitives),
/// between shapes of the world before and after it; shapes that occur twice and are copied.
std::string const graph =
    "define material red 1 0 0  0.8 0.1 0.1  0 0 0  1\n"
    "define shape box floor -30 -3 -30 30 -2.5 30 red\n"
    "define shape sphere ball 0 0.9 0 0.4 red\n"
    "define shape box plate -0.6 -0.6 -0.6 0.6 0.4 0.6 red\n"
    "define shape triangle t1 -1 0 0  0 1 0  -1 1 0 red\ndefine shape triangle t2 1 0 0  1 1 0  0 1 0 red\n"
    "define shape triangle t3 -1 0 0.1  0 1 0.1  -1 1 0.1 red\ndefine shape triangle t4 1 0 0.1  1 1 0.1  0 1 0.1 red\n"
    "define shape triangle t5 -1 -1 0  -0.6 -1 0  -0.8 0 0 red\ndefine shape triangle t6 1 -1 0  0.6 -1 0  0.8 0 0 "
    "red\n"
    "define shape composite wings t1 t2 t3 t4 t5 t6\n"
    "define shape composite part ball plate wings\n"
    "define shape composite left part\ntransform left rotate 30 0 1 0\ntransform left translate -2.2 0 0\n"
    "define shape sphere middle 0 0 0 0.8 red\ntransform middle scale 0.5 1 0.7\n"
    "define shape composite right part\ntransform right scale -1 1.3 0.8\ntransform right translate 2.2 0 0\n"
    "define shape composite row left middle right\n"
    "define shape composite above row\ntransform above rotate 10 0 0 1\ntransform above translate 0 2.8 -1\n"
    "define shape composite all row above\n"
    "define shape box last 3.5 -2 -1 4.2 4 0 red\n"
    "define camera eye 50\ntransform eye rotate -5 1 0 0\ntransform eye translate 0 2.5 12\n";

/// How many values differ: by more than `tolerance` of the expected one's size.
std::size_t differing(Film const& actual, Film const& expected, FilmPlane plane, double tolerance) {
  std::size_t count = 0;
  auto const a = actual.values(plane), e = expected.values(plane);
  for (std::size_t i = 0; i < e.size(); ++i) {
    bool const is_near = a[i] == e[i] || std::abs(a[i] - e[i]) <= float(tolerance) * std::max(1.0f, std::abs(e[i]));
    count += !is_near;
  }
  auto const numbers = actual.numbers(plane), expected_numbers = expected.numbers(plane);
  for (std::size_t i = 0; i < expected_numbers.size(); ++i) count += numbers[i] != expected_numbers[i];
  return count;
}

/// All planes at once, and each alone, on each device in each layout.
void check_planes(Scene const& scene, std::string const& name) {
  struct Tolerated {
    FilmPlane plane;
    double tolerance;
  };
  std::vector<Tolerated> const planes{{FilmPlane::alpha, 0},    {FilmPlane::albedo, 1e-3},   {FilmPlane::normal, 2e-4},
                                      {FilmPlane::depth, 2e-5}, {FilmPlane::position, 1e-4}, {FilmPlane::object, 0},
                                      {FilmPlane::instance, 0}, {FilmPlane::material, 0}};
  RenderRequest request = whole_picture(scene.cameras.front(), small_size);
  request.sampling = {Sampling::Pattern::seeded, 3};
  request.planes.add(FilmPlane::radiance);
  for (auto const& [plane, tolerance] : planes) request.planes.add(plane);
  Film const expected = film_on(reference_device(), scene, request);
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [layout, traversal] : layouts_of(device)) {
      INFO(name << ", " << layout);
      Film const actual = film_on(device, scene, request, traversal);
      for (auto const& [plane, tolerance] : planes) {
        INFO("plane " << info_of(plane).name);
        std::size_t const values = info_of(plane).channels.size() * std::size_t(small_size.width * small_size.height);
        // Silhouettes, which three samples cross more often, and a bumpy normal's steps.
        CHECK(differing(actual, expected, plane, tolerance) <= values / 200);
        RenderRequest alone = request;
        alone.planes = {plane};
        Film const other = film_on(device, scene, alone, traversal);
        CHECK(differing(other, actual, plane, 0) == 0);
      }
    }
  }
}

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

}  // namespace

TEST_CASE("every plane is what the reference tracer finds", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  check_planes(scene_of(graph), "graph");
}

TEST_CASE("what needs no light looks for none", "[image][planes][path]") {
  REQUIRE_OPENCL_DEVICE();
  // So many that to take one of them for something else leads far out of the tables.
  std::string lights;
  for (int i = 0; i < 1000; ++i) lights += "define light " + std::to_string(i) + " -3 4 5 0.001 0.001 0.001 1\n";
  Scene const scene = scene_of(graph + lights);
  RenderRequest request = whole_picture(scene.cameras.front(), small_size);
  for (Integrator const integrator : {Integrator::whitted, Integrator::path}) {
    request.integrator = integrator;
    for (DeviceInfo const& device : opencl_devices()) {
      auto const renderer = make_renderer(device);
      renderer->set_scene(scene);
      Film film;
      request.planes = {FilmPlane::albedo};
      CHECK(renderer->render(request, film).statistics.rays.shadow == 0);
      request.planes.add(FilmPlane::radiance);
      CHECK(renderer->render(request, film).statistics.rays.shadow > 0);
    }
  }
}

TEST_CASE("mirrors and glass show what is behind them in their albedo", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  for (auto const& [shares, shown] : {std::pair("", 0.5), std::pair(" reflect=0.9", 0.04 + 0.1 + 0.9),
                                      std::pair(" reflect=0.25 transmit=0.5", 0.95)}) {
    Scene const scene = scene_of(std::string("define material m 0 0 0  0.4 0.4 0.4  0.1 0.1 0.1  20") + shares +
                                 "\ndefine shape box plate -9 -9 -3  9 9 -2 m\ndefine camera eye 30\n");
    RenderRequest request = whole_picture(scene.cameras.front(), {4, 4});
    request.planes = {FilmPlane::albedo};
    for (DeviceInfo const& device : {opencl_devices().front(), reference_device()}) {
      CHECK(film_on(device, scene, request).values(FilmPlane::albedo)[0] == Approx(std::min(shown, 1.0)));
    }
  }
}

TEST_CASE("a picture's objects lead back to their places in the graph", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(graph);
  DrawnObjects const objects(scene);
  CHECK(objects.count() == 2 * (8 + 1 + 8) + 2);
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  RenderRequest request = whole_picture(scene.cameras.front(), small_size);
  auto const name_at = [&](Vec3 const& point) {
    // Where the camera sees a point: its coordinates in the camera's frame.
    Vec3 const p = request.camera.world_from_camera().inverse().point(point);
    double const width = 2 * std::tan(0.5 * 50 * 3.14159265358979 / 180);
    int const x = int(small_size.width * (0.5 - p.x / p.z / width)),
              y = int(small_size.height / 2.0 + small_size.width * p.y / p.z / width);
    auto const seen = look_at_pixel(*renderer, request, x, y);
    if (!seen) return std::string("nothing");
    CHECK(glm::distance(seen->position, request.camera.world_from_camera().point(Vec3(0))) ==
          Approx(seen->distance).epsilon(1e-6));
    CHECK(glm::distance(seen->position, point) < 0.8);
    CHECK(glm::length(seen->normal) == Approx(1).epsilon(1e-4));
    std::string names;
    for (auto const& shape : objects.shapes_on(objects.path_of(seen->object))) names += "/" + shape->name();
    return names;
  };
  CHECK(name_at({-2.2, 0.9, 0.3}) == "/all/row/left/part/ball");
  CHECK(name_at({2.2, -0.2, 0.5}) == "/all/row/right/part/plate");
  CHECK(name_at({0, 0, 0.5}) == "/all/row/middle");
  CHECK(name_at({0, 2.8, -0.5}) == "/all/above/row/middle");
  CHECK(name_at({3.8, 2, 0}) == "/last");
  CHECK(name_at({0, -2.5, -3}) == "/floor");
  CHECK(name_at({-5, 5, 0}) == "nothing");
}

TEST_CASE("smooth, bumpy and cut out surfaces show in all planes", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  check_planes(make_textured_scene(), "textured");
}

TEST_CASE("planes and paths see through the same backs, and whitted through none", "[image][planes][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Three sheets one behind the other, wound clockwise as the camera sees them, but for the last.
  Scene scene = scene_of(graph +
                         "define material sheet 0 0 0  1 1 1  0 0 0  1\n"
                         "define shape triangle near -3 -2 3  0 3 3  3 -2 3 sheet\n"
                         "define shape triangle far -3 -2 2  0 3 2  3 -2 2 sheet\n"
                         "define shape triangle front -1 -2 1  0 -2 1  -0.5 1.5 1 sheet\n");
  *(*scene.materials.find("sheet")) = Material("sheet", pbr({0.5, 0.5, 0.5}, 0, 1));
  std::vector<FilmPlane> const planes{FilmPlane::depth, FilmPlane::position, FilmPlane::object, FilmPlane::instance,
                                      FilmPlane::material};
  RenderRequest request = whole_picture(scene.cameras.front(), small_size);
  request.planes = {};
  for (FilmPlane const plane : planes) request.planes.add(plane);
  std::vector<std::vector<float>> depths;
  for (Integrator const integrator : {Integrator::whitted, Integrator::path}) {
    request.integrator = integrator;
    Film const expected = film_on(reference_device(), scene, request);
    auto const values = expected.values(FilmPlane::depth);
    depths.emplace_back(values.begin(), values.end());
    for (DeviceInfo const& device : opencl_devices()) {
      for (auto const& [layout, traversal] : layouts_of(device)) {
        INFO(layout << ", integrator " << int(integrator));
        Film const actual = film_on(device, scene, request, traversal);
        for (FilmPlane const plane : planes) {
          INFO("plane " << info_of(plane).name);
          CHECK(differing(actual, expected, plane, 1e-4) <= 10);  // silhouettes
        }
      }
    }
  }
  std::size_t beyond = 0, alike = 0;
  for (std::size_t i = 0; i < depths[0].size(); ++i) {
    CHECK(depths[1][i] >= depths[0][i] * 0.9999f);
    beyond += depths[1][i] > depths[0][i] + 1;
    alike += std::isfinite(depths[0][i]) && depths[1][i] < depths[0][i] * 1.0001f;
  }
  CHECK(beyond > depths[0].size() / 20);
  CHECK(alike > depths[0].size() / 20);
}

TEST_CASE("a transparent picture leaves out the background, and mirrors still show it", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(
      "define material mirror 0 0 0  0 0 0  0 0 0  1 reflect=1\ndefine shape sphere ball 0 0 -5 1 mirror\n"
      "define background 0.5 0.25 1\ndefine camera eye 60\n");
  RenderRequest request = whole_picture(scene.cameras.front(), {31, 31});
  request.planes.add(FilmPlane::alpha);
  std::vector<DeviceInfo> devices = opencl_devices();
  devices.push_back(reference_device());
  for (DeviceInfo const& device : devices) {
    INFO(device.name);
    Film const film = film_on(device, scene, request);
    CHECK(film.value(FilmPlane::alpha, 0, 0) == 0);
    CHECK(film.value(FilmPlane::radiance, 0, 0, 0) == 0);
    CHECK(film.value(FilmPlane::alpha, 15, 15) == 1);
    CHECK(film.value(FilmPlane::radiance, 15, 15, 2) == Approx(1));
  }
}

TEST_CASE("a device develops films to the bytes of the host", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  Film film({0, 0, 61, 47}, {FilmPlane::radiance, FilmPlane::alpha});
  float value = 1e-9f;
  for (float& sum : film.floats(FilmPlane::radiance)) sum = value = value > 1e6f ? 1e-9f : value * 1.0371f;
  float covered = 0;
  for (float& sum : film.floats(FilmPlane::alpha)) sum = covered = covered == 7 ? 0 : covered + 1;
  film.set_end(7);
  for (DeviceInfo const& device : opencl_devices()) {
    auto const renderer = make_renderer(device);
    renderer->set_scene(scene_of(graph));
    for (bool const has_alpha : {true, false}) {
      if (!has_alpha) film.keep({FilmPlane::radiance});
      for (ToneMap const tone_map : {ToneMap::none, ToneMap::reinhard, ToneMap::neutral, ToneMap::agx, ToneMap::aces}) {
        for (Transfer const transfer : {Transfer::linear, Transfer::srgb}) {
          Development const development{0.7, tone_map, transfer};
          Image const here = develop(film, development), there = renderer->develop(film, development);
          CHECK(there.data() == here.data());
          CHECK(there.alpha() == here.alpha());
        }
      }
    }
  }
}

TEST_CASE("a part of a huge picture takes memory for that part", "[image][planes]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(graph);
  RenderRequest request = whole_picture(scene.cameras.front(), {100'000, 100'000});
  request.region = {50'000, 50'000, 256, 256};
  for (std::size_t i = 0; i < plane_count; ++i) request.planes.add(FilmPlane(i));
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  Film film;
  renderer->render(request, film);  // with the program
  film = {};
  auto const before = peak_memory_bytes();
  renderer->render(request, film);
  CHECK(film.size() == Resolution{256, 256});
  CHECK(film.samples() == SampleRange{0, 1});
  CHECK(peak_memory_bytes() - before < 50'000'000);
}
