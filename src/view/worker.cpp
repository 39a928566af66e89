#include "view/worker.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/renderer_choice.hpp"
#include "app/stopwatch.hpp"
#include "view/display_pixels.hpp"
#include "view/freed_memory.hpp"
#include "view/problem_text.hpp"

namespace lichtraum::view {
namespace {

constexpr auto time_between_looks = std::chrono::milliseconds(50);

/// A view that is being moved gets the finest picture that is traced in this time: with putting it on the screen, 30
/// of them a second.
constexpr double moving_pass_seconds = 0.028;

app::LoadOptions observed_by(FileWatch& files) {
  app::LoadOptions options;
  options.on_read = [&files](std::filesystem::path const& file) { files.add(file); };
  options.models = make_model_cache();
  options.environments = std::make_shared<app::EnvironmentMaps>();
  options.is_posed_later = true;
  return options;
}

/// Without what names things in one file, which others do not have.
Job without_names(Job job) {
  job.camera.clear();
  job.root.clear();
  job.reading.model.scene.clear();
  job.reading.model.variant.clear();
  job.reading.model.animation.clear();
  return job;
}

}  // namespace

Worker::Worker(app::SceneSource const& source, app::RenderOptions const& options, bool is_watching,
               app::Console const& console, std::function<void()> wake)
    : options_(options),
      is_watching_(is_watching),
      console_(console),
      wake_(std::move(wake)),
      first_file_(source.name()),
      reading_{source, source.job(options.job)},
      load_options_(observed_by(files_)),
      thread_([this](std::stop_token const& stop) { work(stop); }) {}

Worker::~Worker() {
  thread_.request_stop();
  changed_.notify_all();
}

void Worker::open(std::filesystem::path const& file) {
  std::lock_guard const lock(mutex_);
  new_file_ = file;
  has_question_ = true;
  changed_.notify_all();
}

unsigned Worker::show(RenderRequest const& view) {
  std::lock_guard const lock(mutex_);
  view_ = view;
  expect_marking();
  return begin_view();
}

unsigned Worker::overlay(Overlays const& overlays) {
  std::lock_guard const lock(mutex_);
  overlays_ = overlays;
  return begin_view();
}

void Worker::develop(unsigned number, Development const& development) {
  std::lock_guard const lock(mutex_);
  new_development_ = {number, development};
  has_question_ = true;
  changed_.notify_all();
}

unsigned Worker::begin_view() {
  is_new_view_ = true;
  restart_refinement();
  changed_.notify_all();
  return ++view_number_;
}

void Worker::restart_refinement() {
  constexpr int side_when_unknown = 8;
  int const first_side = view_ && seconds_per_pixel_
                             ? Refinement::first_side_for(view_->resolution, *seconds_per_pixel_, moving_pass_seconds)
                             : side_when_unknown;
  bool const is_picture = !view_ || view_->planes.has(FilmPlane::radiance);
  refinement_.restart(first_side,
                      is_picture ? options_.job.sampling.value_or(Refinement::finest_by_default) : Sampling());
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
    load_options_.set_drawing(reading_.job, renderer->device().kind);
    load(*renderer, reading_);
    while (!stop.stop_requested()) {
      look_at_files();
      if (auto const asked = asked_reading()) {
        load(*renderer, *asked);
      } else if (files_have_changed_) {
        load(*renderer, reading_);
      }
      apply_pose(*renderer);
      apply_edits(*renderer);
      develop_again(*renderer);
      look_at_pixel(*renderer);
      if (is_fine_) trace_marking(*renderer, stop);
      if (trace_next(*renderer, stop)) continue;
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, time_between_looks,
                        [&] { return is_new_view_ || has_question_ || stop.stop_requested(); });
    }
  } catch (...) {
    std::lock_guard const lock(mutex_);
    failure_ = std::current_exception();
  }
  wake_();
}

std::optional<Worker::Reading> Worker::asked_reading() {
  auto const animation = take(new_animation_);
  std::lock_guard const lock(mutex_);
  if (new_file_) {
    app::SceneSource const source(*std::exchange(new_file_, std::nullopt));
    return Reading{source, source.job(source.name() == first_file_ ? options_.job : without_names(options_.job))};
  }
  if (!animation) return std::nullopt;
  Reading reading = reading_;
  reading.job.reading.model.animation = std::to_string(*animation);
  return reading;
}

void Worker::look_at_files() {
  auto const now = std::chrono::steady_clock::now();
  if (!is_watching_ || now - files_looked_at_ < time_between_looks) return;
  files_looked_at_ = now;
  files_have_changed_ = files_.has_changed();
}

void Worker::load(Renderer& renderer, Reading reading) {
  bool const is_first = !std::exchange(has_tried_, true);
  files_have_changed_ = false;
  FileWatch shown_files = std::exchange(files_, {});
  try {
    app::Stopwatch const stopwatch;
    auto const loaded_scene =
        std::make_shared<app::LoadedScene>(reading.source.load(reading.job.reading, load_options_));
    loaded_scene->rewind();  // what is seen is its first picture
    app::LoadedScene const& loaded = *loaded_scene;
    Job job = reading.job;
    job.integrator = chosen_integrator(job, loaded.scene(), load_options_.device).integrator;
    SceneView scene;
    scene.file = reading.source.name();
    scene.loaded = loaded_scene;
    scene.models = load_options_.models;
    scene.time_seconds = job.reading.model.time_seconds;
    scene.objects = std::make_shared<DrawnObjects const>(loaded.scene(), job.root);
    scene.values = SceneValues(loaded.scene(), *scene.objects);
    scene.number = scene_number_ + 1;
    scene.request = view_of(job, loaded.scene());
    scene.development = development_of(job, loaded.scene());
    scene.has_own_cameras = loaded.scene().has_own_cameras;
    scene.cameras.assign(loaded.scene().cameras.begin(), loaded.scene().cameras.end());
    scene.bounds = bounds_in_view(job, loaded.scene(), scene.request.camera);
    scene.up = job.view.up_in(loaded.scene());
    auto prepared = renderer.prepare(loaded.scene(), job.root, prepared_);
    scene_statistics_ = renderer.set_scene(prepared);
    // From here on nothing fails: till then, all that is known is of the scene that is shown.
    prepared_ = std::move(prepared);
    scene_number_ = scene.number;
    development_ = scene.development;
    denoising_ = decided(job.denoising, scene.request.integrator);
    bounds_ = scene.bounds;
    loaded_ = loaded_scene;
    loaded_job_ = std::move(job);
    reading_ = std::move(reading);
    has_edits_ = false;
    console_.show(loaded.diagnostics());
    console_.detail(fmt::format("{}: ready after {:.1f} ms", scene.file, stopwatch.milliseconds()));
    std::lock_guard const lock(mutex_);
    if (std::exchange(shown_file_, scene.file) != scene.file) view_.reset();  // its camera is another scene's
    if (scene.number == 1) view_ = scene.request;  // what the window will ask for, once it is open
    news_.scene = std::move(scene);
    marked_ = {};
    expect_marking();
    news_.problem = "";
    seconds_per_pixel_.reset();
    restart_refinement();
  } catch (std::exception const& error) {  // a file that is too large, or vanishes, may bring other ones than ours
    auto const* const known = dynamic_cast<Error const*>(&error);
    if (is_first && !(is_watching_ && known && known->kind() == ErrorKind::scene)) throw;
    tell_of(error);
    if (!loaded_) {
      reading_ = std::move(reading);
    } else if (reading.source.name() != reading_.source.name()) {
      files_ = std::move(shown_files);
    }
  }
  wake_();
}

void Worker::tell_of(std::exception const& problem) {
  std::lock_guard const lock(mutex_);
  news_.problem = problem_text(problem);
}

void Worker::develop_again(Renderer& renderer) {
  auto const development = take(new_development_);
  if (!development) return;
  development_ = *development;
  if (shown_.is_empty() || (shown_plane_ != FilmPlane::radiance && shown_plane_ != FilmPlane::albedo)) return;
  Frame frame = frame_;
  frame.image = developed(renderer);
  send(std::move(frame));
}

Image Worker::developed(Renderer& renderer) const {
  if (shown_plane_ != FilmPlane::radiance) return show_plane(shown_, shown_plane_, development_.transfer);
  return renderer.develop(shown_, development_);
}

void Worker::send(Frame frame) {
  frame.pixels = display_pixels(frame.image);
  frame.overlays.draw_on(frame.pixels);
  {
    std::lock_guard const lock(mutex_);
    news_.frame = std::move(frame);
  }
  wake_();
}

bool Worker::trace_next(Renderer& renderer, std::stop_token const& stop) {
  RenderRequest request;
  Resolution size;
  Refinement::Pass pass;
  Refinement before;
  Overlays overlays;
  FilmPlane shown_plane = FilmPlane::radiance;
  unsigned view_number = 0;
  {
    std::lock_guard const lock(mutex_);
    if (!view_) return false;
    before = refinement_;
    auto const next = refinement_.next();
    if (!next) return false;
    pass = *next;
    size = view_->resolution;
    request = Refinement::request(*view_, pass);
    shown_plane = request.planes.list().front();
    overlays = overlays_;
    for (FilmPlane const plane : overlays.planes().list()) request.planes.add(plane);
    if (denoising_ != Denoising::off) request.planes = with_guides(request.planes);
    is_new_view_ = false;
    view_number = view_number_;
  }
  bool const grows = Refinement::grows(pass.sampling);
  if (!(grows && is_growing_)) film_ = {};
  is_growing_ = grows;
  RenderResult const result = renderer.render(request, film_, [&](RenderProgress const&) {
    if (stop.stop_requested()) return false;
    // The coarsest picture is finished whatever comes: else nothing would be seen while the camera moves.
    if (pass.is_first) return true;
    look_at_files();
    std::lock_guard const lock(mutex_);
    return !is_new_view_ && !has_question_ && !files_have_changed_;
  });
  if (!result.complete) {
    film_ = {};
    std::lock_guard const lock(mutex_);
    if (!is_new_view_) refinement_ = before;  // it is traced again when the question is answered
    return true;
  }
  is_fine_ = pass.pixel_side == 1;
  frame_ = {};
  frame_.pass = pass;
  frame_.view_number = view_number;
  frame_.scene = scene_statistics_;
  frame_.statistics = result.statistics;
  frame_.overlays = OverlayLayer(overlays, film_, request.camera, bounds_);
  shown_plane_ = shown_plane;
  Frame frame = frame_;
  app::Stopwatch const stopwatch;
  if (denoising_ == Denoising::off || shown_plane != FilmPlane::radiance) {
    shown_ = film_;
  } else {
    Denoiser denoiser([&renderer](NoisyPicture const& picture) { return renderer.filter_noise(picture); });
    shown_ = denoiser.denoised(film_, Denoising::builtin);
  }
  frame.image = developed(renderer);
  double const milliseconds = result.statistics.trace_ms + stopwatch.milliseconds();
  if (pass.sampling.count == 1) {
    double const pixels = double(request.resolution.width) * double(request.resolution.height);
    double const seconds = 1e-3 * milliseconds / pixels;
    std::lock_guard const lock(mutex_);
    seconds_per_pixel_ = seconds_per_pixel_ ? 0.5 * (*seconds_per_pixel_ + seconds) : seconds;
  }
  send(std::move(frame));
  if (!pass.is_first) tidy_memory(size);
  if (pass.pixel_side == 1) trace_marking(renderer, stop);
  return true;
}

void Worker::tidy_memory(Resolution const& size) {
  if (std::exchange(tidied_size_, size) == size) return;
  shown_ = Film(shown_);  // in place of one that has room for the largest so far
  give_back_freed_memory();
}

}  // namespace lichtraum::view
