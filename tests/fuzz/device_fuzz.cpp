#include <cmath>
#include <cstdlib>

#include "draw_scenes.hpp"
#include "lichtraum/device.hpp"

// Any bytes are read as an eSDF scene, which the best OpenCL device draws; tools/fuzz runs this when it is told to. The
// kernels are checked for themselves, under Oclgrind.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace lichtraum;
  static std::unique_ptr<Renderer> const renderer = make_renderer(find_devices().devices.front());
  fuzz::draw_scenes(data, size, [](Scene const& scene, RenderRequest const& request) {
    renderer->set_scene(scene);
    Film film;
    renderer->render(request, film);
    for (float const value : film.floats(FilmPlane::radiance)) {
      if (!std::isfinite(value)) std::abort();
    }
  });
  return 0;
}
