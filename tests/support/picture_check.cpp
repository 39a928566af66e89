#include "support/picture_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lichtraum/image_io.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"

namespace lichtraum::test {
namespace {

struct DifferingPixel {
  int x;
  int y;
  double difference;
};

/// Relative where it is brighter than white.
double difference_of(float a, float b) {
  if (a == b) return 0;
  double const difference = std::abs(double(a) - double(b)) / std::max({1.0, std::abs(double(a)), std::abs(double(b))});
  return std::isnan(difference) ? 1 : difference;
}

std::vector<DifferingPixel> differing_pixels(Image const& actual, Image const& expected) {
  std::vector<DifferingPixel> result;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      double largest = 0;
      for (int channel = 0; channel < 3; ++channel) {
        largest = std::max(largest, difference_of(actual.pixel(x, y)[channel], expected.pixel(x, y)[channel]));
      }
      if (largest > picture_tolerance) result.push_back({x, y, largest});
    }
  }
  return result;
}

Image difference_picture(Image const& actual, Image const& expected) {
  Image result(expected.size());
  for (std::size_t i = 0; i < result.data().size(); ++i) {
    result.data()[i] = float(8 * difference_of(actual.data()[i], expected.data()[i]));
  }
  return result;
}

void leave_picture(Image const& image, std::string name) {
  for (char& c : name) {
    if (c == ' ' || c == ',' || c == '/') c = '_';
  }
  std::filesystem::create_directories(artifact_path(""));
  write_file_atomically(artifact_path(name), image_format_named("png").encode(image, {}));
}

std::string list(std::vector<DifferingPixel> const& pixels, Image const& actual, Image const& expected) {
  std::string text;
  for (auto const& [x, y, difference] : pixels) {
    float const* const a = actual.pixel(x, y);
    float const* const e = expected.pixel(x, y);
    text += fmt::format("  ({}, {}): {:.4f} {:.4f} {:.4f}, expected {:.4f} {:.4f} {:.4f}\n", x, y, a[0], a[1], a[2],
                        e[0], e[1], e[2]);
    if (text.size() > 3000) return text + "  ...\n";
  }
  return text;
}

}  // namespace

void check_picture(Image const& actual, Image const& expected, std::string const& name, double allowed_share) {
  REQUIRE(actual.size() == expected.size());
  auto const differing = differing_pixels(actual, expected);
  double const pixels = double(expected.width()) * expected.height();
  if (double(differing.size()) <= allowed_share * pixels) {
    SUCCEED();
    return;
  }
  leave_picture(actual, name + ".actual.png");
  leave_picture(expected, name + ".expected.png");
  leave_picture(difference_picture(actual, expected), name + ".difference.png");
  FAIL_CHECK(name << ": " << differing.size() << " of " << pixels
                  << " pixels differ (allowed: " << allowed_share * pixels << "); see " << artifact_path("") << "\n"
                  << list(differing, actual, expected));
}

RenderRequest whole_picture(Camera const& camera, Resolution const& resolution) {
  RenderRequest request;
  request.camera = camera;
  request.resolution = resolution;
  request.region = lichtraum::whole_picture(resolution);
  return request;
}

Film film_on(DeviceInfo const& device, Scene const& scene, RenderRequest const& request,
             std::optional<Traversal> traversal) {
  auto const renderer = make_renderer(device, traversal);
  renderer->set_scene(scene);
  Film film;
  REQUIRE(renderer->render(request, film).complete);
  return film;
}

Image render_on(DeviceInfo const& device, Scene const& scene, RenderRequest const& request,
                std::optional<Traversal> traversal, Development const& development) {
  auto const renderer = make_renderer(device, traversal);
  renderer->set_scene(scene);
  Image image;
  REQUIRE(render_image(*renderer, request, image, development).complete);
  return image;
}

Image render_reference(Scene const& scene, RenderRequest const& request, Development const& development) {
  return render_on(reference_device(), scene, request, {}, development);
}

std::vector<DeviceInfo> const& opencl_devices() {
  static std::vector<DeviceInfo> const devices = [] {
    std::vector<DeviceInfo> found = find_devices().devices;
    found.pop_back();  // the reference device
    return found;
  }();
  return devices;
}

std::span<std::pair<char const*, Traversal> const> layouts_of(DeviceInfo const& device) {
  static constexpr std::pair<char const*, Traversal> layouts[] = {
      {"scalar", Traversal::scalar}, {"wide", Traversal::wide}, {"packet", Traversal::packet}};
  return std::span(layouts).first(device.kind == DeviceKind::cpu ? std::size(layouts) : 1);
}

void check_layouts(Scene const& scene, RenderRequest const& request, std::string const& name,
                   Development const& development) {
  Image const expected = render_reference(scene, request, development);
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [layout, traversal] : layouts_of(device)) {
      check_picture(render_on(device, scene, request, traversal, development), expected,
                    fmt::format("{}, device {}, {}", name, device.index, layout));
    }
  }
}

}  // namespace lichtraum::test
