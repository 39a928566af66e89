#include <utility>

#include "view/marking.hpp"
#include "view/worker.hpp"

// What a Worker finds out about the view: what is under a pixel, and where the selected objects are.

namespace lichtraum::view {

void Worker::look_at(int x, int y) {
  std::lock_guard const lock(mutex_);
  looked_at_ = Pixel{x, y};
  has_question_ = true;
  changed_.notify_all();
}

void Worker::mark(ObjectTree::Objects const& objects) {
  std::lock_guard const lock(mutex_);
  marked_ = objects;
  expect_marking();
  has_question_ = true;
  changed_.notify_all();
}

void Worker::expect_marking() {
  is_marking_due_ = marked_.count > 0;
  news_.marking.reset();  // of another view, or of what was selected before
}

void Worker::look_at_pixel(Renderer& renderer) {
  std::optional<Pixel> pixel;
  RenderRequest view;
  {
    std::lock_guard const lock(mutex_);
    has_question_ = false;
    pixel.swap(looked_at_);
    if (!pixel || !view_) return;
    view = *view_;
  }
  Look look{scene_number_, {}};
  Resolution const& size = view.resolution;
  if (pixel->x >= 0 && pixel->y >= 0 && pixel->x < size.width && pixel->y < size.height) {
    look.seen = lichtraum::look_at_pixel(renderer, view, pixel->x, pixel->y);
  }
  {
    std::lock_guard const lock(mutex_);
    news_.look = look;
  }
  wake_();
}

void Worker::trace_marking(Renderer& renderer, std::stop_token const& stop) {
  RenderRequest request;
  ObjectTree::Objects marked;
  {
    std::lock_guard const lock(mutex_);
    if (!is_marking_due_ || is_new_view_ || !view_) return;
    is_marking_due_ = false;
    marked = marked_;
    request = Refinement::request(*view_, {});
  }
  request.planes = {FilmPlane::object};
  Film film;
  auto const is_wanted = [&] { return !stop.stop_requested() && !is_new_view_ && marked == marked_; };
  RenderResult const result = renderer.render(request, film, [&](RenderProgress const&) {
    std::lock_guard const lock(mutex_);
    return is_wanted();
  });
  Marking marking{request.resolution, outline_pixels(film, marked)};
  {
    std::lock_guard const lock(mutex_);
    if (!result.complete || !is_wanted()) {
      expect_marking();
      return;
    }
    news_.marking = std::move(marking);
  }
  wake_();
}

}  // namespace lichtraum::view
