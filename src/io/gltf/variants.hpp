#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "io/gltf/findings.hpp"

namespace lichtraum::gltf {

/// The names of the model's variants (KHR_materials_variants), by their numbers; a faulty one's is empty.
std::vector<std::string> variant_names(tinygltf::Model const& model);

/// Warns of mappings whose variants or materials do not exist, and of variants that a primitive maps twice.
void check_variants(tinygltf::Model const& model, Findings& findings);

/// Gives the primitives that say so the material that they have in that variant: of mappings whose material exists, the
/// first counts.
void apply_variant(tinygltf::Model& model, std::size_t variant);

}  // namespace lichtraum::gltf
