#include "io/gltf/variants.hpp"

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
    for (auto const& element : elements_of(mapping, "variants")) {
      if (element.IsNumber() && element.GetNumberAsDouble() == double(variant)) {
        return index_of(mapping, "material", material_count);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> variant_names(tinygltf::Model const& model) {
  std::vector<std::string> names;
  if (auto const* e = find_extension(model.extensions, extension_name)) {
    for (auto const& variant : elements_of(*e, "variants")) names.push_back(string_of(variant, "name"));
  }
  return names;
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
