#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/gltf.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

namespace lichtraum::testing {

/// What a writer's model is imported as.
inline Model import_model(GltfWriter const& writer, ModelOptions const& options = {}, char const* name = "model.gltf") {
  TemporaryFolder const folder;
  return import_gltf(folder.write(name, std::string_view(name).ends_with(".glb") ? writer.glb() : writer.text()),
                     options);
}

/// Its warnings, a line each.
inline std::string messages(Model const& model) { return test::message_lines(model.diagnostics); }

/// The corners of a triangle, for models that need no other.
inline std::vector<float> const triangle_positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};

}  // namespace lichtraum::testing
