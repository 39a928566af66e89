#include "support/path_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/picture_check.hpp"

namespace lichtraum::test {

RenderRequest path_request(Scene const& scene, Resolution const& size, int samples, int max_depth) {
  RenderRequest request = whole_picture(scene.cameras.front(), size);
  request.integrator = Integrator::path;
  request.sampling = {samples == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, samples};
  request.max_depth = max_depth;
  request.seed = 7;
  return request;
}

Image trace(Scene const& scene, RenderRequest const& request) {
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  Image image;
  RenderResult const result = render_image(*renderer, request, image);
  CHECK(result.statistics.rays.not_finite == 0);
  return image;
}

Mean mean_of(Image const& image) {
  Mean mean;
  double squares = 0;
  double const count = double(image.width()) * image.height();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      double const value = image.pixel(x, y)[0];
      mean.value += value / count;
      squares += value * value / count;
      mean.least = std::min(mean.least, value);
      mean.most = std::max(mean.most, value);
    }
  }
  mean.error = std::sqrt(std::max(squares - mean.value * mean.value, 0.0) / count);
  return mean;
}

}  // namespace lichtraum::test
