#include "app/merging_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/job_commands.hpp"
#include "app/stopwatch.hpp"
#include "core/quoted_for_shell.hpp"

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
                                 std::unique_ptr<Renderer> other)
    : folder_(folder), allowed_class_(std::move(allowed_class)), other_(std::move(other)), device_(other_->device()) {
  device_.kind = folder.plan().device.kind;
  device_.name = folder.plan().device.name;
}

void MergingRenderer::check_units(ProgressFunction const& progress) {
  std::int64_t const count = folder_.plan().unit_count(), each = folder_.plan().units_of_picture();
  Stopwatch const stopwatch;
  RayCounts all;
  LackingUnits lacking;
  rays_.assign(std::size_t(count / each), RayCounts());
  for (std::int64_t number = 0; number < count; ++number) {
    farm::UnitCheck const unit = farm::check_unit(folder_, number, allowed_class_);
    if (unit.is_spoilt) {
      auto const aside = farm::set_aside(folder_, number);
      lacking.add(fmt::format("unit {} {}, and is '{}' now", number, unit.problem, aside.string()));
    } else if (!unit.problem.empty()) {
      lacking.add(fmt::format("unit {} {}", number, unit.problem));
    }
    rays_[std::size_t(number / each)] += unit.rays;
    all += unit.rays;
    progress({double(number + 1) / double(count), all.total(), stopwatch.seconds()});
  }
  if (lacking.is_empty()) return;
  throw Error(ErrorKind::try_again,
              fmt::format("{}: {}: lichtraum job work {} draws what is missing", folder_.path().string(),
                          lacking.text(), quoted_for_shell(folder_.path().string())));
}

RenderResult MergingRenderer::render(RenderRequest const& request, Film& film, ProgressFunction const& progress) {
  farm::Plan const& plan = folder_.plan();
  Region const& wanted = request.region;
  bool const is_next = wanted.y == plan.region.y;
  picture_ += is_next;
  std::int64_t const each = plan.units_of_picture(), first = picture_ * each;
  RenderResult result;
  if (is_next) result.statistics.rays = rays_.at(std::size_t(picture_));
  film = Film::of_samples(wanted, request.planes, {0, plan.sample_count});
  Film part;
  for (std::int64_t number = first; number < first + each; ++number) {
    farm::Unit const unit = plan.unit(number);
    int const top = std::max(unit.region.y, wanted.y);
    int const bottom = std::min(unit.region.y + unit.region.height, wanted.y + wanted.height);
    if (top >= bottom) continue;
    Film rows = farm::read_rows(folder_, number, top - unit.region.y, bottom - top);
    rows.keep(request.planes);
    if (unit.samples.first == 0) {
      part = std::move(rows);
    } else {
      part.merge(rows);
    }
    if (part.samples().end == plan.sample_count) film.place(std::move(part));
    RenderProgress const now{double(number - first + 1) / double(each), 0, 0};
    if (progress && !progress(now)) throw Error(ErrorKind::interrupted, "interrupted: nothing was written");
  }
  return result;
}

}  // namespace lichtraum::app
