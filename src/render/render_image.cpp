#include "lichtraum/renderer.hpp"

namespace lichtraum {

RenderResult render_image(Renderer& renderer, RenderRequest const& request, Image& image,
                          Development const& development, ProgressFunction const& progress) {
  Film film;
  RenderResult const result = renderer.render(request, film, progress);
  image = renderer.develop(std::move(film), development);
  return result;
}

}  // namespace lichtraum
