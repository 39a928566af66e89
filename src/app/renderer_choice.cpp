#include "app/renderer_choice.hpp"

#include <fmt/format.h>

namespace lichtraum::app {

std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Tell const& warn, Tell const& note) {
  // The reference tracer needs no OpenCL: do not even look for it.
  if (selector == "reference") return make_renderer(reference_device());

  DeviceList const list = find_devices();
  if (!selector.empty()) {
    for (std::string const& warning : list.warnings) note(warning);
    return make_renderer(select_device(list, selector), traversal);
  }
  for (std::string const& warning : list.warnings) warn(warning);
  for (DeviceInfo const& device : list.devices) {
    if (device.kind == DeviceKind::reference) break;
    try {
      return make_renderer(device, traversal);
    } catch (DeviceError const& error) {
      warn(fmt::format("the device '{}' cannot be used: {}", device.name, error.what()));
    }
  }
  warn(
      "no OpenCL device can be used: the reference tracer draws instead, slowly, and models by whitted "
      "(see lichtraum doctor)");
  return make_renderer(reference_device());
}

std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Console const& console) {
  return choose_renderer(
      selector, traversal, [&](std::string const& text) { console.warning(text); },
      [&](std::string const& text) { console.detail(text); });
}

}  // namespace lichtraum::app
