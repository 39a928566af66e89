#include "app/planned_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/whole_path.hpp"

namespace lichtraum::app {
namespace {

/// Of pictures that have no names yet.
constexpr char const* any_picture = "%d.exr";

/// Other machines have other current folders.
void make_absolute(RenderOptions& options, std::vector<std::string>& inputs) {
  for (std::string& input : inputs) input = whole_path(input).string();
  std::string& environment = options.job.reading.environment.source;
  if (!environment.empty() && environment != "studio" && environment != "none") {
    environment = whole_path(environment).string();
  }
  for (auto& folder : options.job.reading.allowed_paths) folder = whole_path(folder);
}

/// How the pictures are to be cut, of which the first decides.
struct Cut {
  Region region;
  int samples = 0;
  PlaneSet planes;
  friend bool operator==(Cut const&, Cut const&) = default;
};

}  // namespace

farm::Plan make_plan(RenderOptions& options, std::vector<std::string> const& given, farm::DeviceClass const& device,
                     std::string const& traversal, Console const& console) {
  std::vector<std::string> inputs = given;
  if (std::find(inputs.begin(), inputs.end(), "-") != inputs.end()) {
    throw Error(ErrorKind::usage, "other machines cannot read this one's standard input: give the scene as a file");
  }
  make_absolute(options, inputs);
  std::set<std::string> files;
  options.load.on_read = [&files](std::filesystem::path const& path) { files.insert(whole_path(path).string()); };
  options.load.set_drawing(options.job, device.kind);
  options.output.file = any_picture;
  OutputNames names(options.output);
  combine(options, inputs, names);

  farm::Plan plan;
  std::optional<Cut> cut;
  for (std::string const& input : inputs) {
    SceneSource const source(input);
    LoadedScene const script = source.load(options.job.reading, options.load);
    files.insert(input);
    console.show(script.diagnostics());
    auto const pictures = plan_pictures(script, source, options, names);
    for (PicturePlan const& picture : pictures) {
      Cut const next{*picture.job.region, picture.job.sampling->count, traced_planes(picture.job)};
      if (!cut) cut = next;
      if (next == *cut) continue;
      throw Error(ErrorKind::usage,
                  fmt::format("{}: the pictures of a plan have one size, one number of samples and one integrator: "
                              "--size, --samples and --integrator choose them for all",
                              input));
    }
    plan.scenes.push_back({input, int(pictures.size())});
  }
  plan.version = LICHTRAUM_VERSION;
  plan.device = device;
  plan.traversal = traversal;
  plan.job = options.job;
  plan.job.scene = inputs.front();
  if (options.frames) plan.frames = farm::Frames{options.frames->first, options.frames->last};
  plan.frames_per_second = options.frames_per_second;
  plan.turntable = options.turntable;
  plan.region = cut->region;
  plan.planes = cut->planes;
  plan.sample_count = cut->samples;
  UnitSize const& unit = *options.unit;
  plan.tile = {std::min(unit.tile.width, plan.region.width), std::min(unit.tile.height, plan.region.height)};
  // Planes without means are of the pixels' middles, which are in the first block.
  bool const is_in_blocks = unit.samples > 0 && plan.planes.has(PlaneRule::mean);
  plan.unit_samples = is_in_blocks ? std::min(unit.samples, plan.sample_count) : plan.sample_count;
  for (std::string const& file : files) plan.files.push_back({file, farm::hash_of_file(file)});
  return plan;
}

RenderOptions options_of(farm::Plan const& plan, std::vector<std::string>& inputs) {
  RenderOptions options;
  options.job = plan.job;
  if (plan.frames) options.frames = FrameRange{plan.frames->first, plan.frames->last};
  options.frames_per_second = plan.frames_per_second;
  options.turntable = plan.turntable;
  options.unit = UnitSize{plan.tile, plan.unit_samples};
  options.load.set_drawing(options.job, plan.device.kind);
  options.output.file = any_picture;
  for (farm::PlannedScene const& scene : plan.scenes) inputs.push_back(scene.file);
  options.scenes = inputs;
  check_inputs(options);
  return options;
}

}  // namespace lichtraum::app
