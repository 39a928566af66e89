#include "app/merging_renderer.hpp"

#include <fmt/format.h>

#include <vector>

#include "app/job_commands.hpp"
#include "app/stopwatch.hpp"

namespace lichtraum::app {
namespace {

/// Units that a picture lacks.
class LackingUnits {
 public:
  void add(std::string what) {
    if (++count_ <= most_named) named_.push_back(std::move(what));
  }
  bool is_empty() const { return count_ == 0; }
  std::string text() const {
    std::string const more =
        count_ > most_named ? fmt::format("; and {} more", count_ - std::int64_t(named_.size())) : "";
    return fmt::format("{}{}", fmt::join(named_, "; "), more);
  }

 private:
  static constexpr std::int64_t most_named = 5;
  std::vector<std::string> named_;
  std::int64_t count_ = 0;
};

}  // namespace

MergingRenderer::MergingRenderer(farm::PlanFolder const& folder, std::string allowed_class,
                                 std::unique_ptr<Renderer> other, Console const& console)
    : folder_(folder),
      allowed_class_(std::move(allowed_class)),
      other_(std::move(other)),
      console_(console),
      device_(other_->device()) {
  device_.kind = folder.plan().device.kind;
  device_.name = folder.plan().device.name;
}

RenderResult MergingRenderer::render(RenderRequest const& request, Film& film, ProgressFunction const& progress) {
  farm::Plan const& plan = folder_.plan();
  std::int64_t const each = plan.units_of_picture(), first = next_picture_++ * each;
  Stopwatch const stopwatch;
  RenderResult result;
  LackingUnits lacking;
  film = Film::of_samples(plan.region, request.planes, {0, plan.sample_count});
  Film part;
  for (std::int64_t i = 0; i < each; ++i) {
    std::int64_t const number = first + i;
    farm::UnitReading reading = farm::read_unit(folder_, number, allowed_class_);
    if (reading.is_spoilt) {
      auto const aside = farm::set_aside(folder_, number);
      lacking.add(fmt::format("unit {} {}, and is '{}' now", number, reading.problem, aside.string()));
    } else if (!reading.unit) {
      lacking.add(fmt::format("unit {} {}", number, reading.problem));
    }
    if (lacking.is_empty()) {
      result.statistics.rays += reading.unit->rays;
      reading.unit->film.keep(request.planes);
      if (plan.unit(number).samples.first == 0) {
        part = std::move(reading.unit->film);
      } else {
        part.merge(reading.unit->film);
      }
      if (part.samples().end == plan.sample_count) film.place(std::move(part));
    }
    RenderProgress const now{double(i + 1) / double(each), result.statistics.rays.total(), stopwatch.seconds()};
    if (progress && !progress(now)) throw Error(ErrorKind::interrupted, "interrupted: nothing was written");
  }
  if (lacking.is_empty()) return result;
  throw Error(ErrorKind::try_again, fmt::format("{}: {}: 'lichtraum job work {}' draws them", folder_.path().string(),
                                                lacking.text(), folder_.path().string()));
}

}  // namespace lichtraum::app
