/// How much noise is left in a picture, and how many samples it takes until so little is.

#include "lichtraum/noise_limit.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "lichtraum/environment.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

/// A matt ball under a sky that is brighter at one side: noise, but no surprises.
std::unique_ptr<Renderer> renderer_with_ball() {
  Scene scene;
  scene.shapes.insert(std::make_shared<Sphere>("ball", Vec3(0, 0, -5), 1.5,
                                               std::make_shared<Material>("matt", PhongModel{.kd = Rgb(0.8)})));
  EnvironmentMap sky{2, 1, {0.2f, 0.3f, 0.4f, 1.8f, 1.4f, 1}};
  scene.environment = EnvironmentLight{"sky", std::make_shared<EnvironmentMap const>(std::move(sky))};
  auto renderer = make_reference_renderer(reference_device());
  renderer->set_scene(scene);
  return renderer;
}

RenderRequest request_for(int samples, std::uint64_t seed = 0) {
  RenderRequest request;
  request.camera = Camera("eye", 18);
  request.resolution = {24, 24};
  request.region = whole_picture(request.resolution);
  request.integrator = Integrator::path;
  request.max_depth = 2;
  request.sampling = {Sampling::Pattern::seeded, samples};
  request.seed = seed;
  return request;
}

}  // namespace

TEST_CASE("noise is estimated as it is", "[unit][noise][statistics]") {
  auto const renderer = renderer_with_ball();
  Film exact;
  renderer->render(request_for(8192, 77), exact);
  auto const truth = exact.values(FilmPlane::radiance);
  for (auto const& [earlier_samples, samples] : {std::pair(64, 128), std::pair(64, 80), std::pair(16, 128)}) {
    Film film;
    RenderRequest request = request_for(samples);
    request.samples = SampleRange{0, earlier_samples};
    renderer->render(request, film);
    auto const earlier = film.values(FilmPlane::radiance);
    request.samples = SampleRange{0, samples};
    renderer->render(request, film);
    auto const values = film.values(FilmPlane::radiance);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      double const error = double(values[i]) - truth[i];
      sum += error * error / (truth[i] * truth[i] + 0.01);
    }
    double const noise = std::sqrt(sum / double(values.size()));
    INFO(earlier_samples << " of " << samples << " samples: " << noise);
    CHECK(noise_since(earlier, earlier_samples, values, samples) == Approx(noise).epsilon(0.15));
    CHECK_THROWS_AS(noise_since(earlier, samples, values, samples), std::invalid_argument);
    CHECK_THROWS_AS(noise_since({}, earlier_samples, values, samples), std::invalid_argument);
  }
}

TEST_CASE("a limit of noise takes as many samples as it needs, which are the first of all", "[unit][noise]") {
  auto const renderer = renderer_with_ball();
  Film loose, strict;
  double last = 0;
  auto const watch = [&](RenderProgress const& progress) {
    CHECK(progress.fraction <= 1);
    last = progress.fraction;
    return true;
  };
  auto const first = render_to_noise(*renderer, request_for(4096), 0.08, loose, watch);
  auto const second = render_to_noise(*renderer, request_for(4096), 0.04, strict);
  REQUIRE(first.render.complete);
  REQUIRE(first.noise);
  CHECK(*first.noise <= 0.08);
  CHECK(*first.noise > 0.05);  // not many more than it takes
  CHECK(*second.noise <= 0.04);
  double const ratio = double(strict.samples().count()) / loose.samples().count();
  CHECK(ratio > 2.5);  // four times, in whole blocks
  CHECK(ratio < 6);
  CHECK(last > 0.2);
  CHECK(first.render.statistics.rays.camera == std::uint64_t(24 * 24 * loose.samples().count()));

  Film plain;
  renderer->render(request_for(loose.samples().count()), plain);
  CHECK(plain.values(FilmPlane::radiance) == loose.values(FilmPlane::radiance));
}

TEST_CASE("with a limit of noise, progress is 0 until it is known how many samples that takes",
          "[unit][noise][pictures]") {
  RenderRequest request = request_for(4096);
  request.resolution = {256, 256};  // large enough for the first block to be reported on
  request.region = whole_picture(request.resolution);
  Film film;
  int unknown = 0, known = 0;
  auto const stop_once_known = [&](RenderProgress const& progress) {
    bool const is_known = film.samples().count() >= 2 * Film::block_size;
    CHECK((progress.fraction > 0) == is_known);
    ++(is_known ? known : unknown);
    return !is_known;
  };
  CHECK(!render_to_noise(*renderer_with_ball(), request, 0.01, film, stop_once_known).render.complete);
  CHECK(unknown > 0);
  CHECK(known == 1);
}

TEST_CASE("a limit of noise that is out of reach takes all samples, and what is stopped is not complete",
          "[unit][noise]") {
  auto const renderer = renderer_with_ball();
  Film film;
  auto const result = render_to_noise(*renderer, request_for(40), 1e-6, film);
  CHECK(result.render.complete);
  CHECK(film.samples().count() == 40);
  CHECK(*result.noise > 1e-6);
  Film few;
  CHECK(!render_to_noise(*renderer, request_for(16), 0.5, few).noise);  // nothing to compare
  CHECK(few.samples().count() == 16);
  Film stopped;
  CHECK(
      !render_to_noise(*renderer, request_for(4096), 1e-6, stopped, [](auto const&) { return false; }).render.complete);

  CHECK_THROWS_AS(render_to_noise(*renderer, request_for(64), 0, film), std::invalid_argument);
  RenderRequest bad = request_for(64);
  bad.sampling.pattern = Sampling::Pattern::grid;
  CHECK_THROWS_AS(render_to_noise(*renderer, bad, 0.1, film), std::invalid_argument);
  bad = request_for(64);
  bad.samples = SampleRange{0, 16};
  CHECK_THROWS_AS(render_to_noise(*renderer, bad, 0.1, film), std::invalid_argument);
}
