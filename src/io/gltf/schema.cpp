#include "io/gltf/schema.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "io/gltf/extensions.hpp"

namespace lichtraum::gltf {
namespace {

using nlohmann::json;

enum class Kind {
  boolean,
  integer,  // 0..2^53
  number,
  string,
  numbers,    // as many as `count`, or any number for 0
  reference,  // index into the root's list `target`
  references,
  named_references,  // an object whose values are references: a primitive's attributes
  target_list,       // a list of those: morph targets
  object,            // of `schema`
  objects,
  strings,
  extensions,  // those the importer knows, unchecked
};

/// What becomes of an element whose property is not as it should be.
enum class Need {
  optional,   // the property is left out
  essential,  // may be absent; if it is there and wrong, the element is replaced
  required,   // absent or wrong: the element is replaced
};

struct Schema;

struct Property {
  std::string_view name;
  Kind kind;
  Need need = Need::optional;
  std::size_t count = 0;
  std::string_view target = {};
  Schema const* schema = nullptr;
};

struct Schema {
  std::span<Property const> properties;
  char const* stub = "{}";  // what replaces an element that makes no sense
};

// The types of section 5 of the glTF 2.0 specification, innermost first.

constexpr Property texture_info_properties[] = {
    {"index", Kind::reference, Need::required, 0, "textures"},
    {"texCoord", Kind::integer},
    {"scale", Kind::number},
    {"strength", Kind::number},
    {"extensions", Kind::extensions},
};
constexpr Schema texture_info{texture_info_properties, nullptr};

constexpr Property metallic_roughness_properties[] = {
    {"baseColorFactor", Kind::numbers, Need::optional, 4},
    {"baseColorTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"metallicFactor", Kind::number},
    {"roughnessFactor", Kind::number},
    {"metallicRoughnessTexture", Kind::object, Need::optional, 0, {}, &texture_info},
};
constexpr Schema metallic_roughness{metallic_roughness_properties};

constexpr Property material_properties[] = {
    {"name", Kind::string},
    {"pbrMetallicRoughness", Kind::object, Need::optional, 0, {}, &metallic_roughness},
    {"normalTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"occlusionTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"emissiveTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"emissiveFactor", Kind::numbers, Need::optional, 3},
    {"alphaMode", Kind::string},
    {"alphaCutoff", Kind::number},
    {"doubleSided", Kind::boolean},
    {"extensions", Kind::extensions},
};
constexpr Schema material{material_properties};

constexpr Property texture_properties[] = {
    {"name", Kind::string},
    {"sampler", Kind::reference, Need::optional, 0, "samplers"},
    {"source", Kind::reference, Need::optional, 0, "images"},
    {"extensions", Kind::extensions},
};
constexpr Schema texture{texture_properties};

constexpr Property sampler_properties[] = {
    {"magFilter", Kind::integer},
    {"minFilter", Kind::integer},
    {"wrapS", Kind::integer},
    {"wrapT", Kind::integer},
};
constexpr Schema sampler{sampler_properties};

constexpr Property image_properties[] = {
    {"name", Kind::string},
    {"uri", Kind::string},
    {"mimeType", Kind::string},
    {"bufferView", Kind::reference, Need::optional, 0, "bufferViews"},
};
constexpr Schema image{image_properties};

constexpr Property buffer_properties[] = {
    {"uri", Kind::string, Need::essential},
    {"byteLength", Kind::integer, Need::required},
    {"extensions", Kind::extensions},
};
constexpr Schema buffer{buffer_properties, R"({"byteLength":0})"};

constexpr Property buffer_view_properties[] = {
    {"buffer", Kind::reference, Need::required, 0, "buffers"},
    {"byteOffset", Kind::integer, Need::essential},
    {"byteLength", Kind::integer, Need::required},
    {"byteStride", Kind::integer, Need::essential},
    {"extensions", Kind::extensions},
};
constexpr Schema buffer_view{buffer_view_properties, R"({"buffer":0,"byteLength":0})"};

constexpr Property sparse_indices_properties[] = {
    {"bufferView", Kind::reference, Need::required, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
    {"componentType", Kind::integer, Need::required},
};
constexpr Schema sparse_indices{sparse_indices_properties, nullptr};

constexpr Property sparse_values_properties[] = {
    {"bufferView", Kind::reference, Need::required, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
};
constexpr Schema sparse_values{sparse_values_properties, nullptr};

constexpr Property sparse_properties[] = {
    {"count", Kind::integer, Need::required},
    {"indices", Kind::object, Need::required, 0, {}, &sparse_indices},
    {"values", Kind::object, Need::required, 0, {}, &sparse_values},
};
constexpr Schema sparse{sparse_properties, nullptr};

constexpr Property accessor_properties[] = {
    {"bufferView", Kind::reference, Need::essential, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
    {"componentType", Kind::integer, Need::required},
    {"normalized", Kind::boolean},
    {"count", Kind::integer, Need::required},
    {"type", Kind::string, Need::required},
    {"sparse", Kind::object, Need::essential, 0, {}, &sparse},
};
constexpr Schema accessor{accessor_properties, R"({"componentType":5126,"count":0,"type":"SCALAR"})"};

constexpr Property primitive_properties[] = {
    {"attributes", Kind::named_references, Need::required, 0, "accessors"},
    {"indices", Kind::reference, Need::essential, 0, "accessors"},
    {"material", Kind::reference, Need::optional, 0, "materials"},
    {"mode", Kind::integer, Need::essential},
    {"targets", Kind::target_list, Need::optional, 0, "accessors"},
    {"extensions", Kind::extensions},
};
constexpr Schema primitive{primitive_properties, R"({"attributes":{}})"};

constexpr Property mesh_properties[] = {
    {"name", Kind::string},
    {"primitives", Kind::objects, Need::required, 0, {}, &primitive},
    {"weights", Kind::numbers},
};
constexpr Schema mesh{mesh_properties, R"({"primitives":[]})"};

constexpr Property node_properties[] = {
    {"name", Kind::string},
    {"mesh", Kind::reference, Need::optional, 0, "meshes"},
    {"camera", Kind::reference, Need::optional, 0, "cameras"},
    {"skin", Kind::reference, Need::optional, 0, "skins"},
    {"children", Kind::references, Need::optional, 0, "nodes"},
    {"matrix", Kind::numbers, Need::optional, 16},
    {"translation", Kind::numbers, Need::optional, 3},
    {"rotation", Kind::numbers, Need::optional, 4},
    {"scale", Kind::numbers, Need::optional, 3},
    {"weights", Kind::numbers},
    {"extensions", Kind::extensions},
};
constexpr Schema node{node_properties};

constexpr Property scene_properties[] = {
    {"name", Kind::string},
    {"nodes", Kind::references, Need::optional, 0, "nodes"},
};
constexpr Schema scene{scene_properties};

constexpr Property perspective_properties[] = {
    {"yfov", Kind::number, Need::required},
    {"znear", Kind::number},
    {"zfar", Kind::number},
    {"aspectRatio", Kind::number},
};
constexpr Schema perspective{perspective_properties, nullptr};

constexpr Property orthographic_properties[] = {
    {"xmag", Kind::number, Need::required},
    {"ymag", Kind::number, Need::required},
    {"znear", Kind::number},
    {"zfar", Kind::number},
};
constexpr Schema orthographic{orthographic_properties, nullptr};

constexpr Property camera_properties[] = {
    {"name", Kind::string},
    {"type", Kind::string, Need::required},
    {"perspective", Kind::object, Need::essential, 0, {}, &perspective},
    {"orthographic", Kind::object, Need::essential, 0, {}, &orthographic},
};
constexpr Schema camera{camera_properties};

constexpr Property skin_properties[] = {
    {"joints", Kind::references, Need::required, 0, "nodes"},
    {"inverseBindMatrices", Kind::reference, Need::optional, 0, "accessors"},
};
constexpr Schema skin{skin_properties, R"({"joints":[]})"};

constexpr Property target_properties[] = {
    {"node", Kind::reference, Need::required, 0, "nodes"},
    {"path", Kind::string, Need::required},
};
constexpr Schema channel_target{target_properties, nullptr};

constexpr Property channel_properties[] = {
    {"sampler", Kind::integer, Need::required},
    {"target", Kind::object, Need::required, 0, {}, &channel_target},
};
constexpr Schema channel{channel_properties, nullptr};

constexpr Property animation_sampler_properties[] = {
    {"input", Kind::reference, Need::required, 0, "accessors"},
    {"output", Kind::reference, Need::required, 0, "accessors"},
    {"interpolation", Kind::string},
};
// No accessor has that number, and the importer looks.
constexpr Schema animation_sampler{animation_sampler_properties, R"({"input":2147483647,"output":2147483647})"};

constexpr Property animation_properties[] = {
    {"name", Kind::string},
    {"channels", Kind::objects, Need::optional, 0, {}, &channel},
    {"samplers", Kind::objects, Need::optional, 0, {}, &animation_sampler},
};
constexpr Schema animation{animation_properties};

constexpr Property asset_properties[] = {
    {"version", Kind::string},
    {"minVersion", Kind::string},
    {"generator", Kind::string},
    {"copyright", Kind::string},
};
constexpr Schema asset{asset_properties};

constexpr Property root_properties[] = {
    {"asset", Kind::object, Need::optional, 0, {}, &asset},
    {"extensionsUsed", Kind::strings},
    {"extensionsRequired", Kind::strings},
    {"buffers", Kind::objects, Need::optional, 0, {}, &buffer},
    {"bufferViews", Kind::objects, Need::optional, 0, {}, &buffer_view},
    {"accessors", Kind::objects, Need::optional, 0, {}, &accessor},
    {"images", Kind::objects, Need::optional, 0, {}, &image},
    {"samplers", Kind::objects, Need::optional, 0, {}, &sampler},
    {"textures", Kind::objects, Need::optional, 0, {}, &texture},
    {"materials", Kind::objects, Need::optional, 0, {}, &material},
    {"meshes", Kind::objects, Need::optional, 0, {}, &mesh},
    {"cameras", Kind::objects, Need::optional, 0, {}, &camera},
    {"skins", Kind::objects, Need::optional, 0, {}, &skin},
    {"nodes", Kind::objects, Need::optional, 0, {}, &node},
    {"scenes", Kind::objects, Need::optional, 0, {}, &scene},
    {"animations", Kind::objects, Need::optional, 0, {}, &animation},
    {"scene", Kind::reference, Need::optional, 0, "scenes"},
    {"extensions", Kind::extensions},
};
constexpr Schema root{root_properties};

/// One thing to visit by name in the messages.
std::string singular(std::string_view list) {
  if (list == "meshes") return "mesh";
  return std::string(list.substr(0, list.size() - 1));
}

std::string shown(json const& value) {
  constexpr std::size_t longest = 40;
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  std::string const text = value.dump();
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

class Conformer {
 public:
  Conformer(json& model, Findings& findings) : model_(model), findings_(findings) {
    for (Property const& property : root_properties) {
      auto const list = model.find(property.name);
      if (list != model.end() && list->is_array()) sizes_.emplace_back(property.name, list->size());
    }
  }

  void run() { conform_object(model_, root); }

 private:
  /// A name or a number on the way from the root to the current value.
  struct Step {
    std::string_view name;
    std::size_t number = 0;
  };
  class Descent {
   public:
    Descent(std::vector<Step>& path, Step step) : path_(path) { path_.push_back(step); }
    ~Descent() { path_.pop_back(); }
    Descent(Descent const&) = delete;
    Descent& operator=(Descent const&) = delete;

   private:
    std::vector<Step>& path_;
  };

  // The depth of these calls is the schema's, not the input's.
  bool conform_object(json& object, Schema const& schema) {
    if (!object.is_object()) return expected("an object", object);
    for (auto it = object.begin(); it != object.end();) {
      it = knows(schema, it.key()) ? std::next(it) : object.erase(it);
    }
    for (Property const& property : schema.properties) {
      Descent const descent(path_, {property.name});
      auto const found = object.find(property.name);
      if (found == object.end()) {
        if (property.need == Need::required) {
          warn("it is missing");
          return false;
        }
      } else if (!conform(*found, property)) {
        if (property.need != Need::optional) return false;
        object.erase(found);
      }
    }
    return true;
  }

  static bool knows(Schema const& schema, std::string_view name) {
    for (Property const& property : schema.properties) {
      if (property.name == name) return true;
    }
    return false;
  }

  bool conform(json& value, Property const& property) {
    switch (property.kind) {
      case Kind::boolean:
        return value.is_boolean() || expected("true or false", value);
      case Kind::integer:
        return conform_integer(value);
      case Kind::number:
        return value.is_number() || expected("a number", value);
      case Kind::string:
        return value.is_string() || expected("a string", value);
      case Kind::numbers:
        return conform_numbers(value, property.count);
      case Kind::reference:
        return conform_reference(value, property.target);
      case Kind::references:
        return conform_list(value, [&](json& v) { return conform_reference(v, property.target); });
      case Kind::named_references:
        return conform_named_references(value, property.target);
      case Kind::target_list:
        return conform_list(value, [&](json& v) { return conform_named_references(v, property.target); });
      case Kind::object:
        return conform_object(value, *property.schema);
      case Kind::objects:
        return conform_objects(value, *property.schema);
      case Kind::strings:
        return conform_list(value, [&](json& v) { return v.is_string() || expected("a string", v); });
      case Kind::extensions:
        return conform_extensions(value);
    }
    return false;
  }

  bool conform_integer(json& value) {
    constexpr double largest = 9007199254740992.0;  // 2^53: the last that a double holds exactly
    if (value.is_number_float()) {                  // JSON knows no integers: 1.0 is one
      double const number = value.get<double>();
      if (number >= 0 && number <= largest && std::trunc(number) == number) value = std::uint64_t(number);
    }
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= std::uint64_t(largest)) return true;
    return expected("a non-negative integer", value);
  }

  bool conform_numbers(json& value, std::size_t count) {
    if (!value.is_array() || (count != 0 && value.size() != count)) {
      return expected(count != 0 ? fmt::format("an array of {} numbers", count) : "an array of numbers", value);
    }
    for (json const& number : value) {
      if (!number.is_number()) return expected("numbers only", number);
    }
    return true;
  }

  bool conform_reference(json& value, std::string_view target) {
    if (!conform_integer(value)) return false;
    std::size_t const size = size_of(target);
    if (value.get<std::uint64_t>() < size) return true;
    warn(fmt::format("{} {} is out of range ({})", singular(target), value.get<std::uint64_t>(), size));
    return false;
  }

  bool conform_named_references(json& value, std::string_view target) {
    if (!value.is_object()) return expected("an object", value);
    for (auto it = value.begin(); it != value.end();) {
      Descent const descent(path_, {it.key()});
      it = conform_reference(it.value(), target) ? std::next(it) : value.erase(it);
    }
    return true;
  }

  /// Leaves out the elements that do not pass.
  template <class Passes>
  bool conform_list(json& list, Passes const& passes) {
    if (!list.is_array()) return expected("an array", list);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      Descent const descent(path_, {{}, i});
      if (!passes(list[i])) continue;
      if (kept != i) list[kept] = std::move(list[i]);
      ++kept;
    }
    list.erase(list.begin() + std::ptrdiff_t(kept), list.end());
    return true;
  }

  bool conform_objects(json& list, Schema const& schema) {
    if (!schema.stub) return conform_list(list, [&](json& v) { return conform_object(v, schema); });
    return conform_list(list, [&](json& v) {
      if (!conform_object(v, schema)) v = json::parse(schema.stub);
      return true;
    });
  }

  bool conform_extensions(json& value) {
    if (!value.is_object()) return expected("an object", value);
    for (auto it = value.begin(); it != value.end();) {
      it = it.value().is_object() && is_supported_extension(it.key()) ? std::next(it) : value.erase(it);
    }
    return true;
  }

  std::size_t size_of(std::string_view list) const {
    for (auto const& [name, size] : sizes_) {
      if (name == list) return size;
    }
    return 0;
  }

  bool expected(std::string_view what, json const& found) {
    warn(fmt::format("expected {}, found {}", what, shown(found)));
    return false;
  }

  void warn(std::string_view message) {
    std::string pointer;
    for (Step const& step : path_) {
      pointer += step.name.data() ? fmt::format("/{}", step.name) : fmt::format("/{}", step.number);
    }
    findings_.warn(pointer, message);
  }

  json& model_;
  Findings& findings_;
  std::vector<std::pair<std::string_view, std::size_t>> sizes_;
  std::vector<Step> path_;
};

void check_version(json const& model, Findings& findings) {
  auto const found = model.find("asset");
  auto const version_of = [&](char const* name) -> std::string {
    if (found == model.end() || !found->is_object()) return {};
    auto const version = found->find(name);
    return version != found->end() && version->is_string() ? version->get<std::string>() : std::string();
  };
  std::string const needed = version_of("minVersion");
  std::string const version = needed.empty() ? version_of("version") : needed;
  if (version.empty()) {
    findings.warn("/asset/version", "it is missing; the model is read as glTF 2.0");
  } else if (version.substr(0, 2) != "2." && version != "2") {
    findings.fail("/asset/version", fmt::format("this is glTF {}; only glTF 2 is supported", version));
  }
}

}  // namespace

void conform_to_schema(json& model, Findings& findings) {
  if (!model.is_object()) findings.fail("", fmt::format("expected a JSON object, found {}", shown(model)));
  check_version(model, findings);
  Conformer(model, findings).run();
}

}  // namespace lichtraum::gltf
