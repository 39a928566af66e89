#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/device_text.hpp"
#include "app/report_json.hpp"
#include "lichtraum/device.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* devices_description =
    "Lists the devices that can draw, best first: index, name or kind is what\n"
    "render --device takes.";

constexpr char const* devices_examples =
    "  lichtraum devices\n"
    "  lichtraum devices --json\n";

std::string to_text(DeviceList const& list) {
  std::string text;
  for (DeviceInfo const& device : list.devices) {
    text += fmt::format("{}  {} ({})\n", device.index, device.name, kind_name(device.kind));
    auto const line = [&](std::string_view label, std::string const& value) {
      if (!value.empty()) text += fmt::format("   {:<15}{}\n", label, value);
    };
    line("platform", fmt::format("{} {}", device.platform, device.platform_version));
    line("device version", device.device_version);
    line("driver version", device.driver_version);
    line("compute units", std::to_string(device.compute_units));
    if (device.global_memory_bytes > 0) {
      line("memory", fmt::format("{:.1f} GiB, at most {:.1f} GiB in one buffer", gibibytes(device.global_memory_bytes),
                                 gibibytes(device.max_allocation_bytes)));
    }
  }
  return text;
}

std::string to_json(DeviceList const& list) {
  using Json = nlohmann::ordered_json;
  Json devices = Json::array();
  for (DeviceInfo const& device : list.devices) {
    devices.push_back({{"index", device.index},
                       {"kind", kind_name(device.kind)},
                       {"name", device.name},
                       {"platform", device.platform},
                       {"platform_version", device.platform_version},
                       {"device_version", device.device_version},
                       {"driver_version", device.driver_version},
                       {"compute_units", device.compute_units},
                       {"global_memory_bytes", device.global_memory_bytes},
                       {"max_allocation_bytes", device.max_allocation_bytes}});
  }
  return printed({{"devices", devices}, {"warnings", list.warnings}});
}

}  // namespace

int devices_command(Arguments const& arguments, Console& console) {
  bool json = false;
  auto const parser = make_parser("devices", devices_description, devices_examples);
  parser->add_flag("--json", json, "Print JSON")->group("Output");
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;

  DeviceList const list = find_devices(ProbeInChild::always);
  for (std::string const& warning : list.warnings) console.warning(warning);
  write_standard_output(json ? to_json(list) : to_text(list));
  return 0;
}

}  // namespace lichtraum::app
