/// The noise that is told of a device's pictures. Of independent samples, tests/unit/noise_limit_test.cpp has it.

#include "lichtraum/noise_limit.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("paths: what is told of the noise is not less than what there is", "[image][path][statistics]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(
      "define material m 0 0 0 0.8 0.6 0.4 0 0 0 1\ndefine shape box floor -3 -2 -9 3 -1 -1 m\n"
      "define shape sphere ball 0 0 -5 1 m\ndefine light diffuse lamp 3 5 0 1 1 1 radius=1\n"
      "define light ambient sky 0.3 0.4 0.5\ndefine camera eye 60\n");
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  RenderRequest request = whole_picture(scene.cameras.front(), {48, 32});
  request.integrator = Integrator::path;
  request.max_depth = 4;
  request.sampling = {Sampling::Pattern::seeded, 4096};
  request.seed = 9;
  Film exact;
  renderer->render(request, exact);
  auto const truth = exact.values(FilmPlane::radiance);

  request.seed = 1;
  for (double const limit : {0.05, 0.01}) {
    Film film;
    auto const result = render_to_noise(*renderer, request, limit, film);
    REQUIRE(result.noise);
    auto const values = film.values(FilmPlane::radiance);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      double const error = double(values[i]) - truth[i];
      sum += error * error / (truth[i] * truth[i] + 0.01);
    }
    double const noise = std::sqrt(sum / double(values.size()));
    CAPTURE(limit, film.samples().count(), noise, *result.noise);
    CHECK(*result.noise <= limit);
    CHECK(noise < 1.1 * *result.noise);  // samples that are more even than random ones leave less
    CHECK(noise > 0.2 * *result.noise);
  }
}
