#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "lichtraum/esdf.hpp"
#include "lichtraum/image_io.hpp"
#include "lichtraum/job.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/decode.hpp"
#include "support/file_contents.hpp"
#include "support/picture_check.hpp"
#include "support/project_files.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

// The scenes of scenes/, small: on every device as the reference tracer shows them, and as they were when somebody last
// looked at them. After a change that is meant to change them, set LICHTRAUM_WRITE_BASELINES, run this test, and look
// at tests/image/baselines.

namespace {

constexpr int width = 120;

std::vector<std::filesystem::path> gallery() {
  std::vector<std::filesystem::path> files;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(project_path("scenes"))) {
    if (entry.path().extension() == ".sdf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Development const as_the_scene_says{0, ToneMap::automatic, Transfer::linear};

RenderRequest small_request(Scene const& scene, RenderCommand const& command) {
  Camera const* const camera = scene.cameras.find(command.camera);
  REQUIRE(camera);
  auto resolution = command.resolution ? command.resolution : camera->resolution();
  if (!resolution) resolution = scene.resolution.value_or(Resolution{4, 3});
  RenderRequest request = whole_picture(*camera, {width, width * resolution->height / resolution->width});
  request.max_depth = command.depth.value_or(request.max_depth);
  return request;
}

Image image_of(DecodedImage const& decoded) {
  Image image(Resolution{decoded.width, decoded.height});
  std::transform(decoded.values.begin(), decoded.values.end(), image.data().begin(),
                 [&](float value) { return value / float(decoded.max); });
  return image;
}

/// What the picture was; `picture` becomes that where baselines are to be written.
Image baseline(Image const& picture, std::string const& name) {
  std::filesystem::path const path = project_path("tests/image/baselines/" + name + ".png");
  if (std::getenv("LICHTRAUM_WRITE_BASELINES")) {
    std::filesystem::create_directories(path.parent_path());
    write_file_atomically(path, image_format_named("png").encode(picture, {}));
  }
  INFO(path << " is missing: see the top of gallery_test.cpp");
  REQUIRE(std::filesystem::exists(path));
  return image_of(decode(file_contents(path)));
}

void compare_with_baseline(Image picture, std::string const& name) {
  Image const expected = baseline(picture, name);
  for (float& value : picture.data()) value = std::clamp(value, 0.0f, 1.0f);  // as files have it
  check_picture(picture, expected, name + ", baseline");
}

/// Paths leave noise: few pixels of many samples, and the root of the mean square of what differs.
void check_paths(Scene const& scene, RenderRequest request, std::string const& name) {
  constexpr int reduction = 5, samples = 4096;
  constexpr double largest_difference = 0.012;  // some three steps of eight bits, which rounding takes one of
  request.resolution = {request.resolution.width / reduction, request.resolution.height / reduction};
  request.region = whole_picture(request.camera, request.resolution).region;
  request.sampling = {Sampling::Pattern::seeded, samples};
  request.max_depth = 16;
  for (DeviceInfo const& device : opencl_devices()) {
    Image const picture = render_on(device, scene, request, {}, as_the_scene_says);
    Image const expected = baseline(picture, name);
    REQUIRE(picture.data().size() == expected.data().size());
    double squares = 0;
    for (std::size_t i = 0; i < expected.data().size(); ++i) {
      double const difference = std::clamp(picture.data()[i], 0.0f, 1.0f) - expected.data()[i];
      squares += difference * difference / double(expected.data().size());
    }
    CHECK(std::sqrt(squares) < largest_difference);
  }
}

}  // namespace

TEST_CASE("the gallery looks as it did, on every device", "[image]") {
  auto const files = gallery();
  CHECK(files.size() >= 8);
  for (auto const& file : files) {
    DYNAMIC_SECTION(file.filename().string()) {
      EsdfScript const script = EsdfScript::from_file(file);
      std::size_t const count = script.scene().renders.size();
      REQUIRE(count > 0);
      std::size_t index = 0;
      script.play([&](Scene const& scene, RenderCommand const& command) {
        bool const is_shown = index == 0 || index + 1 == count;  // an animation by its ends
        ++index;
        if (!is_shown) return true;
        std::string const name = file.stem().string() + (count > 1 ? fmt::format("_{}", index) : "");
        RenderRequest request = small_request(scene, command);
        Job job;
        job.scene = file;
        Job const decided = resolved(job, scene);
        if (decided.integrator == Integrator::path) {
          if (decided.background) request.background = decided.background->shown;
          request.integrator = Integrator::path;
          check_paths(scene, request, name);
          return true;
        }
        Image const expected = render_reference(scene, request, as_the_scene_says);
        compare_with_baseline(expected, name);
        for (DeviceInfo const& device : opencl_devices()) {
          check_picture(render_on(device, scene, request, {}, as_the_scene_says), expected,
                        fmt::format("{}, device {}", name, device.index));
        }
        return true;
      });
      CHECK(index == count);
    }
  }
}

TEST_CASE("the standard's composite example shows box and sphere with left-handed rotations only", "[image]") {
  auto const file = project_path("scenes/standard/composite.sdf");
  EsdfOptions options;
  options.rotation = RotationSense::left;
  Scene const left = EsdfScript::from_file(file, options).take_scene();
  RenderRequest const request = small_request(left, left.renders.front());
  auto const renderer = make_renderer(reference_device());
  renderer->set_scene(left);
  Image picture;
  CHECK(render_image(*renderer, request, picture, as_the_scene_says).statistics.rays.camera_hits > 1000);
  compare_with_baseline(picture, "composite_left");

  Scene const right = EsdfScript::from_file(file).take_scene();
  renderer->set_scene(right);
  CHECK(render_image(*renderer, small_request(right, right.renders.front()), picture).statistics.rays.camera_hits == 0);
}
