#include <cmath>
#include <cstdlib>

#include "compile/scene_buffers.hpp"
#include "draw_scenes.hpp"
#include "reference/renderer.hpp"
#include "scene/drawn_roots.hpp"
#include "scene/flatten.hpp"

// Any bytes are read as an eSDF scene, which is flattened, compiled for either layout, and drawn by the reference
// tracer; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace lichtraum;
  static std::unique_ptr<Renderer> const renderer = make_reference_renderer();
  fuzz::draw_scenes(data, size, [](Scene const& scene, RenderRequest const& request) {
    for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
      compile_scene(flatten(drawn_roots(scene, {})), scene.lights, layout, nullptr, scene.environment);
    }
    renderer->set_scene(scene);
    Film film;
    renderer->render(request, film);
    for (float const value : film.floats(FilmPlane::radiance)) {
      if (!std::isfinite(value)) std::abort();
    }
  });
  return 0;
}
