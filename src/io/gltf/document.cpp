#include "io/gltf/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/counted.hpp"
#include "core/percent.hpp"
#include "io/another_file.hpp"
#include "io/gltf/container.hpp"
#include "io/gltf/nodes.hpp"
#include "io/gltf/schema.hpp"
#include "io/gltf/uri.hpp"

namespace lichtraum::gltf {
namespace {

using nlohmann::json;

/// glTF itself nests ten levels; tinygltf recurses over extensions.
constexpr std::size_t max_nesting = 256;

/// Fails when arrays and objects nest too deep. One look at the bytes, before anything is built of them.
void check_nesting(std::string_view text, Findings& findings) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > max_nesting)
        findings.fail_at(DiagnosticCode::not_gltf, text, i,
                         fmt::format("JSON nests deeper than {} levels", max_nesting));
    } else if (c == ']' || c == '}') {
      if (depth > 0) --depth;
    }
  }
}

/// The text with the largest double for all numbers beyond it, which JSON allows and the parser does not: exporters
/// write them for boxes around nothing. Counts them.
std::string without_overflow(std::string_view text, std::size_t& count) {
  std::string result;
  bool is_string = false;
  for (std::size_t i = 0; i < text.size();) {
    char const c = text[i];
    bool const is_number = !is_string && (c == '-' || (c >= '0' && c <= '9'));
    if (!is_number) {
      if (is_string && c == '\\' && i + 1 < text.size()) result += text[i++];
      if (c == '"') is_string = !is_string;
      result += text[i++];
      continue;
    }
    std::size_t const end = std::min(text.find_first_not_of("+-.0123456789Ee", i), text.size());
    std::string_view const word = text.substr(i, end - i);
    double value = 1;
    auto const [last, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    bool const is_small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    if (error == std::errc::result_out_of_range && last == word.data() + word.size() && !is_small) {
      ++count;
      result += c == '-' ? "-1.7976931348623157e308" : "1.7976931348623157e308";
    } else {
      result += word;
    }
    i = end;
  }
  return result;
}

json parse_json(std::string_view text, Findings& findings) {
  check_nesting(text, findings);
  try {
    try {
      return json::parse(text);
    } catch (json::out_of_range const&) {
      std::size_t count = 0;
      json result = json::parse(without_overflow(text, count));
      findings.warn(
          DiagnosticCode::gltf_property, "",
          fmt::format("{} beyond 1.8e308, the largest that can be read: read as that", counted(count, "number")));
      return result;
    }
  } catch (json::parse_error const& error) {
    if (auto const other = recognise_another_file(text, "a glTF model")) {
      findings.fail_at(DiagnosticCode::not_gltf, text, 0,
                       fmt::format("{}{}{}", other->message, other->hint.empty() ? "" : ": ", other->hint));
    }
    // "[json.exception.parse_error.101] parse error at line 1, column 8: what": the place is told separately.
    std::string const message = error.what();
    std::size_t const colon = message.find(": ");
    findings.fail_at(DiagnosticCode::not_gltf, text, error.byte > 0 ? error.byte - 1 : 0,
                     "not JSON: " + (colon == std::string::npos ? message : message.substr(colon + 2)));
  } catch (json::exception const& error) {
    findings.fail(DiagnosticCode::not_gltf, "", fmt::format("not JSON: {}", error.what()));
  }
}

std::optional<std::string> take_string(json& object, char const* name) {
  auto const found = object.find(name);
  if (found == object.end()) return std::nullopt;
  return std::move(found->get_ref<std::string&>());
}

void take_buffers(json& model, Document& document) {
  auto const list = model.find("buffers");
  if (list == model.end()) return;
  for (json& buffer : *list) {
    document.buffers.push_back({take_string(buffer, "uri"), buffer["byteLength"].get<std::uint64_t>()});
  }
  model.erase(list);
}

void take_images(json& model, Document& document) {
  auto const list = model.find("images");
  if (list == model.end()) return;
  for (json& image : *list) {
    auto uri = take_string(image, "uri");
    auto name = take_string(image, "name").value_or("");
    if (name.empty() && uri && !is_data_uri(*uri)) name = decode_percent(*uri);
    document.images.push_back({std::move(name), std::move(uri), image.value("bufferView", -1)});
  }
  model.erase(list);
}

/// Leaves out what KHR_animation_pointer moves: no node, so the specification's own channels would be incomplete.
void skip_pointer_channels(json& model, Findings& findings) {
  auto const animations = model.find("animations");
  if (animations == model.end() || !animations->is_array()) return;
  auto const is_pointer = [](json const& channel) {
    if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object()) return false;
    json const& target = channel["target"];
    return target.contains("path") && target["path"] == "pointer";
  };
  for (std::size_t i = 0; i < animations->size(); ++i) {
    json& animation = (*animations)[i];
    if (!animation.is_object() || !animation.contains("channels") || !animation["channels"].is_array()) continue;
    auto& channels = animation["channels"].get_ref<json::array_t&>();
    std::size_t const skipped = std::erase_if(channels, is_pointer);
    if (skipped == 0) continue;
    findings.warn(
        DiagnosticCode::unsupported_extension, fmt::format("/animations/{}/channels", i),
        fmt::format("{} channels need KHR_animation_pointer, which is not supported: they have no effect", skipped));
  }
}

/// Of each view; 0: its elements lie side by side. tinygltf refuses a whole model for strides that the specification
/// does not allow, which say clearly enough where the elements are.
std::vector<std::size_t> take_strides(json& model, Findings& findings) {
  auto& views = model["bufferViews"];
  if (views.is_null()) views = json::array();
  std::vector<std::size_t> strides(views.size(), 0);
  for (std::size_t i = 0; i < views.size(); ++i) {
    auto const stride = views[i].find("byteStride");
    if (stride == views[i].end()) continue;
    strides[i] = stride->get<std::size_t>();
    views[i].erase(stride);
    if (strides[i] <= 252 && strides[i] % 4 == 0) continue;
    findings.warn(DiagnosticCode::gltf_property, fmt::format("/bufferViews/{}/byteStride", i),
                  fmt::format("expected a multiple of 4 in 4..252, found {}", strides[i]));
  }
  return strides;
}

/// tinygltf refuses a whole model for these.
void soothe_tinygltf(json& model, Findings& findings) {
  auto const accessors = model.find("accessors");
  for (std::size_t i = 0; accessors != model.end() && i < accessors->size(); ++i) {
    json& accessor = (*accessors)[i];
    constexpr std::string_view types[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    auto const type = accessor["type"].get<std::string>();
    auto const component = accessor["componentType"].get<std::uint64_t>();
    bool const is_known = std::find(std::begin(types), std::end(types), type) != std::end(types);
    if (is_known && component >= TINYGLTF_COMPONENT_TYPE_BYTE && component <= TINYGLTF_COMPONENT_TYPE_DOUBLE) continue;
    findings.warn(DiagnosticCode::gltf_property, fmt::format("/accessors/{}", i),
                  fmt::format("glTF has no type '{}' of component type {}", type, component));
    accessor = {{"componentType", TINYGLTF_COMPONENT_TYPE_FLOAT}, {"count", 0}, {"type", "SCALAR"}};
  }
  auto const cameras = model.find("cameras");
  if (cameras == model.end()) return;
  for (json& camera : *cameras) {
    bool const is_complete = (camera.value("type", "") == "perspective" && camera.contains("perspective")) ||
                             (camera.value("type", "") == "orthographic" && camera.contains("orthographic"));
    if (!is_complete) camera = {{"type", "perspective"}, {"perspective", {{"yfov", 0}}}};
    json& lens = camera[camera["type"].get<std::string>()];
    lens.emplace("znear", 0);
    lens.emplace("zfar", 0);
  }
}

void soothe_lights(json& model, Findings& findings) {
  json* lights = nullptr;
  auto const extensions = model.find("extensions");
  if (extensions != model.end() && extensions->contains("KHR_lights_punctual")) {
    json& extension = (*extensions)["KHR_lights_punctual"];
    if (extension.contains("lights") && extension["lights"].is_array()) lights = &extension["lights"];
  }
  for (std::size_t i = 0; lights && i < lights->size(); ++i) {
    json& light = (*lights)[i];
    bool const has_type = light.is_object() && light.contains("type") && light["type"].is_string();
    if (!has_type) {
      findings.warn(DiagnosticCode::gltf_property, fmt::format("/extensions/KHR_lights_punctual/lights/{}/type", i),
                    "it is missing");
      light = {{"type", "none"}};
    } else if (light["type"] == "spot" && (!light.contains("spot") || !light["spot"].is_object())) {
      light["spot"] = json::object();
    }
  }
}

/// tinygltf insists that indices have a buffer view; compressed and sparse ones need none. So accessors without one get
/// a view of their own for the time of its work: the last.
std::size_t add_absent_view(json& model) {
  json& views = model["bufferViews"];
  std::size_t const absent = views.size();
  views.push_back({{"buffer", 0}, {"byteLength", 0}});
  auto const accessors = model.find("accessors");
  if (accessors == model.end()) return absent;
  for (json& accessor : *accessors) accessor.emplace("bufferView", absent);
  return absent;
}

void remove_absent_view(tinygltf::Model& model, std::size_t absent) {
  model.bufferViews.resize(absent);
  for (auto& accessor : model.accessors) {
    if (accessor.bufferView == int(absent)) accessor.bufferView = -1;
  }
}

}  // namespace

void parse_document(Document& document, Findings& findings) {
  Container const container = open_container(document.bytes, findings);
  document.binary = container.binary;
  document.is_glb = container.is_glb;

  json json_model = parse_json(container.json, findings);
  if (json_model.is_object()) skip_pointer_channels(json_model, findings);
  conform_to_schema(json_model, findings);
  take_buffers(json_model, document);
  take_images(json_model, document);
  std::vector<tinygltf::Node> nodes = take_nodes(json_model);
  std::vector<std::size_t> const strides = take_strides(json_model, findings);
  soothe_tinygltf(json_model, findings);
  soothe_lights(json_model, findings);
  std::size_t const absent_view = add_absent_view(json_model);

  std::string const text = json_model.dump();
  if (text.size() > std::numeric_limits<unsigned>::max())
    findings.fail(DiagnosticCode::not_gltf, "", "more than 4 GB of JSON");
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  if (!parser.LoadASCIIFromString(&document.model, &error, &warning, text.data(), unsigned(text.size()), "",
                                  tinygltf::NO_REQUIRE)) {
    findings.fail(DiagnosticCode::not_gltf, "", error);
  }
  remove_absent_view(document.model, absent_view);
  for (std::size_t i = 0; i < strides.size(); ++i) document.model.bufferViews[i].byteStride = strides[i];
  document.model.nodes = std::move(nodes);
}

}  // namespace lichtraum::gltf
