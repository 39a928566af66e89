#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/shape.hpp"

namespace lichtraum {

/// One row of the table of model formats that a scene may name as a mesh.
struct MeshFormat {
  std::string_view name;                     ///< "glTF"
  std::vector<std::string_view> extensions;  ///< lower case with the dot: {".gltf", ".glb"}
  /// Reads the model as one shape called `name`. `material` replaces the model's own; it may be null.
  /// Throws Error (SceneError for a faulty model).
  std::shared_ptr<Shape> (*load)(std::filesystem::path const& path, std::string name,
                                 std::shared_ptr<Material const> material);
};

/// Every model format that this build reads.
std::span<MeshFormat const> mesh_formats();

/// The format for a file of that name (extension in any case), or nullptr.
MeshFormat const* find_mesh_format(std::span<MeshFormat const> formats, std::filesystem::path const& path);

}  // namespace lichtraum
