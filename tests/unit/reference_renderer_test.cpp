#include "reference/renderer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "lichtraum/error.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

std::shared_ptr<Material> shared(Material const& material) { return std::make_shared<Material>(material); }

/// A ball on a mirror under two lights.
Scene small_scene() {
  Scene scene;
  scene.background = {0.1, 0.2, 0.4};
  Material const mirror("mirror", PhongModel{.ka = Rgb(0.1), .kd = Rgb(0.2), .ks = Rgb(0.5), .m = 30, .reflect = 0.5});
  auto const red = shared(Material("red", {0.2, 0, 0}, {0.8, 0.1, 0.1}, Rgb(0.5), 10));
  scene.shapes.insert(std::make_shared<Sphere>("ball", Vec3(0, 0, -5), 1, red));
  scene.shapes.insert(std::make_shared<Box>("floor", Vec3(-4, -1.5, -9), Vec3(4, -1, -2), shared(mirror)));
  scene.lights.insert(Light::ambient("sky", Rgb(0.3)));
  scene.lights.insert(Light::point("left", {-5, 5, 0}, Rgb(0.7)));
  scene.lights.insert(Light::point("right", {5, 5, 0}, {0.1, 0.2, 0.3}));
  return scene;
}

RenderRequest request_of(Resolution const& size) {
  RenderRequest request;
  request.camera = Camera("eye", 50);
  request.resolution = size;
  request.region = {0, 0, size.width, size.height};
  return request;
}

Image rendered(Renderer& renderer, RenderRequest const& request) {
  Image image;
  REQUIRE(render_image(renderer, request, image).complete);
  return image;
}

ErrorKind kind_of_failure(std::function<void()> const& call) {
  try {
    call();
  } catch (Error const& error) {
    return error.kind();
  }
  FAIL("no Error was thrown");
  return ErrorKind::internal;
}

}  // namespace

TEST_CASE("an environment without a map, or with less of it than it says, is refused", "[unit][reference]") {
  Scene scene = small_scene();
  auto const renderer = make_reference_renderer();
  scene.environment = EnvironmentLight{};
  CHECK_THROWS_AS(renderer->prepare(scene), std::invalid_argument);
  auto map = std::make_shared<EnvironmentMap>(EnvironmentMap{2, 1, {1, 1, 1, 1, 1}});
  scene.environment->map = map;
  CHECK_THROWS_AS(renderer->prepare(scene), std::invalid_argument);
  map->radiance.push_back(1);
  CHECK_NOTHROW(renderer->prepare(scene));
}

TEST_CASE("the reference device describes itself", "[unit][reference]") {
  DeviceInfo const device = reference_device();
  CHECK(device.kind == DeviceKind::reference);
  CHECK(device.compute_units >= 1);
  CHECK(make_reference_renderer()->device().name == "reference");
}

TEST_CASE("a picture is the same bytes for any number of threads and any cut", "[unit][reference]") {
  Scene const scene = small_scene();
  RenderRequest request = request_of({61, 43});
  request.sampling = {Sampling::Pattern::seeded, 3};
  request.seed = 77;
  std::vector<float> expected;
  for (unsigned const threads : {1u, 2u, 3u, 16u}) {
    DeviceInfo device = reference_device();
    device.compute_units = threads;
    auto const renderer = make_reference_renderer(device);
    renderer->set_scene(scene);
    Image const image = rendered(*renderer, request);
    if (expected.empty()) expected = image.data();
    CHECK(image.data() == expected);

    Image pieces(request.resolution);
    for (int x = 0; x < 61; x += 7) {
      for (int y = 0; y < 43; y += 10) {
        RenderRequest piece = request;
        piece.region = {x, y, std::min(7, 61 - x), std::min(10, 43 - y)};
        Image const part = rendered(*renderer, piece);
        for (int row = 0; row < part.height(); ++row) {
          std::copy_n(part.pixel(0, row), 3 * part.width(), pieces.pixel(x, y + row));
        }
      }
    }
    CHECK(pieces.data() == expected);
  }
}

TEST_CASE("a grid sample is the middle of its cell, a single sample the pixel's middle", "[unit][reference]") {
  // A flat white floor seen from above, cut at x = 0 and y = 0: coverage is countable.
  Scene scene;
  scene.lights.insert(Light::ambient("sky", Rgb(1)));
  auto const white = shared(Material("white", Rgb(1), Rgb(0), Rgb(0), 1));
  // The picture is 2 units wide at z = -1 with 2 x 2 pixels, so that a pixel is the unit square.
  scene.shapes.insert(std::make_shared<Box>("cover", Vec3(-1, 0.5, -1), Vec3(-0.70, 1, -1), white));
  auto const renderer = make_reference_renderer();
  renderer->set_scene(scene);
  RenderRequest request = request_of({2, 2});
  request.camera = Camera("eye", 90);
  auto const first_pixel = [&](Sampling::Pattern pattern, int count) {
    request.sampling = {pattern, count};
    return rendered(*renderer, request).pixel(0, 0)[0];
  };
  CHECK(first_pixel(Sampling::Pattern::grid, 1) == 0);
  CHECK(first_pixel(Sampling::Pattern::seeded, 1) == 0);
  CHECK(first_pixel(Sampling::Pattern::grid, 4) == 0.25f);      // x = 0.25 only; y = 0.25
  CHECK(first_pixel(Sampling::Pattern::grid, 16) == 2.f / 16);  // x = 1/8 (not 3/8); y = 1/8, 3/8
  CHECK(first_pixel(Sampling::Pattern::grid, 100) == 15.f / 100);
  float const estimate = first_pixel(Sampling::Pattern::seeded, 4096);
  // Standard deviation sqrt(0.15 * 0.85 / 4096) = 0.0056.
  CHECK(std::abs(estimate - 0.15f) < 5 * 0.0056f);
  request.seed = 1;
  CHECK(first_pixel(Sampling::Pattern::seeded, 4096) != estimate);
}

TEST_CASE("the statistics count rays by kind", "[unit][reference]") {
  Scene scene;
  auto const grey = shared(Material("grey", Rgb(0), Rgb(1), Rgb(0), 1));
  scene.shapes.insert(std::make_shared<Box>("wall", Vec3(-9, -9, -2), Vec3(0, 9, -1), grey));  // the left half
  scene.lights.insert(Light::point("a", {-1, 0, 0}, Rgb(1)));
  scene.lights.insert(Light::point("b", {0, 0, 3}, Rgb(1)));
  scene.lights.insert(Light::point("behind", {-1, 0, -9}, Rgb(1)));
  auto const renderer = make_reference_renderer();
  renderer->set_scene(scene);
  RenderRequest request = request_of({10, 6});
  request.sampling.count = 4;
  Film film;
  RayCounts const rays = renderer->render(request, film).statistics.rays;
  CHECK(rays.camera == 240);
  CHECK(rays.camera_hits == 120);
  CHECK(rays.shadow == 240);
  CHECK(rays.secondary == 0);
}

TEST_CASE("a scene's statistics and bounds come from its graph", "[unit][reference]") {
  Scene scene;
  auto const ball = std::make_shared<Sphere>("ball", Vec3(1, 0, 0), 1, nullptr);
  auto const triangle = std::make_shared<Triangle>("t", Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), nullptr);
  auto const pair = std::make_shared<Composite>("pair", Composite::Children{ball, triangle});
  auto const outer = std::make_shared<Composite>("outer", Composite::Children{pair, pair});
  auto const box = std::make_shared<Box>("box", Vec3(-1, -1, -1), Vec3(1, 1, 1), nullptr);
  ball->scale({2, 1, 1});        // 0..4
  outer->translate({10, 0, 0});  // 10..14
  box->rotate(45, {0, 0, 1});
  for (std::shared_ptr<Shape> const& shape : std::initializer_list<std::shared_ptr<Shape>>{ball, pair, outer, box}) {
    scene.shapes.insert(shape);
  }
  auto const renderer = make_reference_renderer();
  auto prepared = renderer->prepare(scene);
  SceneStatistics const& statistics = prepared->statistics;
  CHECK(statistics.spheres == 1);
  CHECK(statistics.triangles == 1);
  CHECK(statistics.boxes == 1);
  CHECK(statistics.instances == 2);
  CHECK(glm::length(prepared->bounds.min - Vec3(-std::sqrt(2.0), -std::sqrt(2.0), -1)) < 1e-12);
  CHECK(glm::length(prepared->bounds.max - Vec3(14, std::sqrt(2.0), 1)) < 1e-12);

  prepared = renderer->prepare(scene, "pair");  // alone, under its own transform
  CHECK(glm::length(prepared->bounds.max - Vec3(4, 1, 1)) < 1e-12);
  CHECK(kind_of_failure([&] { renderer->set_scene(scene, "nobody"); }) == ErrorKind::usage);

  prepared = renderer->prepare(Scene());
  CHECK(prepared->bounds.is_empty());
}

TEST_CASE("a graph of astronomically many instances is refused with the numbers", "[unit][reference]") {
  std::shared_ptr<Shape> top = std::make_shared<Sphere>("ball", Vec3(0), 1, nullptr);
  for (int i = 0; i < 200; ++i) top = std::make_shared<Composite>("level", Composite::Children{top, top});
  Scene scene;
  scene.shapes.insert(top);
  auto const renderer = make_reference_renderer();
  CHECK(kind_of_failure([&] { renderer->set_scene(scene); }) == ErrorKind::no_device);
  CHECK_THROWS_WITH(renderer->set_scene(scene), contains_text("e+18") && contains_text("1e+07"));
}

TEST_CASE("progress is reported while rendering and can stop it", "[unit][reference]") {
  Scene const scene = small_scene();
  auto const renderer = make_reference_renderer();
  renderer->set_scene(scene);
  RenderRequest request = request_of({300, 200});
  request.sampling.count = 100 * 100;  // minutes, if nobody stopped it
  Film film;
  int calls = 0;
  double last_fraction = 0;
  auto const start = std::chrono::steady_clock::now();
  RenderResult const result = renderer->render(request, film, [&](RenderProgress const& progress) {
    ++calls;
    CHECK(progress.fraction >= last_fraction);
    CHECK(progress.elapsed_seconds > 0);
    last_fraction = progress.fraction;
    return progress.elapsed_seconds < 0.5;
  });
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CHECK(!result.complete);
  CHECK(calls >= 5);  // every 40 ms on a machine that may be busy
  CHECK(seconds < 5);
  // Either blocks of samples are whole, or pixels are whole or black.
  int const count = film.samples().count();
  CHECK((count > 0 && count < request.sampling.count && count % Film::block_size == 0));
  if (count == Film::block_size) {
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 300; ++x) {
        bool const is_black = film.value(FilmPlane::radiance, x, y, 0) == 0;
        REQUIRE(
            (!is_black || film.value(FilmPlane::radiance, x, y, 2) == 0));  // in its shadow, the red ball has no blue
      }
    }
  }

  CHECK_THROWS_AS(renderer->render(request, film, [](RenderProgress const&) -> bool { throw 1; }), int);
}

TEST_CASE("requests that make no sense are refused", "[unit][reference]") {
  auto const renderer = make_reference_renderer();
  Scene const scene = small_scene();
  renderer->set_scene(scene);
  Film film;
  auto const refused = [&](auto const& change) {
    RenderRequest request = request_of({4, 4});
    change(request);
    return kind_of_failure([&] { renderer->render(request, film); }) == ErrorKind::usage;
  };
  CHECK(refused([](RenderRequest& r) { r.region = {1, 0, 4, 4}; }));
  CHECK(refused([](RenderRequest& r) { r.region = {0, -1, 4, 4}; }));
  CHECK(refused([](RenderRequest& r) { r.region = {0, 0, 0, 4}; }));
  CHECK(refused([](RenderRequest& r) { r.region = {2, 0, 2147483647, 4}; }));
  CHECK(refused([](RenderRequest& r) { r.resolution = {0, 4}; }));
  CHECK(refused([](RenderRequest& r) { r.sampling.count = 0; }));
  CHECK(refused([](RenderRequest& r) { r.sampling.count = 8; }));
  CHECK(refused([](RenderRequest& r) { r.max_depth = -1; }));
  CHECK(refused([](RenderRequest& r) { r.planes = {}; }));
  CHECK(refused([](RenderRequest& r) { r.samples = SampleRange{0, 2}; }));
  CHECK(refused([](RenderRequest& r) { r.samples = SampleRange{0, 0}; }));
}

TEST_CASE("a film is developed as it is asked for, or as the scene says", "[unit][reference]") {
  Scene scene;
  scene.background = Rgb(1, 3, 0.5);
  scene.tone_map = ToneMap::reinhard;
  auto const renderer = make_reference_renderer();
  renderer->set_scene(scene);
  auto const pixel = [&](int channel, Development const& development) {
    Image image;
    render_image(*renderer, request_of({1, 1}), image, development);
    return image.pixel(0, 0)[channel];
  };
  CHECK(pixel(1, {}) == 3);
  CHECK(pixel(1, {1, ToneMap::none, Transfer::linear}) == 6);
  CHECK(pixel(1, {0, ToneMap::automatic, Transfer::linear}) == 0.75f);
  CHECK(pixel(0, {0, ToneMap::automatic, Transfer::srgb}) == Approx(0.735357));
}

TEST_CASE("samples that are no numbers are counted and left out", "[unit][reference]") {
  // The second is a number to the tracer, and none to the film.
  for (double const red : {std::numeric_limits<double>::infinity(), 1e39}) {
    Scene scene = small_scene();
    scene.background = Rgb(red, 0, 0);
    auto const renderer = make_reference_renderer();
    renderer->set_scene(scene);
    RenderRequest request = request_of({20, 15});
    request.sampling.count = 4;
    Film film;
    RayCounts const rays = renderer->render(request, film).statistics.rays;
    CHECK(rays.not_finite >= rays.camera - rays.camera_hits);
    CHECK(rays.not_finite < rays.camera);
    for (float const value : film.values(FilmPlane::radiance)) REQUIRE(std::isfinite(value));
  }
}

TEST_CASE("nothing is drawn before there is a scene", "[unit][reference]") {
  auto const renderer = make_reference_renderer();
  Film film;
  CHECK_THROWS_AS(renderer->render(request_of({20, 15}), film), Error);
}

TEST_CASE("another background than the scene's, or none", "[unit][reference]") {
  Scene const scene = small_scene();
  auto const renderer = make_reference_renderer();
  renderer->set_scene(scene);
  RenderRequest request = request_of({20, 15});
  request.background = Rgb(0.5, 0.25, 1);
  CHECK(rendered(*renderer, request).pixel(0, 0)[1] == 0.25f);
  request.planes.add(FilmPlane::alpha);
  Image const cut_out = rendered(*renderer, request);
  CHECK(cut_out.alpha().at(0) == 0);
  CHECK(cut_out.pixel(0, 0)[2] == 0);
  CHECK(cut_out.alpha().at(20 * 7 + 10) == 1);
}
