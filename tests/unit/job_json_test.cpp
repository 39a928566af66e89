#include <fmt/format.h>

#include <limits>
#include <random>

#include "lichtraum/job.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"

// A job as JSON: there and back, and what text that nobody trusts may do.

using namespace lichtraum;

namespace {

class RandomJobs {
 public:
  Job next() {
    Job job;
    job.scene = word() + ".sdf";
    maybe([&] { job.text = word(); });
    job.reading.dialect.transform_order = coin() ? TransformOrder::local : TransformOrder::parent;
    job.reading.dialect.rotation = coin() ? RotationSense::left : RotationSense::right;
    job.reading.dialect.strict = coin();
    job.reading.dialect.keep_going = coin();
    while (coin()) job.reading.dialect.material_extras.push_back(MaterialExtra(whole(0, 4)));
    maybe([&] { job.reading.model.scene = word(); });
    maybe([&] { job.reading.model.variant = word(); });
    maybe([&] { job.reading.model.animation = word(); });
    maybe([&] { job.reading.model.time_seconds = real(); });
    job.reading.model.both_sides = coin();
    job.reading.model.max_texture = whole(1, job_limits::texture_side);
    maybe([&] { job.reading.model.point_size = whole(1, 1000) / 7.0; });
    maybe([&] { job.reading.environment.source = word(); });
    maybe([&] { job.reading.environment.rotation_degrees = whole(-1000, 1000) / 7.0; });
    maybe([&] { job.reading.environment.brightness = whole(0, 1000) / 7.0; });
    while (coin()) job.reading.allowed_paths.emplace_back(word());
    job.picture = whole(0, most);
    maybe([&] { job.camera = word(); });
    maybe([&] { job.view.eye = point(); });
    maybe([&] { job.view.look_at = point(); });
    maybe([&] { job.view.up = point(); });
    maybe([&] { job.view.fov_x_degrees = std::ldexp(179.0, -whole(0, 1000)); });
    maybe([&] { job.view.fov_y_degrees = 179.99; });
    maybe([&] { job.view.orthographic = true; });
    maybe([&] { job.view.orbit = JobView::Orbit{real(), -90, {}}; });
    maybe([&] { job.view.orbit = JobView::Orbit{real(), 12.5, 1 + std::abs(real())}; });
    maybe([&] { job.view.aperture = std::abs(real()); });
    maybe([&] { job.view.focus = 1 + std::abs(real()); });
    maybe([&] { job.view.focus = point(); });
    maybe([&] { job.root = word(); });
    maybe([&] { job.turn_degrees = real(); });
    maybe([&] { job.size = Resolution{whole(1, most), whole(1, most)}; });
    maybe([&] { job.region = Region{whole(0, most), whole(0, most), whole(1, most), whole(1, most)}; });
    maybe([&] { job.sampling = Sampling{Sampling::Pattern::seeded, whole(1, job_limits::samples)}; });
    maybe([&] { job.noise = 1.0 / whole(1, 1000); });
    maybe([&] {
      int const side = whole(1, job_limits::grid_side);
      job.sampling = Sampling{Sampling::Pattern::grid, side * side};
    });
    maybe([&] {
      int const first = Film::block_size * whole(0, 1000);
      job.samples = SampleRange{first, first + whole(1, 1000)};
    });
    maybe([&] { job.integrator = coin() ? Integrator::path : Integrator::whitted; });
    maybe([&] { job.max_depth = whole(0, job_limits::depth); });
    maybe([&] { job.max_indirect = 1.0 / whole(1, 1000); });
    job.ground = Ground(whole(0, 2));
    job.seed = std::uniform_int_distribution<std::uint64_t>()(random_);
    job.planes = {FilmPlane(whole(0, int(plane_count) - 1))};
    while (coin()) job.planes.add(FilmPlane(whole(0, int(plane_count) - 1)));
    maybe([&] { job.background = JobBackground{}; });
    maybe([&] { job.background = JobBackground{Background::environment()}; });
    maybe([&] { job.background = JobBackground{Rgb(std::abs(real()), 0, 1e-310)}; });
    maybe([&] { job.background = JobBackground{Background(Rgb(std::abs(real())), Rgb(0, 1, 0))}; });
    job.denoising = Denoising(whole(0, 3));
    job.exposure_ev = std::uniform_real_distribution(-100.0, 100.0)(random_);
    job.tone_map = ToneMap(whole(0, 5));
    maybe([&] { job.transfer = coin() ? Transfer::srgb : Transfer::linear; });
    job.encoding = {coin() ? 8 : 16, coin(), whole(1, 100)};
    return job;
  }

 private:
  static constexpr int most = std::numeric_limits<int>::max();
  bool coin() { return whole(0, 1) == 1; }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  double real() { return std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random_), whole(-1000, 1000)); }
  Vec3 point() { return {real(), real(), real()}; }
  template <class Action>
  void maybe(Action action) {
    if (coin()) action();
  }
  std::string word() {
    constexpr std::string_view letters[] = {"a", "/", "~", "\"", "\\", "\n", "ä", "\x01", "😀", " ", "é"};
    std::string text = "x";
    while (coin()) text += letters[std::size_t(whole(0, 10))];
    return text;
  }

  std::mt19937 random_{1};
};

/// What reading throws; "" when nothing is wrong.
std::string refusal(std::string_view text) {
  try {
    job_from_json(text);
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::usage);
    return error.what();
  }
  return {};
}

/// A job with one more key.
std::string with(std::string const& key_and_value) {
  return R"({"lichtraum_job": 1, "scene": "a.sdf", )" + key_and_value + "}";
}

}  // namespace

TEST_CASE("jobs are read back from JSON as they were", "[unit][job]") {
  RandomJobs jobs;
  for (int i = 0; i < 2000; ++i) {
    Job const job = jobs.next();
    std::string const json = to_json(job);
    INFO(json);
    Job const back = job_from_json(json);
    REQUIRE(back == job);
    REQUIRE(to_json(back) == json);
  }
}

TEST_CASE("keys that are left out stand for what a job is without them", "[unit][job]") {
  Job job;
  job.scene = "a.sdf";
  CHECK(job_from_json(R"({"lichtraum_job": 1, "scene": "a.sdf"})") == job);
  CHECK(job_from_json(with(R"("encoding": {}, "esdf": {}, "model": {})")) == job);
}

TEST_CASE("the keys of a job are called so for good", "[unit][job]") {
  Job const job = job_from_json(with(
      R"("text": "define", "esdf": {"transform_order": "local", "rotation": "left", "strict": true, "keep_going": true,
         "material_extras": ["opacity", "ior"]},
         "model": {"scene": "s", "variant": "v", "animation": "walk", "time_seconds": 1.5,
         "both_sides": true, "max_texture_pixels": 512, "point_size": 2.5},
         "environment": {"source": "studio", "rotation_degrees": -90, "brightness": 0.5},
         "allowed_paths": ["/tmp"], "picture": 3, "camera": "eye",
         "view": {"eye": [1, 2, 3], "look_at": [4, 5, 6], "up": [0, 0, 1], "fov_x_degrees": 30, "fov_y_degrees": 20,
         "orbit": {"azimuth_degrees": 35, "elevation_degrees": 20, "distance": 9}, "orthographic": true,
         "aperture": 0.5, "focus": [7, 8, 9]}, "root": "robot", "turn_degrees": 30,
         "size": [640, 480], "region": [1, 2, 3, 4], "integrator": "path", "sampling": {"pattern": "grid", "count": 16},
         "noise": 0.25, "max_indirect": 8, "ground": "glossy",
         "sample_range": [0, 16], "max_depth": 7, "seed": 18446744073709551615, "planes": ["depth", "radiance"],
         "background": [0.1, 0.2, 0.3], "denoising": "builtin", "exposure_ev": -2, "tone_map": "reinhard", "transfer": "srgb",
         "encoding": {"bits_per_channel": 16, "jpeg_quality": 50, "ppm_ascii": true})"));
  Job wanted;
  wanted.scene = "a.sdf";
  wanted.text = "define";
  wanted.reading.dialect = {
      TransformOrder::local, RotationSense::left, true, true, {MaterialExtra::opacity, MaterialExtra::ior}};
  wanted.reading.model = {512, 2.5, "v", "s", 1.5, "walk", true};
  wanted.reading.environment = {"studio", -90, 0.5};
  wanted.reading.allowed_paths = {"/tmp"};
  wanted.picture = 3;
  wanted.camera = "eye";
  wanted.view = {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(0, 0, 1), 30, 20, JobView::Orbit{35, 20, 9},
                 true,          0.5,           Vec3(7, 8, 9)};
  wanted.root = "robot";
  wanted.turn_degrees = 30;
  wanted.size = Resolution{640, 480};
  wanted.region = Region{1, 2, 3, 4};
  wanted.integrator = Integrator::path;
  wanted.sampling = Sampling{Sampling::Pattern::grid, 16};
  wanted.noise = 0.25;
  wanted.max_indirect = 8;
  wanted.ground = Ground::glossy;
  wanted.samples = SampleRange{0, 16};
  wanted.max_depth = 7;
  wanted.seed = std::numeric_limits<std::uint64_t>::max();
  wanted.planes = {FilmPlane::radiance, FilmPlane::depth};
  wanted.background = JobBackground{Rgb(0.1, 0.2, 0.3)};
  wanted.denoising = Denoising::builtin;
  wanted.exposure_ev = -2;
  wanted.tone_map = ToneMap::reinhard;
  wanted.transfer = Transfer::srgb;
  wanted.encoding = {16, true, 50};
  CHECK(job == wanted);
}

TEST_CASE("a job's background is a colour, two, the environment or none", "[unit][job]") {
  CHECK(job_from_json(with(R"("background": [1, 2, 3])")).background == JobBackground{Rgb(1, 2, 3)});
  CHECK(job_from_json(with(R"("background": [[1, 2, 3], [4, 5, 6]])")).background ==
        JobBackground{Background(Rgb(1, 2, 3), Rgb(4, 5, 6))});
  CHECK(job_from_json(with(R"("background": "environment")")).background == JobBackground{Background::environment()});
  CHECK(job_from_json(with(R"("background": "none")")).background == JobBackground{});
}

TEST_CASE("docs/JOB.md names every key, and its example is a job", "[unit][job]") {
  std::string const document = read_project_file("docs/JOB.md");
  // Only an unknown key tells all known ones.
  for (std::string const place : {"", "\"esdf\": ", "\"model\": ", "\"view\": ", "\"encoding\": "}) {
    std::string const text = refusal(with(place.empty() ? "\"no\": 1" : place + "{\"no\": 1}"));
    std::string keys = text.substr(text.find("there are: ") + 11) + ", ";
    for (std::size_t end; (end = keys.find(", ")) != std::string::npos; keys.erase(0, end + 2)) {
      INFO(keys);
      CHECK(document.find("`" + keys.substr(0, end) + "`") != std::string::npos);
    }
  }
  std::size_t const begin = document.find("```json\n") + 8;
  Job const job = job_from_json(document.substr(begin, document.find("```", begin) - begin));
  CHECK(job.planes == PlaneSet{FilmPlane::radiance, FilmPlane::depth});
}

TEST_CASE("what is wrong in a job is named by its place", "[unit][job]") {
  auto const expect = [](std::string const& text, std::string const& message) {
    INFO(text);
    CHECK(refusal(text) == message);
  };
  std::string const whole = "expected a whole number from ";
  expect(with(R"("region": [0, 0, 0, 5])"), "/region/2: " + whole + "1 to 2147483647");
  expect(with(R"("region": [0, -1, 1, 5])"), "/region/1: " + whole + "0 to 2147483647");
  expect(with(R"("region": [0, 0, 1])"), "/region: expected an array of 4 numbers");
  expect(with(R"("size": [1.5, 1])"), "/size/0: " + whole + "1 to 2147483647");
  expect(with(R"("size": [1, 4294967297])"), "/size/1: " + whole + "1 to 2147483647");
  expect(with(R"("size": {"width": 1})"), "/size: expected an array of 2 numbers");
  expect(with(R"("integrator": "bidirectional")"), "/integrator: expected whitted or path");
  expect(with(R"("sampling": {"pattern": "grid", "count": 5})"),
         "/sampling/count: expected a square number, as the samples are a grid");
  expect(with(R"("sampling": {"pattern": "seeded", "count": 1048577})"), "/sampling/count: " + whole + "1 to 1048576");
  expect(with(R"("sampling": {"pattern": "halton"})"), "/sampling/pattern: expected grid or seeded");
  expect(with(R"("noise": 0)"), "/noise: expected a number above 0, at most 1");
  expect(with(R"("noise": 1.1)"), "/noise: expected a number above 0, at most 1");
  expect(with(R"("sampling": 4)"), "/sampling: expected an object");
  expect(with(R"("max_depth": 1001)"), "/max_depth: " + whole + "0 to 1000");
  expect(with(R"("seed": -1)"), "/seed: " + whole + "0 to 18446744073709551615");
  expect(with(R"("seed": 18446744073709551616)"), "/seed: " + whole + "0 to 18446744073709551615");
  expect(with(R"("picture": true)"), "/picture: " + whole + "0 to 2147483647");
  expect(with(R"("planes": ["depth", "beauty"])"),
         "/planes/1: expected radiance, alpha, albedo, normal, depth, position, object, instance or material");
  expect(with(R"("planes": [])"), "/planes: expected at least one plane");
  expect(
      with(R"("background": "black")"),
      "/background: expected \"environment\", \"none\", an array of red, green and blue, or an array of two of these");
  expect(with(R"("background": [[0, 0, 0], 1])"), "/background/1: expected an array of red, green and blue");
  expect(with(R"("background": [[0, 0, 0], [0, 1, -1]])"), "/background/1/2: expected a number of at least 0");
  expect(with(R"("background": [0, 0, -1])"), "/background/2: expected a number of at least 0");
  expect(with(R"("view": {"eye": [1, 2]})"), "/view/eye: expected an array of three numbers");
  expect(with(R"("view": {"up": [1, 2, "z"]})"), "/view/up/2: expected a number");
  expect(with(R"("view": {"fov_x_degrees": 180})"), "/view/fov_x_degrees: expected degrees between 0 and 180");
  expect(with(R"("view": {"fov_y_degrees": 0})"), "/view/fov_y_degrees: expected degrees between 0 and 180");
  expect(with(R"("view": {"aperture": -1})"), "/view/aperture: expected a number of at least 0");
  expect(with(R"("view": {"focus": 0})"), "/view/focus: expected a distance above 0, or an array of three numbers");
  expect(with(R"("view": {"focus": [1, 2]})"), "/view/focus: expected an array of three numbers");
  expect(with(R"("view": {"orbit": [35, 20]})"), "/view/orbit: expected an object");
  expect(with(R"("view": {"orbit": {"distance": 0}})"), "/view/orbit/distance: expected a number above 0");
  expect(with(R"("view": {"orbit": {"azimuth": 0}})"),
         "/view/orbit/azimuth: unknown key; there are: azimuth_degrees, elevation_degrees, distance");
  expect(with(R"("exposure_ev": 101)"), "/exposure_ev: expected stops from -100 to 100");
  expect(with(R"("exposure_ev": "1")"), "/exposure_ev: expected stops from -100 to 100");
  expect(with(R"("turn_degrees": null)"), "/turn_degrees: expected a number");
  expect(with(R"("tone_map": "filmic")"), "/tone_map: expected auto, neutral, agx, aces, reinhard or none");
  expect(with(R"("encoding": {"bits_per_channel": 12})"), "/encoding/bits_per_channel: expected 8 or 16");
  expect(with(R"("esdf": {"strict": 1})"), "/esdf/strict: expected true or false");
  expect(with(R"("esdf": {"material_extras": ["ior", 1]})"),
         "/esdf/material_extras/1: expected reflectance, transmittance, opacity, ior or ignore");
  expect(with(R"("environment": {"brightness": -1})"), "/environment/brightness: expected a number from 0 to 1000000");
  expect(with(R"("environment": {"rotation_degrees": 1e7})"),
         "/environment/rotation_degrees: expected degrees from -1000000 to 1000000");
  expect(with(R"("environment": "studio")"), "/environment: expected an object");
  expect(with(R"("allowed_paths": [""])"), "/allowed_paths/0: expected a name");
  expect(with(R"("camera": 0)"), "/camera: expected a text");
  expect(with(R"("encoding": {"bits": 8})"),
         "/encoding/bits: unknown key; there are: bits_per_channel, jpeg_quality, ppm_ascii");
  CHECK(refusal(with(R"("a/b~c": 1)")).starts_with("/a~1b~0c: unknown key; there are: scene, text, esdf, "));
}

TEST_CASE("what is no job at all", "[unit][job]") {
  CHECK(refusal("[]") == "expected a JSON object");
  CHECK(refusal("{}") == "/lichtraum_job: expected it, as only that tells that this is a job");
  CHECK(refusal(R"({"lichtraum_job": 2, "scene": "a"})") ==
        "/lichtraum_job: expected 1: jobs of another version cannot be read");
  CHECK(refusal(R"({"lichtraum_job": 1})") == "expected a key \"scene\"");
  CHECK(refusal(R"({"lichtraum_job": 1, "scene": ""})") == "/scene: expected a name");
  CHECK(refusal("{\n  \"lichtraum_job\": 1,\n  scene\n}") == "line 3, column 3: not JSON");
  CHECK(refusal("") == "line 1, column 1: not JSON");
  CHECK(refusal(with("\"seed\": 1, \"seed\": 2")) == "not a job: the key \"seed\" is there twice");
  CHECK(refusal(with("\"turn_degrees\": 1e999")).starts_with("not JSON"));
  CHECK(refusal("{\"lichtraum_job\": 1, \"scene\": \"\xff\"}").ends_with("not JSON"));
}

TEST_CASE("text that nobody trusts is refused before it grows", "[unit][job][hostile]") {
  CHECK(refusal(std::string(10'000'000, '[')) == "not a job: nested deeper than 4 levels");
  std::string zeros = "0";
  for (int i = 0; i < 1'000'000; ++i) zeros += ",0";
  CHECK(refusal(with("\"planes\": [" + zeros + "]")) == "not a job: more than 100000 values");
  std::string keys = "\"k\": 0";
  for (int i = 0; i < 100; ++i) keys += fmt::format(", \"k{}\": 0", i);
  CHECK(refusal(with(keys)).starts_with("/k: unknown key"));
  for (int i = 100; i < 20'000; ++i) keys += fmt::format(", \"k{}\": 0", i);
  CHECK(refusal(with(keys)) == "not a job: an object of more than 200 keys");
}

TEST_CASE("a job that is cut off or damaged anywhere is refused or read, and nothing else", "[unit][job][hostile]") {
  RandomJobs jobs;
  std::mt19937 random{2};
  for (int i = 0; i < 20; ++i) {
    std::string const json = to_json(jobs.next());
    std::size_t const end = json.rfind('}');
    for (std::size_t length = 0; length <= end; ++length) REQUIRE(!refusal(json.substr(0, length)).empty());
    for (int damage = 0; damage < 300; ++damage) {
      std::string damaged = json;
      damaged[random() % damaged.size()] = char(random());
      try {
        Job const job = job_from_json(damaged);
        REQUIRE(job_from_json(to_json(job)) == job);
      } catch (Error const& error) {
        REQUIRE(error.kind() == ErrorKind::usage);
      }
    }
  }
}

TEST_CASE("no limit of indirect light is the same as an infinite one", "[unit][job]") {
  Job job;
  job.scene = "a.sdf";
  std::string const unlimited = to_json(job);
  job.max_indirect = std::numeric_limits<double>::infinity();
  CHECK(to_json(job) == unlimited);
}

TEST_CASE("a job that could not be read back has no JSON", "[unit][job]") {
  CHECK_THROWS_WITH(to_json(Job{}), "/scene: expected a name");
  Job dark;
  dark.scene = "a.sdf";
  dark.exposure_ev = -1000;
  CHECK_THROWS_WITH(to_json(dark), "/exposure_ev: expected stops from -100 to 100");
}

TEST_CASE("a job with a name that is not UTF-8 or a number that is none has no JSON", "[unit][job]") {
  Job unsure;
  unsure.scene = "a.sdf";
  unsure.exposure_ev = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(to_json(unsure), Error);
  Job job;
  job.scene = "\xff.sdf";
  CHECK_THROWS_AS(to_json(job), Error);
}
