#include "app/report_json.hpp"

#include <nlohmann/json.hpp>

#include "app/device_text.hpp"

namespace lichtraum::app {
namespace {

using Json = nlohmann::ordered_json;

/// What counts from 1, and is 0 where there is none.
Json count_json(std::size_t count) { return count > 0 ? Json(count) : Json(); }

}  // namespace

Json json_of(std::vector<Diagnostic> const& diagnostics) {
  Json list = Json::array();
  for (Diagnostic const& d : diagnostics) {
    Json const notes = d.hint.empty() ? Json::array() : Json::array({d.hint});
    std::string_view const code = code_text(d.code);
    list.push_back({{"severity", severity_text(d.severity)},
                    {"code", code.empty() ? Json() : Json(code)},
                    {"message", d.message},
                    {"file", d.location.file.empty() ? Json() : Json(d.location.file)},
                    {"line", count_json(d.location.line)},
                    {"column", count_json(d.location.column)},
                    {"length", d.location.column > 0 ? Json(d.length) : Json()},
                    {"notes", notes}});
  }
  return list;
}

Json json_of(DeviceInfo const& device) {
  return {
      {"index", device.index}, {"kind", kind_name(device.kind)}, {"name", device.name}, {"platform", device.platform}};
}

std::string printed(Json const& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace lichtraum::app
