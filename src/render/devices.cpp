#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "cl/child_probe.hpp"
#include "cl/opencl_devices.hpp"
#include "cl/pocl_cache.hpp"
#include "core/ascii.hpp"
#include "lichtraum/device.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/renderer.hpp"
#include "reference/renderer.hpp"
#include "render/opencl_renderer.hpp"

namespace lichtraum {
namespace {

constexpr char const* install_hint =
    "install a platform: on Debian and Ubuntu the package pocl-opencl-icd, for a GPU its "
    "vendor's OpenCL driver";

int rank(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::gpu:
      return 0;
    case DeviceKind::cpu:
      return 1;
    case DeviceKind::accelerator:
      return 2;
    case DeviceKind::reference:
      return 3;
  }
  return 4;
}

Traversal default_traversal(DeviceKind kind) { return kind == DeviceKind::cpu ? Traversal::packet : Traversal::scalar; }

bool matches(DeviceInfo const& device, std::string const& selector) {
  if (selector == "cpu") return device.kind == DeviceKind::cpu;
  if (selector == "gpu") return device.kind == DeviceKind::gpu;
  if (selector == "reference") return device.kind == DeviceKind::reference;
  int index = 0;
  char const* const end = selector.data() + selector.size();
  if (auto const [stop, error] = std::from_chars(selector.data(), end, index); error == std::errc() && stop == end) {
    return device.index == index;
  }
  return to_lower_ascii(device.name).find(selector) != std::string::npos;
}

}  // namespace

DeviceList find_devices(ProbeInChild probe) {
  DeviceList list;
  auto const add_opencl_devices = [&] {
    std::optional<std::string> const no_cache = ensure_pocl_cache();
    if (probe == ProbeInChild::always || opencl_may_abort()) {
      if (auto const reason = probe_opencl_in_child()) {
        list.warnings.push_back(
            fmt::format("OpenCL cannot be used here: it was tried in a child process, and {}", *reason));
        return;
      }
    }
    for (OpenClDevice& found : find_opencl_devices(list.warnings)) list.devices.push_back(std::move(found.info));
    if (list.devices.empty())
      list.warnings.push_back(fmt::format("no OpenCL device was found: {}", no_cache.value_or(install_hint)));
  };
  add_opencl_devices();
  std::stable_sort(list.devices.begin(), list.devices.end(),
                   [](auto const& a, auto const& b) { return rank(a.kind) < rank(b.kind); });
  list.devices.push_back(reference_device());
  for (std::size_t i = 0; i < list.devices.size(); ++i) list.devices[i].index = int(i);
  return list;
}

DeviceInfo const& select_device(DeviceList const& list, std::string_view selector) {
  if (selector.empty() && !list.devices.empty()) return list.devices.front();
  auto const lower = to_lower_ascii(selector);
  std::string known;
  for (DeviceInfo const& device : list.devices) {
    if (matches(device, lower)) return device;
    known += fmt::format("\n  {}  {}", device.index, device.name);
  }
  throw Error(ErrorKind::no_device,
              fmt::format("there is no device '{}'; select one by its index, a part of its name, cpu, gpu "
                          "or reference:{}",
                          selector, known));
}

std::unique_ptr<Renderer> make_renderer(DeviceInfo const& device, std::optional<Traversal> traversal) {
  if (device.kind == DeviceKind::reference) return make_reference_renderer(device);
  return make_opencl_renderer(device, traversal.value_or(default_traversal(device.kind)));
}

}  // namespace lichtraum
