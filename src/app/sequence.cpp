#include "app/sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "app/diagnostics_of.hpp"
#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/picture_bands.hpp"
#include "app/picture_findings.hpp"
#include "app/picture_writer.hpp"
#include "app/plan_findings.hpp"
#include "app/progress_bar.hpp"
#include "app/scene_loader.hpp"
#include "app/stopwatch.hpp"
#include "app/traced_picture.hpp"
#include "core/start_threads.hpp"

namespace lichtraum::app {
namespace {

class Sequence {
 public:
  Sequence(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names, Renderer& renderer,
           Console const& console, RunReport& report)
      : inputs_(inputs),
        options_(options),
        renderer_(renderer),
        console_(console),
        report_(report),
        is_film_(names.is_film()),
        bar_(console),
        writer_(options.frame_rate()),
        denoiser_([&renderer](NoisyPicture const& picture) { return renderer.filter_noise(picture); }),
        plan_findings_(options, inputs.size()),
        picture_findings_(renderer, options),
        loader_(inputs, options, names, renderer, denoiser_) {}

  int run() {
    for (std::size_t input = 0; input < inputs_.size(); ++input) {
      report_.scenes.emplace_back().file = inputs_[input];
      try {
        draw_input(input);
      } catch (Error const& error) {
        fail(error);
      }
      if (code_ == 0) continue;
      if (ends_with_failure() || code_ == exit_code(ErrorKind::interrupted)) break;
    }
    bar_.clear();
    if (failed_ > 0 && inputs_.size() > 1 && !ends_with_failure() && code_ != exit_code(ErrorKind::interrupted)) {
      console_.error(fmt::format("{} of {} scenes could not be drawn", failed_, inputs_.size()));
    }
    if (is_film_) end_film();
    if (skipped_ > 0) {
      console_.info(fmt::format("{} picture{} already there and skipped", skipped_, skipped_ == 1 ? " was" : "s were"));
    }
    return code_;
  }

 private:
  /// A film is of all its pictures, and a merge takes them out of a plan one after the other.
  bool ends_with_failure() const { return is_film_ || options_.is_merging; }

  void fail(Error const& error) {
    bar_.clear();
    console_.show(error);
    SceneReport& scene = report_.scenes.back();
    std::ranges::move(diagnostics_of(error), std::back_inserter(scene.diagnostics));
    scene.error = error.what();
    scene.exit_code = exit_code(error.kind());
    ++failed_;
    if (code_ == 0 || error.kind() == ErrorKind::interrupted) code_ = exit_code(error.kind());
  }

  LoaderMessage wait_for_loader() {
    for (;;) {
      if (auto message = loader_.next()) return std::move(*message);
      if (interrupted()) {
        finish_writing();
        throw Error(ErrorKind::interrupted, "interrupted");
      }
    }
  }

  /// Where a picture fails, the scene's later ones are left out; the loader sends them all the same.
  void draw_input(std::size_t input) {
    bool has_failed = false;
    for (;;) {
      LoaderMessage message = wait_for_loader();
      if (auto const* const closed = std::get_if<SceneClosed>(&message)) {
        planned_before_ += std::max<std::size_t>(1, scene_.plans.size());  // as OutputNames counts
        scene_ = {};
        if (has_failed) return;
        finish_writing();
        if (closed->failure) std::rethrow_exception(closed->failure);
        return;
      }
      if (has_failed) continue;
      try {
        if (auto* const opened = std::get_if<SceneOpened>(&message)) {
          open(std::move(*opened), input);
        } else {
          draw(std::get<PictureReady>(message));
        }
      } catch (Error const& error) {
        if (ends_with_failure() || error.kind() == ErrorKind::interrupted) throw;
        has_failed = true;
        fail(error);
        finish_earlier_writing();
      }
    }
  }

  void open(SceneOpened opened, std::size_t input) {
    scene_ = std::move(opened);
    inputs_left_ = inputs_.size() - input - 1;
    report_.scenes.back().load_ms = scene_.load_ms;
    bar_.clear();
    show(scene_.diagnostics);
    console_.detail(fmt::format("{}: loaded in {:.1f} ms", scene_.source->name(), scene_.load_ms));
    show(plan_findings_.next(scene_));
    picture_findings_.begin(scene_);
    if (is_film_) check_film_size();
  }

  void check_film_size() {
    for (PicturePlan const& plan : scene_.plans) {
      Resolution const size{plan.job.region->width, plan.job.region->height};
      if (!film_size_) film_size_ = size;
      if (size == *film_size_) continue;
      throw Error(options_.job.size ? ErrorKind::usage : ErrorKind::scene,
                  fmt::format("{}: the pictures of a film have one size, and this one has {}x{} where the first has "
                              "{}x{}: --size chooses one for all",
                              scene_.source->name(), size.width, size.height, film_size_->width, film_size_->height));
    }
  }

  /// How much of everything is drawn when `fraction` of the current picture is. What is not opened yet counts as what
  /// was opened on average.
  double fraction_of_all(double fraction) const {
    double const done = double(planned_before_) + double(current_);
    double const opened = double(inputs_.size() - inputs_left_);
    double const planned = double(planned_before_ + scene_.plans.size());
    return (done + fraction) / (planned / opened * double(inputs_.size()));
  }

  void draw(PictureReady const& ready) {
    current_ = ready.number;
    PictureReport picture;
    picture.plan = scene_.plans[ready.number];
    picture.load_ms = ready.load_ms;
    picture.scene = ready.scene->statistics;
    if (ready.is_done) {
      ++skipped_;
      picture.is_skipped = picture.is_complete = true;
      picture.written_to = picture.plan.output.shown;
      finish_writing();
      console_.detail(fmt::format("{}: already there", picture.written_to));
      report_.scenes.back().pictures.push_back(std::move(picture));
      return;
    }
    picture.scene = renderer_.set_scene(ready.scene);
    show(picture_findings_.of_scene(ready, picture.plan));

    if (!graceful_) graceful_.emplace();
    auto const bands = bands_of(picture.plan, !ready.denoiser.empty());
    if (bands.size() > 1) return draw_in_bands(ready, std::move(picture), bands);
    Film film;
    auto const limit = picture.plan.job.noise;
    auto const [result, noise] = trace_picture(renderer_, ready.request, limit, film, progress_of(picture.plan, 0, 1));
    picture.noise = noise;
    picture.samples = film.samples().count();
    if (result.complete) warn_of_noise(picture, noise_left(film, limit, noise));
    rays_ += result.statistics.rays.total();
    picture.is_complete = result.complete;
    picture.render = result.statistics;
    picture.plan.fingerprint = result.complete ? ready.fingerprint : "";
    Sight sight;
    sight.add(result.statistics.rays, film);
    if (result.complete && !ready.denoiser.empty()) film = denoised(film, ready, picture);
    finish_writing();
    warn_of_samples_left_out(picture);
    begin_writing(develop(std::move(film), picture.plan, ready.development, sight), picture);
    if (!result.complete) {
      std::string const written_to = finish_writing();
      throw Error(ErrorKind::interrupted, is_film_ ? "interrupted"
                                          : written_to.empty()
                                              ? "interrupted: nothing was written"
                                              : fmt::format("interrupted: what is done is in '{}'", written_to));
    }
    end_picture(ready, picture.plan, sight);
  }

  /// What bands must not be is cut short: their file begins before it is known that they are whole.
  void draw_in_bands(PictureReady const& ready, PictureReport picture, std::vector<Region> const& bands) {
    finish_writing();
    picture.plan.fingerprint = ready.fingerprint;
    BandWriter writer(picture.plan, ready.request.planes);
    RenderRequest request = ready.request;
    Sight sight;
    for (std::size_t i = 0; i < bands.size(); ++i) {
      request.region = bands[i];
      Film film;
      auto const result = renderer_.render(request, film, progress_of(picture.plan, i, bands.size()));
      if (!result.complete) {
        throw Error(ErrorKind::interrupted,
                    "interrupted: nothing was written ('lichtraum job' draws large pictures in parts that stay)");
      }
      rays_ += result.statistics.rays.total();
      picture.render += result.statistics;
      picture.samples = film.samples().count();
      sight.add(result.statistics.rays, film);
      Stopwatch const stopwatch;
      writer.add(develop(std::move(film), picture.plan, ready.development, sight));
      picture.write_ms += stopwatch.milliseconds();
    }
    writer.finish();
    remove_partial(picture.plan.output);
    picture.is_complete = true;
    picture.written_to = picture.plan.output.shown;
    warn_of_samples_left_out(picture);
    report(picture);
    end_picture(ready, picture.plan, sight);
  }

  /// Of part `part` of `parts` of the current picture.
  ProgressFunction progress_of(PicturePlan const& plan, std::size_t part, std::size_t parts) {
    return [this, &plan, part, parts](RenderProgress const& now) {
      double const fraction = (double(part) + now.fraction) / double(parts);
      bar_.update(title(plan), {fraction_of_all(fraction), rays_ + now.rays, run_.seconds(), now.is_compiling});
      return !interrupted();
    };
  }

  void end_picture(PictureReady const& ready, PicturePlan const& plan, Sight const& sight) {
    auto const found = picture_findings_.of_picture(ready, plan, sight);
    if (!found.empty()) finish_writing();
    show(found);
    if (interrupted()) {
      finish_writing();
      throw Error(ErrorKind::interrupted, "interrupted");
    }
  }

  void warn_of_samples_left_out(PictureReport const& picture) {
    auto const left_out = samples_left_out(picture.render);
    if (left_out.empty()) return;
    warn(DiagnosticCode::samples_left_out, fmt::format("{}: {}", picture.plan.output.shown, left_out));
  }

  /// Beside the line that shows progress, and in the report.
  void show(std::vector<Diagnostic> const& found) {
    if (found.empty()) return;
    bar_.clear();
    console_.show(found);
    auto& all = report_.scenes.back().diagnostics;
    all.insert(all.end(), found.begin(), found.end());
  }
  void warn(DiagnosticCode code, std::string message) {
    show({{Severity::warning, code, {}, 1, std::move(message), {}, {}}});
  }

  /// Of a film, once.
  void warn_of_noise(PictureReport const& picture, std::string const& left) {
    if (left.empty() || (is_film_ && std::exchange(has_warned_of_noise_, true))) return;
    warn(DiagnosticCode::noise_left,
         fmt::format("{}: {}: a larger --samples allows more", picture.plan.output.shown, left));
  }

  Film denoised(Film const& film, PictureReady const& ready, PictureReport& picture) {
    Denoising const denoising = picture.plan.job.denoising;
    Stopwatch const stopwatch;
    Film result = without_noise(denoiser_, film, denoising, ready.request);
    picture.denoise_ms = stopwatch.milliseconds();
    picture.denoiser = denoiser_.name(denoising);
    if (picture.denoiser != ready.denoiser) picture.plan.fingerprint.clear();  // it failed with this picture
    if (auto const note = denoiser_.take_note(); !note.empty()) {
      warn(DiagnosticCode::other_denoiser, note);
    }
    return result;
  }

  Drawn develop(Film film, PicturePlan const& plan, Development const& development, Sight& sight) {
    if (plan.output.format->encode_film) return film;
    bool const has_radiance = film.planes().has(FilmPlane::radiance);
    Image pixels = shown_picture(renderer_, std::move(film), development);
    if (has_radiance) sight.add(pixels, development);
    return pixels;
  }

  std::string title(PicturePlan const& plan) const {
    if (inputs_.size() == 1 && scene_.plans.size() == 1) return plan.output.shown;
    std::size_t const number = planned_before_ + current_ + 1;
    return inputs_left_ > 0
               ? fmt::format("{}, picture {}", plan.output.shown, number)
               : fmt::format("{}, picture {} of {}", plan.output.shown, number, planned_before_ + scene_.plans.size());
  }

  void begin_writing(Drawn drawn, PictureReport const& picture) {
    struct Writing {
      Drawn drawn;
      PictureReport picture;
    };
    // Shared, as std::async may take its function again after it found no thread for it.
    auto const work = [this, writing = std::make_shared<Writing>(Writing{std::move(drawn), picture})] {
      writer_.write(writing->drawn, writing->picture);
      return writing->picture;
    };
    writing_ = std::async(thread_if_any, work);
    if (writing_.wait_for(std::chrono::seconds(0)) == std::future_status::deferred) writing_.wait();
  }

  /// Waits for the picture that is being written, if one is, and reports it. Returns where it was written to.
  std::string finish_writing() {
    if (!writing_.valid()) return {};
    PictureReport const picture = writing_.get();
    report(picture);
    return picture.written_to;
  }

  /// After another failure of its scene.
  void finish_earlier_writing() {
    try {
      finish_writing();
    } catch (Error const& error) {
      console_.show(error);
    }
  }

  /// That was written.
  void report(PictureReport const& picture) {
    if (picture.is_complete && !is_film_) {
      bar_.clear();
      console_.info(summary(picture));
    }
    if (picture.is_complete && console_.is_verbose()) {
      bar_.clear();
      console_.detail(details(picture));
    }
    report_.scenes.back().pictures.push_back(picture);
  }

  void end_film() {
    try {
      bool const is_interrupted = code_ == exit_code(ErrorKind::interrupted);
      if (code_ != 0 && !is_interrupted) return;  // a film that lacks pictures would be taken for a whole one
      if (auto const film = writer_.finish_film(!is_interrupted)) {
        report_.film = film->path;
        console_.info(fmt::format("{}: {} picture{}, {}x{}, {:.2f} s at {:g} a second", film->path, film->frame_count,
                                  film->frame_count == 1 ? "" : "s", film->size.width, film->size.height,
                                  film->frame_count / options_.frame_rate(), options_.frame_rate()));
      }
    } catch (Error const& error) {
      fail(error);
    }
  }

  std::vector<std::string> const& inputs_;
  RenderOptions const& options_;
  Renderer& renderer_;
  Console const& console_;
  RunReport& report_;
  bool is_film_;
  Stopwatch run_;
  std::optional<GracefulScope> graceful_;  // once something is drawn, Ctrl-C is asked for
  ProgressBar bar_;
  PictureWriter writer_;
  Denoiser denoiser_;
  PlanFindings plan_findings_;
  PictureFindings picture_findings_;
  SceneLoader loader_;
  SceneOpened scene_;
  std::optional<Resolution> film_size_;
  bool has_warned_of_noise_ = false;
  int code_ = 0;
  std::size_t failed_ = 0;
  std::size_t skipped_ = 0;
  std::size_t planned_before_ = 0;  // pictures of the inputs before
  std::size_t current_ = 0;         // picture of this input
  std::size_t inputs_left_ = 0;
  std::uint64_t rays_ = 0;

  std::future<PictureReport> writing_;  // last: it uses what is above
};

}  // namespace

int draw_sequence(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
                  Renderer& renderer, Console const& console, RunReport& report) {
  return Sequence(inputs, options, names, renderer, console, report).run();
}

}  // namespace lichtraum::app
