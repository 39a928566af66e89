#include "view/worker.hpp"

#include <fmt/format.h>

#include "app/renderer_choice.hpp"
#include "app/stopwatch.hpp"
#include "lichtraum/turntable.hpp"
#include "view/display_pixels.hpp"

namespace lichtraum::view {
namespace {

constexpr auto time_between_looks = std::chrono::milliseconds(50);

/// A view that is being moved gets the finest picture that is traced in this time: with putting it on the screen, 30
/// of them a second.
constexpr double moving_pass_seconds = 0.028;

}  // namespace

Worker::Worker(app::SceneSource const& source, app::RenderOptions const& options, bool is_watching,
               app::Console const& console, std::function<void()> wake)
    : source_(source),
      options_(options),
      is_watching_(is_watching),
      console_(console),
      wake_(std::move(wake)),
      thread_([this](std::stop_token const& stop) { work(stop); }) {}

Worker::~Worker() {
  thread_.request_stop();
  changed_.notify_all();
}

void Worker::show(RenderRequest const& view) {
  std::lock_guard const lock(mutex_);
  view_ = view;
  is_new_view_ = true;
  restart_refinement();
  changed_.notify_all();
}

void Worker::restart_refinement() {
  int first_side = 8;
  if (view_ && seconds_per_pixel_) {
    first_side = Refinement::first_side_for(view_->resolution, *seconds_per_pixel_, moving_pass_seconds);
  }
  refinement_.restart(first_side, options_.sampling.value_or(Refinement::finest_by_default));
}

Worker::News Worker::news() {
  std::lock_guard const lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  News news = std::move(news_);
  news_ = {};
  return news;
}

void Worker::work(std::stop_token const& stop) {
  try {
    auto const renderer = app::choose_renderer(options_.device, options_.traversal, console_);
    {
      std::lock_guard const lock(mutex_);
      news_.device = renderer->device().name;
    }
    wake_();
    look_at_file();
    load(*renderer);
    while (!stop.stop_requested()) {
      look_at_file();
      if (file_has_changed_) load(*renderer);
      if (trace_next(*renderer, stop)) continue;
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, time_between_looks, [&] { return is_new_view_ || stop.stop_requested(); });
    }
  } catch (...) {
    std::lock_guard const lock(mutex_);
    failure_ = std::current_exception();
  }
  wake_();
}

void Worker::look_at_file() {
  auto const now = std::chrono::steady_clock::now();
  if (!is_watching_ || now - looked_at_ < time_between_looks) return;
  looked_at_ = now;
  std::error_code error;
  auto const time = std::filesystem::last_write_time(source_.name(), error);
  auto const size = error ? 0 : std::filesystem::file_size(source_.name(), error);
  if (error || (time == file_time_ && size == file_size_)) return;  // an editor may be about to rename it
  file_time_ = time;
  file_size_ = size;
  file_has_changed_ = true;
}

void Worker::load(Renderer& renderer) {
  file_has_changed_ = false;
  try {
    app::Stopwatch const stopwatch;
    app::LoadedScene const loaded = source_.load(options_.load);
    SceneView scene;
    scene.request = app::first_view(loaded, source_, options_);
    scene.cameras.assign(loaded.scene().cameras.begin(), loaded.scene().cameras.end());
    scene.center = center_of_interest(loaded.scene(), options_.root, scene.request.camera);
    prepared_ = renderer.prepare(loaded.scene(), options_.root, prepared_);
    scene_statistics_ = renderer.set_scene(prepared_);
    scene.bounds_min = prepared_->bounds_min;
    scene.bounds_max = prepared_->bounds_max;
    console_.show(loaded.diagnostics());
    console_.detail(fmt::format("{}: ready after {:.1f} ms", source_.name(), stopwatch.milliseconds()));
    std::lock_guard const lock(mutex_);
    if (!view_) view_ = scene.request;  // what the window will ask for, once it is open
    news_.scene = std::move(scene);
    news_.problem = "";
    seconds_per_pixel_.reset();
    restart_refinement();
  } catch (Error const& error) {
    if (!prepared_) throw;  // there is no picture to keep
    std::lock_guard const lock(mutex_);
    news_.problem = error.what();
  }
  wake_();
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
  if (pass.sampling.count == 1) sums_ = {};
  RenderResult const result = renderer.refine(request, sums_, frame.image, [&](RenderProgress const&) {
    if (stop.stop_requested()) return false;
    // The coarsest picture is finished whatever comes: else nothing would be seen while the camera moves.
    if (pass.is_first) return true;
    look_at_file();
    std::lock_guard const lock(mutex_);
    return !is_new_view_ && !file_has_changed_;
  });
  if (!result.complete) return true;
  frame.statistics = result.statistics;
  frame.pixels = display_pixels(frame.image);
  {
    std::lock_guard const lock(mutex_);
    if (pass.sampling.count == 1) {
      double const pixels = double(request.resolution.width) * double(request.resolution.height);
      double const seconds = 1e-3 * result.statistics.trace_ms / pixels;
      seconds_per_pixel_ = seconds_per_pixel_ ? 0.5 * (*seconds_per_pixel_ + seconds) : seconds;
    }
    news_.frame = std::move(frame);
  }
  wake_();
  return true;
}

}  // namespace lichtraum::view
