#include "io/gltf/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/gltf/extensions.hpp"
#include "io/gltf/schema_tables.hpp"

namespace lichtraum::gltf {
namespace {

using nlohmann::json;

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
    for (Property const& property : root_schema().properties) {
      auto const list = model.find(property.name);
      if (list != model.end() && list->is_array()) sizes_.emplace_back(property.name, list->size());
    }
  }

  void run() { conform_object(model_, root_schema()); }

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
    findings_.warn(DiagnosticCode::gltf_property, pointer, message);
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
    findings.warn(DiagnosticCode::gltf_property, "/asset/version", "it is missing; the model is read as glTF 2.0");
  } else if (version.substr(0, 2) != "2." && version != "2") {
    findings.fail(DiagnosticCode::gltf_version, "/asset/version",
                  fmt::format("this is glTF {}; only glTF 2 is supported", version));
  }
}

}  // namespace

void conform_to_schema(json& model, Findings& findings) {
  if (!model.is_object())
    findings.fail(DiagnosticCode::not_gltf, "", fmt::format("expected a JSON object, found {}", shown(model)));
  check_version(model, findings);
  Conformer(model, findings).run();
}

}  // namespace lichtraum::gltf
