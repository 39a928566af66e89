#include "farm/plan.hpp"
#include "job/json_values.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::farm {
namespace {

using namespace json_values;

constexpr char const* plan_version_key = "lichtraum_plan";
constexpr int plan_version = 1;
constexpr int most = std::numeric_limits<int>::max();
constexpr int most_pictures = job_limits::pictures;
constexpr std::size_t most_files = 2 * std::size_t(most_pictures);
/// A scene or a file is an object of two keys, which count with its start and end; the rest is the size of a job.
constexpr std::size_t most_values = 6 * (std::size_t(most_pictures) + most_files) + 100'000;

constexpr auto device_fields = [](auto& device, auto&& field) {
  field("class", device.hash, Text{});
  field("kind", device.kind, one_of(device_kind_words));
  field("name", device.name, Text{});
};

constexpr auto scene_fields = [](auto& scene, auto&& field) {
  field("file", scene.file, Name{});
  field("pictures", scene.picture_count, Whole{1, most_pictures});
};

constexpr auto file_fields = [](auto& file, auto&& field) {
  field("path", file.path, Name{});
  field("xxh3_128", file.hash, Text{});
};

constexpr auto frames_fields = [](auto& frames, auto&& field) {
  field("first", frames.first, Whole{0, most});
  field("last", frames.last, Whole{0, most});
};

template <class Struct, class Fields>
struct StructList {
  Fields fields;
  Json write(std::vector<Struct> const& values) const {
    Json array = Json::array();
    for (Struct const& value : values) array.push_back(Object{fields}.write(value));
    return array;
  }
  std::vector<Struct> read(Json const& json, Pointer const& at) const {
    at.expect(json.is_array(), "an array");
    std::vector<Struct> values;
    for (std::size_t i = 0; i < json.size(); ++i)
      values.push_back(Object{fields}.template read<Struct>(json[i], at / i));
    return values;
  }
};

struct JobValue {
  static Json write(Job const& job) { return Json::parse(lichtraum::to_json(job)); }
  static Job read(Json const& json, Pointer const& at) {
    try {
      return job_from_json(json.dump());
    } catch (Error const& error) {
      at.fail(error.what());
    }
  }
};

constexpr auto plan_fields = [](auto& plan, auto&& field) {
  field("lichtraum", plan.version, Text{});
  field("device", plan.device, Object{device_fields});
  field("traversal", plan.traversal, Text{});
  field("job", plan.job, JobValue{});
  field("scenes", plan.scenes, StructList<PlannedScene, decltype(scene_fields)>{scene_fields});
  field("frames", plan.frames, Object{frames_fields});
  field("fps", plan.frames_per_second, Number{1e-3, 1000, "a number of frames, at most 1000"});
  field("turntable", plan.turntable, Whole{0, most_pictures});
  field("region", plan.region, Object{[](auto& region, auto&& part) {
          part("x", region.x, Whole{0, most});
          part("y", region.y, Whole{0, most});
          part("width", region.width, Whole{1, most});
          part("height", region.height, Whole{1, most});
        }});
  field("planes", plan.planes, PlaneNames{});
  field("samples", plan.sample_count, Whole{1, job_limits::samples});
  field("tile", plan.tile, Object{[](auto& tile, auto&& part) {
          part("width", tile.width, Whole{1, most});
          part("height", tile.height, Whole{1, most});
        }});
  field("unit_samples", plan.unit_samples, Whole{1, job_limits::samples});
  field("files", plan.files, StructList<ReadFile, decltype(file_fields)>{file_fields});
};

/// Throws Error{usage} for what fits together in no plan.
void check(Plan const& plan) {
  Pointer const root;
  (root / "scenes").expect(!plan.scenes.empty(), "at least one scene");
  std::int64_t pictures = 0;
  for (PlannedScene const& scene : plan.scenes) pictures += scene.picture_count;
  (root / "scenes").expect(pictures <= most_pictures, fmt::format("at most {} pictures", most_pictures));
  (root / "files").expect(plan.files.size() <= most_files, fmt::format("at most {} files", most_files));
  bool const has_region =
      plan.region.width > 0 && plan.region.height > 0 && plan.tile.width > 0 && plan.tile.height > 0;
  root.expect(has_region, "a region and a tile");
  bool const is_inside = plan.region.x <= most - plan.region.width && plan.region.y <= most - plan.region.height &&
                         plan.tile.width <= plan.region.width && plan.tile.height <= plan.region.height;
  (root / "tile").expect(is_inside, "a tile no larger than the region");
  bool const has_blocks = plan.unit_samples >= plan.sample_count || plan.unit_samples % Film::block_size == 0;
  (root / "unit_samples").expect(has_blocks, fmt::format("a multiple of {}", Film::block_size));
  (root / "planes").expect(!plan.planes.is_empty(), "the planes that are stored");
  double const units = double(plan.columns()) * plan.rows() * plan.sample_blocks() * double(pictures);
  root.expect(units <= double(most_units), fmt::format("at most {} units: larger tiles make fewer", most_units));
}

}  // namespace

std::string to_json(Plan const& plan) {
  check(plan);
  Json json{{plan_version_key, plan_version}};
  json.update(Object{plan_fields}.write(plan));
  try {
    return json.dump(2) + "\n";
  } catch (Json::type_error const&) {
    throw Error(ErrorKind::usage, "JSON cannot hold the plan: a file's name is not UTF-8");
  }
}

Plan plan_from_json(std::string_view text) {
  Json json = parse(text, "plan", most_values);
  Pointer const root;
  root.expect(json.is_object(), "a JSON object");
  auto const found = json.find(plan_version_key);
  (root / plan_version_key).expect(found != json.end() && *found == plan_version, fmt::format("{}", plan_version));
  json.erase(found);
  Plan plan = Object{plan_fields}.read<Plan>(json, root);
  check(plan);
  return plan;
}

}  // namespace lichtraum::farm
