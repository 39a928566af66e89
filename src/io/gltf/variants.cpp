#include "io/gltf/variants.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "io/gltf/values.hpp"

namespace lichtraum::gltf {
namespace {

constexpr char const* extension_name = "KHR_materials_variants";

/// The elements of an array in an object; none where there is no such thing.
std::vector<tinygltf::Value> elements_of(tinygltf::Value const& object, char const* name) {
  if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsArray()) return {};
  return object.Get(name).Get<tinygltf::Value::Array>();
}

/// The material that `mappings` have for the variant.
std::optional<int> material_of(std::vector<tinygltf::Value> const& mappings, std::size_t variant,
                               std::size_t material_count) {
  for (auto const& mapping : mappings) {
    auto const material = index_of(mapping, "material", material_count);
    if (!material) continue;
    for (auto const& element : elements_of(mapping, "variants")) {
      if (integer_in(element) == variant) return material;
    }
  }
  return std::nullopt;
}

/// What is wrong with `value` as an index of a list of `size` elements called `kind`; empty: nothing.
std::string fault_of(tinygltf::Value const& value, char const* kind, std::size_t size) {
  auto const index = integer_in(value);
  if (!index) return "expected a non-negative integer";
  return *index < size ? "" : fmt::format("{} {} is out of range ({})", kind, *index, size);
}

class VariantCheck {
 public:
  VariantCheck(tinygltf::Model const& model, Findings& findings)
      : findings_(findings), material_count_(model.materials.size()), variant_count_(variant_names(model).size()) {}

  void check(std::vector<tinygltf::Value> const& mappings, std::string const& pointer) {
    std::map<std::uint64_t, std::size_t> mapping_of_variant;
    for (std::size_t i = 0; i < mappings.size(); ++i) {
      std::string const place = fmt::format("{}/{}", pointer, i);
      if (!has_material(mappings[i], place + "/material")) continue;
      auto const variants = elements_of(mappings[i], "variants");
      for (std::size_t k = 0; k < variants.size(); ++k) {
        std::string fault = fault_of(variants[k], "variant", variant_count_);
        if (fault.empty()) {
          std::uint64_t const variant = *integer_in(variants[k]);
          auto const [known, is_new] = mapping_of_variant.emplace(variant, i);
          if (is_new || known->second == i) continue;
          fault = fmt::format("mapping {} has variant {} already, and counts", known->second, variant);
        }
        warn(fmt::format("{}/variants/{}", place, k), fault);
      }
    }
  }

 private:
  bool has_material(tinygltf::Value const& mapping, std::string const& pointer) {
    bool const is_there = mapping.IsObject() && mapping.Has("material");
    std::string const fault =
        is_there ? fault_of(mapping.Get("material"), "material", material_count_) : "it is missing";
    if (!fault.empty()) warn(pointer, fault);
    return fault.empty();
  }

  void warn(std::string const& pointer, std::string const& fault) {
    findings_.warn(DiagnosticCode::gltf_property, pointer, fault);
  }

  Findings& findings_;
  std::size_t material_count_;
  std::size_t variant_count_;
};

}  // namespace

std::vector<std::string> variant_names(tinygltf::Model const& model) {
  std::vector<std::string> names;
  if (auto const* e = find_extension(model.extensions, extension_name)) {
    for (auto const& variant : elements_of(*e, "variants")) names.push_back(string_of(variant, "name"));
  }
  return names;
}

void check_variants(tinygltf::Model const& model, Findings& findings) {
  VariantCheck check(model, findings);
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    auto const& primitives = model.meshes[i].primitives;
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      if (auto const* e = find_extension(primitives[k].extensions, extension_name)) {
        check.check(elements_of(*e, "mappings"),
                    fmt::format("/meshes/{}/primitives/{}/extensions/{}/mappings", i, k, extension_name));
      }
    }
  }
}

void apply_variant(tinygltf::Model& model, std::size_t variant) {
  for (auto& mesh : model.meshes) {
    for (auto& primitive : mesh.primitives) {
      auto const* e = find_extension(primitive.extensions, extension_name);
      if (!e) continue;
      auto const material = material_of(elements_of(*e, "mappings"), variant, model.materials.size());
      if (material) primitive.material = *material;
    }
  }
}

}  // namespace lichtraum::gltf
