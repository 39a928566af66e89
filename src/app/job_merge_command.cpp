#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/files_read.hpp"
#include "app/job_commands.hpp"
#include "app/merging_renderer.hpp"
#include "app/picture_plan.hpp"
#include "app/planned_pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/sequence.hpp"
#include "app/video.hpp"
#include "core/quoted_for_shell.hpp"
#include "farm/progress.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* job_merge_description =
    "Puts the units in the folder DIR together to the pictures that were planned:\n"
    "the bytes that 'lichtraum render' would write. Noise is taken out here, of whole\n"
    "pictures. Every unit is checked. One that cannot be used is set aside, so that\n"
    "'lichtraum job work' draws it again; then, and where units are missing, nothing\n"
    "is written and the status is 75.";

constexpr char const* job_merge_examples =
    "  lichtraum job merge shared -o hello.png\n"
    "  lichtraum job merge shared -o frames/%04d.png\n"
    "  lichtraum job merge shared -o film.mp4 --fps 30\n";

struct JobMergeOptions {
  std::string folder;
  OutputOptions output;
  std::optional<double> frames_per_second;
  bool allow_mixed = false;
};

bool parse_job_merge(Arguments const& arguments, JobMergeOptions& options, Console& console) {
  auto const parser = make_parser("job merge", job_merge_description, job_merge_examples);
  add_inputs(*parser, options.folder, "DIR");
  std::string const group = "Output";
  add_value(*parser, "-o,--output", options.output.file, parse_name, "FILE",
            "Write to FILE: a name with .png, .ppm, .jpg,\n.exr or .pfm; %04d numbers pictures; .mp4,\n.webm or .gif "
            "is a film (default: as the scene\nsays)",
            group);
  auto const format = [](std::string const& text) { return &image_format_named(text); };
  add_value(*parser, "--format", options.output.format, format, "NAME",
            "png, ppm, jpg, exr or pfm, whatever the extension", group);
  auto const path = [](std::string const& text) { return std::filesystem::path(parse_name(text)); };
  add_value(*parser, "--output-dir", options.output.folder, path, "FOLDER",
            "Folder for pictures (default: the current one)", group);
  add_value(*parser, "--fps", options.frames_per_second, parse_frame_rate, "N",
            "Frames per second of a film (default: the\nplan's, else 25)", group);
  parser->add_flag("--allow-mixed", options.allow_mixed, "Take units that devices of other classes drew, too")
      ->group(group);
  add_verbosity(*parser, console);
  return parse(*parser, arguments);
}

/// Another version may develop pictures in another way.
void check_version(farm::Plan const& plan) {
  if (plan.version == LICHTRAUM_VERSION) return;
  throw Error(ErrorKind::scene,
              fmt::format("the plan was made by lichtraum {}, and this is {}: that version puts its pictures together, "
                          "or this one with --allow-mixed",
                          plan.version, LICHTRAUM_VERSION));
}

/// Before units are looked for: lichtraum.farm hears of it before it has any drawn.
void check_output(farm::Plan const& plan, JobMergeOptions const& merge) {
  OutputOptions const& options = merge.output;
  OutputNames names(options);
  if (merge.frames_per_second) {
    if (!names.is_film()) throw Error(ErrorKind::usage, "--fps is for films (-o film.mp4)");
    check_frame_rate(options.file, *merge.frames_per_second);
  }
  if (options.file.empty()) return;
  Output const first = names.next({});
  Job job = plan.job;
  job.region = plan.region;
  check_format(job, first);
  if (first.is_standard_output()) return;
  FilesRead files;
  for (farm::ReadFile const& file : plan.files) files.add(file.path);
  files.refuse_to_overwrite(first.path);
  check_writable(first.path);
}

/// Before scenes are read, which takes time.
void check_all_there(farm::PlanFolder const& folder) {
  farm::Progress const progress = farm::progress_of(folder);
  std::int64_t const missing = folder.plan().unit_count() - progress.done;
  if (missing == progress.cut_short) return;  // they are set aside when they are read
  auto const first = progress.missing(1).front();
  std::string const where =
      first.first == first.last ? fmt::format("{}", first.first) : fmt::format("{}..{}", first.first, first.last);
  throw Error(ErrorKind::try_again,
              fmt::format("{}: {} of {} missing, the first of them {}: lichtraum job work {} draws {}",
                          folder.path().string(), missing, unit_text(folder.plan().unit_count()), where,
                          quoted_for_shell(folder.path().string()), missing == 1 ? "it" : "them"));
}

}  // namespace

int job_merge_command(Arguments const& arguments, Console& console) {
  JobMergeOptions options;
  if (!parse_job_merge(arguments, options, console)) return 0;
  farm::PlanFolder const folder(options.folder);
  if (!options.allow_mixed) check_version(folder.plan());
  check_output(folder.plan(), options);
  farm::PlannedFiles(folder.plan()).check();  // what has changed no unit mends
  check_all_there(folder);

  std::vector<std::string> inputs;
  RenderOptions render = options_of(folder.plan(), inputs);
  render.unit.reset();
  render.is_merging = true;
  auto const allowed_paths = render.output.allowed_paths;
  render.output = options.output;
  render.output.allowed_paths = allowed_paths;
  OutputNames names(render.output);
  combine(render, inputs, names);
  if (options.frames_per_second) render.frames_per_second = options.frames_per_second;
  render.load.whole_animation_rate.reset();  // the plan has the pictures that it has
  MergingRenderer renderer(folder, options.allow_mixed ? "" : folder.plan().device.hash,
                           make_renderer(reference_device()));
  {
    ProgressBar bar(console);
    renderer.check_units([&bar](RenderProgress const& now) {
      bar.update("checking the units", {now.fraction, now.rays, now.elapsed_seconds, now.is_compiling});
      return true;
    });
    bar.clear();
  }
  RunReport report;
  return draw_sequence(inputs, render, names, renderer, console, report);
}

}  // namespace lichtraum::app
