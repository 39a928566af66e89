#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "app/arguments.hpp"
#include "app/device_class.hpp"
#include "app/device_text.hpp"
#include "app/interruption.hpp"
#include "app/job_commands.hpp"
#include "app/planned_pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/renderer_choice.hpp"
#include "app/stopwatch.hpp"
#include "farm/unit_file.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* job_work_description =
    "Draws units of the plan in the folder DIR: those that are not there yet. Any\n"
    "number of machines may do so at once, may be stopped at any time, and begun\n"
    "again: a unit is there whole or not at all. Ends with status 75 where the same\n"
    "command may succeed later, with 65 where it never will.";

constexpr char const* job_work_examples =
    "  lichtraum job work shared\n"
    "  lichtraum job work shared --units 0..99\n";

struct JobWorkOptions {
  std::string folder;
  std::optional<FrameRange> units;
  std::string device;
  bool allow_mixed = false;
};

/// Numbers of units: first, first + 1, ... end - 1.
struct UnitRange {
  std::int64_t first = 0;
  std::int64_t end = 0;
};

class UnitWorker {
 public:
  UnitWorker(farm::PlanFolder const& folder, farm::PlannedFiles& files, Renderer& renderer, farm::DeviceClass device,
             bool allow_mixed, std::int64_t wanted, Console const& console)
      : folder_(folder),
        files_(files),
        plan_(folder.plan()),
        renderer_(renderer),
        device_(std::move(device)),
        allowed_class_(allow_mixed ? "" : plan_.device.hash),
        is_whole_(std::size_t(plan_.unit_count())),
        wanted_(wanted),
        bar_(console),
        console_(console) {}

  void draw(UnitRange const& range) {
    std::vector<std::string> inputs;
    RenderOptions options = options_of(plan_, inputs);
    OutputNames names(options.output);
    combine(options, inputs, names);
    int first_picture = 0;
    for (farm::PlannedScene const& scene : plan_.scenes) {
      if (has_work(range, first_picture, scene.picture_count)) draw_scene(scene, first_picture, options, names, range);
      first_picture += scene.picture_count;
    }
  }

  std::int64_t drawn() const { return drawn_; }

 private:
  UnitRange of_pictures(UnitRange const& range, int picture, int count) const {
    std::int64_t const each = plan_.units_of_picture();
    return {std::max(range.first, picture * each), std::min(range.end, (picture + count) * each)};
  }

  /// Whether the unit's file is there. One that was is not opened again: shared folders are slow.
  bool is_whole(std::int64_t unit) {
    auto known = is_whole_[std::size_t(unit)];
    if (!known) known = farm::looks_whole(folder_, unit, allowed_class_);
    return known;
  }

  /// Whether a unit of these pictures is missing.
  bool has_work(UnitRange const& range, int picture, int count) {
    UnitRange const part = of_pictures(range, picture, count);
    for (std::int64_t unit = part.first; unit < part.end; ++unit) {
      if (!is_whole(unit)) return true;
    }
    return false;
  }

  void draw_scene(farm::PlannedScene const& scene, int first_picture, RenderOptions const& options, OutputNames& names,
                  UnitRange const& range) {
    SceneSource const source(scene.file);
    LoadedScene script = source.load(options.job.reading, options.load);
    files_.check();  // as it was read now
    auto const pictures = plan_pictures(script, source, options, names);
    if (int(pictures.size()) != scene.picture_count) {
      throw Error(ErrorKind::scene, fmt::format("{}: it has {} pictures, and {} in the plan: make another plan",
                                                scene.file, pictures.size(), scene.picture_count));
    }
    script.play([&](Scene const& shown, std::size_t scene_number) {
      bool is_set = false;
      std::optional<Vec3> turn_center;
      for (std::size_t i = 0; i < pictures.size(); ++i) {
        int const picture = first_picture + int(i);
        if (pictures[i].scene_number != scene_number || !has_work(range, picture, 1)) continue;
        if (!std::exchange(is_set, true)) {
          previous_ = renderer_.prepare(shown, options.job.root, previous_);
          renderer_.set_scene(previous_);
        }
        draw_picture(request_for(pictures[i], shown, turn_center), of_pictures(range, picture, 1));
      }
      int const later = int(std::count_if(pictures.begin(), pictures.end(), [&](PicturePlan const& picture) {
        return picture.scene_number > scene_number;
      }));
      UnitRange const rest = of_pictures(range, first_picture + int(pictures.size()) - later, later);
      return rest.first < rest.end;
    });
  }

  void draw_picture(RenderRequest request, UnitRange const& range) {
    files_.check();  // a later picture may need files that were not read before
    for (std::int64_t number = range.first; number < range.end; ++number) {
      if (is_whole(number)) continue;
      draw_unit(request, number);
    }
  }

  void draw_unit(RenderRequest& request, std::int64_t number) {
    if (!graceful_) graceful_.emplace();
    farm::Unit const unit = plan_.unit(number);
    request.region = unit.region;
    request.samples = unit.samples;
    request.planes = plan_.planes;
    farm::DrawnUnit drawn{device_.hash, {}, {}};
    auto const result = renderer_.render(request, drawn.film, [&](RenderProgress const& now) {
      double const done = (double(drawn_) + now.fraction) / double(std::max<std::int64_t>(1, wanted_));
      bar_.update(fmt::format("unit {}", number),
                  {std::min(1.0, done), rays_ + now.rays, run_.seconds(), now.is_compiling});
      return !interrupted();
    });
    if (!result.complete) throw Error(ErrorKind::interrupted, fmt::format("interrupted in unit {}", number));
    drawn.rays = result.statistics.rays;
    rays_ += drawn.rays.total();
    farm::write_unit(folder_, number, drawn);
    ++drawn_;
    if (console_.is_verbose()) bar_.clear();
    console_.detail(fmt::format("unit {} is done", number));
    if (interrupted()) throw Error(ErrorKind::interrupted, fmt::format("interrupted after unit {}", number));
  }

  farm::PlanFolder const& folder_;
  farm::PlannedFiles& files_;
  farm::Plan const& plan_;
  Renderer& renderer_;
  farm::DeviceClass device_;
  std::string allowed_class_;
  std::vector<bool> is_whole_;  // by number: those that were found so
  std::int64_t wanted_;
  std::int64_t drawn_ = 0;
  std::uint64_t rays_ = 0;
  std::shared_ptr<PreparedScene const> previous_;
  std::optional<GracefulScope> graceful_;  // once something is drawn, Ctrl-C is asked for
  Stopwatch run_;
  ProgressBar bar_;
  Console const& console_;
};

bool parse_job_work(Arguments const& arguments, JobWorkOptions& options, Console& console) {
  auto const parser = make_parser("job work", job_work_description, job_work_examples);
  add_inputs(*parser, options.folder, "DIR");
  std::string const group = "Units";
  add_value(*parser, "--units", options.units, parse_units, "A..B",
            "Draw these, both included (default: all that are\nmissing)", group);
  add_value(*parser, "--device", options.device, parse_name, "NAME",
            "Index, part of a name, cpu, gpu or reference\n(default: of the plan's kind)", group);
  parser
      ->add_flag("--allow-mixed", options.allow_mixed,
                 "Draw, and take for done, what devices of other\nclasses drew: edges of the units may show")
      ->group(group);
  add_verbosity(*parser, console);
  return parse(*parser, arguments);
}

UnitRange wanted_units(farm::Plan const& plan, std::optional<FrameRange> const& units) {
  std::int64_t const count = plan.unit_count();
  if (!units) return {0, count};
  if (units->last >= count) {
    throw Error(ErrorKind::usage, fmt::format("--units: the plan has units 0..{}, not {}", count - 1, units->last));
  }
  return {units->first, std::int64_t(units->last) + 1};
}

/// One of the plan's kind, where there is one.
std::string usual_device(farm::Plan const& plan) {
  if (plan.device.kind == DeviceKind::reference) return "reference";
  if (plan.device.kind == DeviceKind::accelerator) return "";  // which no selector names
  DeviceList const list = find_devices();
  bool const is_there =
      std::ranges::any_of(list.devices, [&](auto const& one) { return one.kind == plan.device.kind; });
  return is_there ? std::string(kind_name(plan.device.kind)) : "";
}

/// Throws Error{scene} unless `device` is of the plan's class.
void check_class(farm::Plan const& plan, farm::DeviceClass const& device) {
  if (plan.device.hash == device.hash) return;
  auto const text = [](farm::DeviceClass const& one, std::string const& version) {
    return fmt::format("lichtraum {} on '{}' ({}), class {}", version, one.name, kind_name(one.kind), one.hash);
  };
  throw Error(ErrorKind::scene,
              fmt::format("this device draws other bytes than the plan's: {} here, {} there; --device chooses another, "
                          "and --allow-mixed draws nevertheless",
                          text(device, LICHTRAUM_VERSION), text(plan.device, plan.version)));
}

}  // namespace

int job_work_command(Arguments const& arguments, Console& console) {
  JobWorkOptions options;
  if (!parse_job_work(arguments, options, console)) return 0;
  farm::PlanFolder const folder(options.folder);
  farm::Plan const& plan = folder.plan();
  UnitRange const wanted = wanted_units(plan, options.units);
  farm::PlannedFiles files(plan);
  files.check();
  std::optional<Traversal> const traversal = plan.traversal.empty() ? std::nullopt : parse_traversal(plan.traversal);
  std::string const selector = options.device.empty() ? usual_device(plan) : options.device;
  auto const renderer = choose_renderer(selector, traversal, console);
  auto const device = device_class_of(*renderer, plan.traversal);
  if (!options.allow_mixed) check_class(plan, device);

  // Each begins somewhere else, so that workers that know nothing of each other seldom draw the same.
  std::int64_t start = wanted.first;
  if (!options.units) {
    std::random_device chance;
    start = std::uniform_int_distribution<std::int64_t>(0, wanted.end - 1)(chance);
  }
  UnitWorker worker(folder, files, *renderer, device, options.allow_mixed, wanted.end - wanted.first, console);
  worker.draw({start, wanted.end});
  worker.draw({wanted.first, start});
  std::int64_t const others = wanted.end - wanted.first - worker.drawn();
  console.info(fmt::format("{}: {} drawn{}", options.folder, unit_text(worker.drawn()),
                           others > 0 ? fmt::format(", {} there already", others) : ""));
  return 0;
}

}  // namespace lichtraum::app
