#include "view/worker.hpp"

#include "app/renderer_choice.hpp"
#include "lichtraum/turntable.hpp"

namespace lichtraum::view {

Worker::Worker(app::SceneSource const& source, app::RenderOptions const& options, bool is_watching,
               app::Console const& console)
    : source_(source),
      options_(options),
      is_watching_(is_watching),
      console_(console),
      thread_([this](std::stop_token const& stop) { work(stop); }) {}

Worker::~Worker() {
  thread_.request_stop();
  changed_.notify_all();
}

void Worker::show(RenderRequest const& view) {
  std::lock_guard const lock(mutex_);
  view_ = view;
  is_new_view_ = true;
  refinement_.restart();
  changed_.notify_all();
}

Worker::News Worker::news() {
  std::lock_guard const lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  News news = std::move(news_);
  news_ = {};
  return news;
}

void Worker::work(std::stop_token const& stop) {
  constexpr auto look_again = std::chrono::milliseconds(50);
  try {
    auto const renderer = app::choose_renderer(options_.device, options_.traversal, console_);
    {
      std::lock_guard const lock(mutex_);
      news_.device = renderer->device().name;
    }
    file_has_changed();
    load(*renderer);
    while (!stop.stop_requested()) {
      if (is_watching_ && file_has_changed()) load(*renderer);
      if (trace_next(*renderer, stop)) continue;
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, look_again, [&] { return is_new_view_ || stop.stop_requested(); });
    }
  } catch (...) {
    std::lock_guard const lock(mutex_);
    failure_ = std::current_exception();
  }
}

bool Worker::file_has_changed() {
  std::error_code error;
  auto const time = std::filesystem::last_write_time(source_.name(), error);
  auto const size = error ? 0 : std::filesystem::file_size(source_.name(), error);
  if (error || (time == file_time_ && size == file_size_)) return false;  // an editor may be about to rename it
  file_time_ = time;
  file_size_ = size;
  return true;
}

void Worker::load(Renderer& renderer) {
  try {
    app::LoadedScene const loaded = source_.load(options_.load);
    SceneView scene;
    scene.request = app::first_view(loaded, source_, options_);
    scene.cameras.assign(loaded.scene().cameras.begin(), loaded.scene().cameras.end());
    scene.center = center_of_interest(loaded.scene(), options_.root, scene.request.camera);
    prepared_ = renderer.prepare(loaded.scene(), options_.root, prepared_);
    scene_statistics_ = renderer.set_scene(prepared_);
    scene.bounds_min = prepared_->bounds_min;
    scene.bounds_max = prepared_->bounds_max;
    std::lock_guard const lock(mutex_);
    news_.scene = std::move(scene);
    news_.problem = "";
    refinement_.restart();
  } catch (Error const& error) {
    if (!prepared_) throw;  // there is no picture to keep
    std::lock_guard const lock(mutex_);
    news_.problem = error.what();
  }
}

bool Worker::trace_next(Renderer& renderer, std::stop_token const& stop) {
  RenderRequest request;
  Refinement::Pass pass;
  {
    std::lock_guard const lock(mutex_);
    if (!view_) return false;
    auto const next = refinement_.next();
    if (!next) return false;
    pass = *next;
    request = Refinement::request(*view_, pass);
    is_new_view_ = false;
  }
  Frame frame;
  frame.pass = pass;
  frame.scene = scene_statistics_;
  RenderResult const result = renderer.render(request, frame.image, [&](RenderProgress const&) {
    if (stop.stop_requested()) return false;
    std::lock_guard const lock(mutex_);
    // The coarsest picture is finished whatever comes: else nothing would be seen while the camera moves.
    return pass.pixel_side == 8 || !is_new_view_;
  });
  if (!result.complete) return true;
  frame.statistics = result.statistics;
  std::lock_guard const lock(mutex_);
  news_.frame = std::move(frame);
  return true;
}

}  // namespace lichtraum::view
