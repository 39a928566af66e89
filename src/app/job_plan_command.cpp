#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/device_class.hpp"
#include "app/input_list.hpp"
#include "app/job_commands.hpp"
#include "app/planned_pictures.hpp"
#include "app/renderer_choice.hpp"
#include "app/video.hpp"
#include "core/quoted_for_shell.hpp"
#include "lichtraum/image_io.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* job_plan_description =
    "Cuts pictures into units that machines draw, each by itself, and writes what\n"
    "they need to know into the folder DIR, which all of them see. Scenes and their\n"
    "files stay where they are: every machine reads them by the same path, and they\n"
    "must not change.";

constexpr char const* job_plan_examples =
    "  lichtraum job plan hello.sdf --size 8000x6000 -o shared\n"
    "  lichtraum job plan model.glb --samples 1024 --samples-per-unit 256 -o shared\n"
    "  lichtraum job plan model.glb --turntable 90 -o shared\n";

struct JobPlanOptions {
  RenderOptions render;
  std::string folder;
  std::string traversal;
};

int parse_unit_samples(std::string_view text) {
  Sampling const samples = parse_samples(text);
  if (samples.pattern == Sampling::Pattern::seeded && samples.count % Film::block_size == 0) return samples.count;
  throw std::invalid_argument(fmt::format("expected a multiple of {}", Film::block_size));
}

bool parse_job_plan(Arguments const& arguments, JobPlanOptions& options, Console& console) {
  RenderOptions& render = options.render;
  auto const parser = make_parser("job plan", job_plan_description, job_plan_examples);
  UnitSize& unit = render.unit.emplace(UnitSize{{1024, 1024}});
  add_inputs(*parser, render.scenes, "SCENE...");
  std::string const group = "Units";
  add_value(*parser, "-o,--output", options.folder, parse_name, "DIR", "Folder of the plan and of its units", group);
  add_value(*parser, "--tile", unit.tile, parse_size, "WxH", "Pixels of a unit (default: 1024x1024)", group);
  add_value(*parser, "--samples-per-unit", unit.samples, parse_unit_samples, "N",
            "Samples of a unit, a multiple of 16 (default: all)", group);
  add_picture_options(*parser, render);
  add_encoding_options(*parser, render, "Picture");
  add_sequence_options(*parser, render);
  add_environment_options(*parser, render.job.reading.environment);
  add_quality_options(*parser, render);
  add_denoise_option(*parser, render.job.denoising);
  add_language_options(*parser, render.job.reading);
  add_model_options(*parser, render.job.reading.model);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return false;
  if (options.folder.empty()) {
    throw Error(ErrorKind::usage, "the plan's folder is missing: -o DIR names one that all machines see");
  }
  if (find_image_format(options.folder) || find_film_format(options.folder)) {
    throw Error(ErrorKind::usage, fmt::format("-o {}: a plan is a folder, not a picture; the picture's name is for the "
                                              "last step, lichtraum job merge DIR -o {}",
                                              options.folder, quoted_for_shell(options.folder)));
  }
  if (auto const* const traversal = parser->get_option("--traversal"); traversal->count() > 0) {
    options.traversal = traversal->results().back();
    if (!render.traversal) options.traversal.clear();
  }
  check_inputs(render);
  return true;
}

}  // namespace

int job_plan_command(Arguments const& arguments, Console& console) {
  JobPlanOptions options;
  if (!parse_job_plan(arguments, options, console)) return 0;
  std::vector<std::string> const inputs = expand_patterns(options.render.scenes);
  auto const renderer = choose_renderer(options.render.device, options.render.traversal, console);
  farm::Plan plan =
      make_plan(options.render, inputs, device_class_of(*renderer, options.traversal), options.traversal, console);
  farm::PlanFolder const folder(options.folder, std::move(plan));
  std::int64_t const units = folder.plan().unit_count();
  console.info(fmt::format("{}: {}; lichtraum job work {} draws {}", options.folder, unit_text(units),
                           quoted_for_shell(options.folder), units == 1 ? "it" : "them"));
  return 0;
}

}  // namespace lichtraum::app
