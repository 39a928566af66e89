#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace lichtraum::gltf {

/// The names of the model's variants (KHR_materials_variants), by their numbers; a faulty one's is empty.
std::vector<std::string> variant_names(tinygltf::Model const& model);

/// Gives the primitives that say so the material that they have in that variant.
void apply_variant(tinygltf::Model& model, std::size_t variant);

}  // namespace lichtraum::gltf
