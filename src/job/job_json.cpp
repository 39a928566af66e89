#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "job/json_values.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum {
namespace {

using namespace json_values;

constexpr char const* version_key = "lichtraum_job";
constexpr int version = 1;

Number any_number() { return {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max(), "a number"}; }

/// An array of whole numbers that are the members of a struct.
template <class Struct>
struct Members {
  std::vector<std::pair<int Struct::*, Whole<int>>> members;

  Json write(Struct const& value) const {
    Json array = Json::array();
    for (auto const& [member, range] : members) array.push_back(value.*member);
    return array;
  }
  Struct read(Json const& json, Pointer const& at) const {
    at.expect(json.is_array() && json.size() == members.size(), fmt::format("an array of {} numbers", members.size()));
    Struct value;
    for (std::size_t i = 0; i < members.size(); ++i) value.*members[i].first = members[i].second.read(json[i], at / i);
    return value;
  }
};

struct BackgroundValue {
  static Json write(JobBackground const& background) {
    if (!background.shown) return "none";
    auto const& [kind, top, bottom] = *background.shown;
    if (kind == Background::Kind::environment) return "environment";
    return top == bottom ? write(top) : Json::array({write(top), write(bottom)});
  }
  static JobBackground read(Json const& json, Pointer const& at) {
    if (json == "none") return {};
    if (json == "environment") return {Background::environment()};
    at.expect(json.is_array() && (json.size() == 2 || json.size() == 3),
              "\"environment\", \"none\", an array of red, green and blue, or an array of two of these");
    if (json.size() == 3) return {read_color(json, at)};
    return {Background(read_color(json[0], at / 0), read_color(json[1], at / 1))};
  }

 private:
  static Json write(Rgb const& c) { return {c.r, c.g, c.b}; }
  static Rgb read_color(Json const& json, Pointer const& at) {
    at.expect(json.is_array() && json.size() == 3, "an array of red, green and blue");
    Number const channel{0, std::numeric_limits<double>::max(), "a number of at least 0"};
    return {channel.read(json[0], at / 0), channel.read(json[1], at / 1), channel.read(json[2], at / 2)};
  }
};

struct Point {
  static Json write(Vec3 const& p) { return {p.x, p.y, p.z}; }
  static Vec3 read(Json const& json, Pointer const& at) {
    at.expect(json.is_array() && json.size() == 3, "an array of three numbers");
    return {any_number().read(json[0], at / 0), any_number().read(json[1], at / 1), any_number().read(json[2], at / 2)};
  }
};

struct SamplesPerPixel {
  static constexpr auto fields = [](auto& sampling, auto&& field) {
    field("pattern", sampling.pattern, one_of(pattern_words));
    field("count", sampling.count, Whole{1, job_limits::samples});
  };
  static Json write(Sampling const& sampling) { return Object{fields}.write(sampling); }
  static Sampling read(Json const& json, Pointer const& at) {
    auto const sampling = Object{fields}.template read<Sampling>(json, at);
    auto const side = int(std::lround(std::sqrt(double(sampling.count))));
    (at / "count")
        .expect(sampling.pattern != Sampling::Pattern::grid || side * side == sampling.count,
                "a square number, as the samples are a grid");
    return sampling;
  }
};

constexpr auto dialect_fields = [](auto& dialect, auto&& field) {
  field("transform_order", dialect.transform_order, one_of(transform_order_words));
  field("rotation", dialect.rotation, one_of(rotation_words));
  field("strict", dialect.strict, Flag{});
  field("keep_going", dialect.keep_going, Flag{});
  field("material_extras", dialect.material_extras, ListOf{one_of(material_extra_words)});
};

Number stops_up_to(double most) { return {-most, most, fmt::format("stops from {} to {}", -most, most)}; }
constexpr int most = std::numeric_limits<int>::max();

constexpr auto model_fields = [](auto& model, auto&& field) {
  field("scene", model.scene, Text{});
  field("variant", model.variant, Text{});
  field("animation", model.animation, Text{});
  field("time_seconds", model.time_seconds, any_number());
  field("both_sides", model.both_sides, Flag{});
  field("max_texture_pixels", model.max_texture, Whole{1, job_limits::texture_side});
  field("point_size", model.point_size,
        Number{job_limits::least_point_size, job_limits::point_size,
               fmt::format("thousandths from {} to {}", job_limits::least_point_size, job_limits::point_size)});
};

constexpr auto environment_fields = [](auto& environment, auto&& field) {
  constexpr double turn = job_limits::environment_degrees, brightest = job_limits::environment_brightness;
  field("source", environment.source, Text{});
  field("rotation_degrees", environment.rotation_degrees,
        Number{-turn, turn, fmt::format("degrees from {} to {}", -turn, turn)});
  field("brightness", environment.brightness, Number{0, brightest, fmt::format("a number from 0 to {}", brightest)});
};

constexpr auto encoding_fields = [](auto& encoding, auto&& field) {
  field("bits_per_channel", encoding.bits, Choice{{8, 16}});
  field("jpeg_quality", encoding.jpeg_quality, Whole{1, job_limits::jpeg_quality});
  field("ppm_ascii", encoding.ppm_ascii, Flag{});
};

Number number_between(double low, double high, std::string what) {
  return {std::nextafter(low, high), std::nextafter(high, low), fmt::format("{} between {} and {}", what, low, high)};
}

Number above_zero() {
  return {std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), "a number above 0"};
}

struct FocusValue {
  static Json write(JobView::Focus const& focus) {
    if (auto const* const point = std::get_if<Vec3>(&focus)) return Point::write(*point);
    return std::get<double>(focus);
  }
  static JobView::Focus read(Json const& json, Pointer const& at) {
    if (json.is_array()) return Point::read(json, at);
    return Number{std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                  "a distance above 0, or an array of three numbers"}
        .read(json, at);
  }
};

constexpr auto orbit_fields = [](auto& orbit, auto&& field) {
  field("azimuth_degrees", orbit.azimuth_degrees, any_number());
  field("elevation_degrees", orbit.elevation_degrees, Number{-90, 90, "degrees from -90 to 90"});
  field("distance", orbit.distance, above_zero());
};

constexpr auto view_fields = [](auto& view, auto&& field) {
  field("eye", view.eye, Point{});
  field("look_at", view.look_at, Point{});
  field("up", view.up, Point{});
  field("fov_x_degrees", view.fov_x_degrees, number_between(0, 180, "degrees"));
  field("fov_y_degrees", view.fov_y_degrees, number_between(0, 180, "degrees"));
  field("orbit", view.orbit, Object{orbit_fields});
  field("orthographic", view.orthographic, Flag{});
  field("aperture", view.aperture, Number{0, std::numeric_limits<double>::max(), "a number of at least 0"});
  field("focus", view.focus, FocusValue{});
};

/// Every member of a job: what it is called, and what it may be.
constexpr auto job_fields = [](auto& job, auto&& field) {
  field("scene", job.scene, Name{});
  field("text", job.text, Text{});
  field("esdf", job.reading.dialect, Object{dialect_fields});
  field("model", job.reading.model, Object{model_fields});
  field("environment", job.reading.environment, Object{environment_fields});
  field("allowed_paths", job.reading.allowed_paths, ListOf{Path{}});
  field("picture", job.picture, Whole{0, most});

  field("camera", job.camera, Text{});
  field("view", job.view, Object{view_fields});
  field("root", job.root, Text{});
  field("turn_degrees", job.turn_degrees, any_number());
  field("size", job.size, Members<Resolution>{{{&Resolution::width, {1, most}}, {&Resolution::height, {1, most}}}});
  field("region", job.region,
        Members<Region>{{{&Region::x, {0, most}},
                         {&Region::y, {0, most}},
                         {&Region::width, {1, most}},
                         {&Region::height, {1, most}}}});
  field("integrator", job.integrator, one_of(integrator_words));
  field("sampling", job.sampling, SamplesPerPixel{});
  field("sample_range", job.samples,
        Members<SampleRange>{{{&SampleRange::first, {0, most}}, {&SampleRange::end, {1, most}}}});
  field("noise", job.noise, Number{std::numeric_limits<double>::min(), 1, "a number above 0, at most 1"});
  field("max_depth", job.max_depth, Whole{0, job_limits::depth});
  field("max_indirect", job.max_indirect, above_zero());
  field("seed", job.seed, Whole{std::uint64_t(0), std::numeric_limits<std::uint64_t>::max()});
  field("planes", job.planes, PlaneNames{});
  field("background", job.background, BackgroundValue{});
  field("ground", job.ground, one_of(ground_words));
  field("denoising", job.denoising, one_of(denoising_words));

  field("exposure_ev", job.exposure_ev, stops_up_to(job_limits::exposure_ev));
  field("tone_map", job.tone_map, one_of(tone_map_words));
  field("transfer", job.transfer, one_of(transfer_words));
  field("encoding", job.encoding, Object{encoding_fields});
};

}  // namespace

std::string to_json(Job const& job) {
  Job finite = job;
  if (job.max_indirect == std::numeric_limits<double>::infinity()) finite.max_indirect.reset();  // the same: no limit
  Json json{{version_key, version}};
  json.update(Object{job_fields}.write(finite));
  std::string text;
  try {
    text = json.dump(2) + "\n";
  } catch (Json::type_error const&) {
    throw Error(ErrorKind::usage, fmt::format("JSON cannot hold a job of '{}': a name in it is not UTF-8", job.scene));
  }
  job_from_json(text);  // what is out of range is told now, not to who reads it
  return text;
}

Job job_from_json(std::string_view text) {
  constexpr std::size_t most_values = 100'000;
  Json json = parse(text, "job", most_values);
  Pointer const root;
  root.expect(json.is_object(), "a JSON object");
  auto const found = json.find(version_key);
  Pointer const at = root / version_key;
  at.expect(found != json.end(), "it, as only that tells that this is a job");
  at.expect(*found == version, fmt::format("{}: jobs of another version cannot be read", version));
  json.erase(found);
  root.expect(json.contains("scene"), "a key \"scene\"");
  return Object{job_fields}.read<Job>(json, root);
}

}  // namespace lichtraum
