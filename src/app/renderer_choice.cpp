#include "app/renderer_choice.hpp"

#include <fmt/format.h>

namespace lichtraum::app {

std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Console const& console) {
  // The reference tracer needs no OpenCL: do not even look for it.
  if (selector == "reference") return make_renderer(reference_device());

  DeviceList const list = find_devices();
  if (!selector.empty()) {
    for (std::string const& warning : list.warnings) console.detail(warning);
    return make_renderer(select_device(list, selector), traversal);
  }
  for (std::string const& warning : list.warnings) console.warning(warning);
  for (DeviceInfo const& device : list.devices) {
    if (device.kind == DeviceKind::reference) break;
    try {
      return make_renderer(device, traversal);
    } catch (DeviceError const& error) {
      console.warning(fmt::format("the device '{}' cannot be used: {}", device.name, error.what()));
    }
  }
  console.warning(
      "no OpenCL device can be used: the reference tracer draws instead, slowly, and models by whitted "
      "(see lichtraum doctor)");
  return make_renderer(reference_device());
}

}  // namespace lichtraum::app
