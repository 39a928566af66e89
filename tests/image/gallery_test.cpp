#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "lichtraum/esdf.hpp"
#include "lichtraum/image_io.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/decode.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

// The scenes of scenes/, small: on every device as the reference tracer shows them, and as they were when somebody last
// looked at them. After a change that is meant to change them, set LICHTRAUM_WRITE_BASELINES, run this test, and look
// at tests/image/baselines.

namespace {

std::filesystem::path const project = LICHTRAUM_SOURCE_DIR;
constexpr int width = 120;

std::vector<std::filesystem::path> gallery() {
  std::vector<std::filesystem::path> files;
  for (auto const& entry : std::filesystem::recursive_directory_iterator(project / "scenes")) {
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

void compare_with_baseline(Image const& picture, std::string const& name) {
  auto const path = project / "tests/image/baselines" / (name + ".png");
  if (std::getenv("LICHTRAUM_WRITE_BASELINES")) {
    std::filesystem::create_directories(path.parent_path());
    write_file_atomically(path, image_format_named("png").encode(picture, {}));
  }
  INFO(path << " is missing: see the top of gallery_test.cpp");
  REQUIRE(std::filesystem::exists(path));
  check_picture(picture, image_of(decode(read_project_file(path))), name + ", baseline");
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
        RenderRequest const request = small_request(scene, command);
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
  auto const file = project / "scenes/standard/composite.sdf";
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
