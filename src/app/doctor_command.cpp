#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/device_text.hpp"
#include "app/exit_code.hpp"
#include "app/test_scene.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* doctor_description =
    "Draws a small known scene on every OpenCL device and compares it with the\n"
    "reference tracer, which is plain C++. Says what to install when something is\n"
    "missing. Exit status 0 when at least one device draws correctly, else 69.";

constexpr char const* doctor_examples = "  lichtraum doctor\n  lichtraum doctor -v\n";

// On 99.9 % of all pixels a device may be off by one step of an 8 bit picture: its floats have 24 bits, the reference
// has 53. The others lie on edges, where a ray may meet one shape or its neighbour.
constexpr float tolerance = 1.0f / 255;
constexpr double tolerated_share = 0.001;

struct Finding {
  bool is_good = false;
  std::string text;
};

std::size_t count_differing_pixels(Image const& a, Image const& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.data().size(); i += 3) {
    bool differs = false;
    for (std::size_t c = i; c < i + 3; ++c) differs |= !(std::abs(a.data()[c] - b.data()[c]) <= tolerance);
    count += differs;
  }
  return count;
}

Image draw(Renderer& renderer, TestScene const& test) {
  renderer.set_scene(test.scene);
  Image image;
  render_image(renderer, test.request, image);
  return image;
}

Finding examine(DeviceInfo const& device, TestScene const& test, Image const& expected) {
  try {
    auto const start = std::chrono::steady_clock::now();
    Image const image = draw(*make_renderer(device), test);
    double const ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    std::size_t const differing = count_differing_pixels(image, expected);
    std::size_t const pixels = expected.data().size() / 3;
    bool const is_good = double(differing) <= tolerated_share * double(pixels);
    return {is_good, fmt::format("{}: {} of {} pixels differ from the reference, {:.0f} ms in total",
                                 is_good ? "good" : "WRONG", differing, pixels, ms)};
  } catch (Error const& error) {
    return {false, fmt::format("FAILED: {}", error.what())};
  }
}

}  // namespace

int doctor_command(Arguments const& arguments, Console& console) {
  auto const parser = make_parser("doctor", doctor_description, doctor_examples);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;

  TestScene const test = make_test_scene();
  Image const expected = draw(*make_renderer(reference_device()), test);

  DeviceList const list = find_devices(ProbeInChild::always);
  std::string text = fmt::format("lichtraum {}\n", LICHTRAUM_VERSION);
  bool has_good_device = false;
  for (DeviceInfo const& device : list.devices) {
    if (device.kind == DeviceKind::reference) continue;
    Finding const finding = examine(device, test, expected);
    has_good_device |= finding.is_good;
    text += fmt::format("{}  {} ({})\n   {}\n", device.index, device.name, kind_name(device.kind), finding.text);
    if (console.is_verbose()) {
      text += fmt::format("   {} {}, {}, driver {}\n", device.platform, device.platform_version, device.device_version,
                          device.driver_version);
    }
  }
  Denoiser denoiser(filter_noise);
  text += fmt::format("denoising (--denoise on): {}\n", denoiser.name(Denoising::on));
  write_standard_output(text);
  if (auto const note = denoiser.take_note(); !note.empty()) console.detail(note);
  for (std::string const& warning : list.warnings) console.warning(warning);
  if (has_good_device) {
    write_standard_output("all is well: lichtraum render uses the first good device\n");
    return 0;
  }
  console.error(
      "no OpenCL device draws correctly. Debian and Ubuntu have one for every processor: "
      "apt install pocl-opencl-icd ocl-icd-libopencl1; a graphics card needs its maker's OpenCL driver. Until "
      "then lichtraum render --device reference draws without OpenCL, slowly");
  return exit_code(ErrorKind::no_device);
}

}  // namespace lichtraum::app
