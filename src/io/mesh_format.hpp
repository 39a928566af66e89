#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/model.hpp"

namespace lichtraum {

/// One row of the table of model formats.
struct MeshFormat {
  std::string_view name;                     ///< "glTF"
  std::vector<std::string_view> extensions;  ///< lower case with the dot: {".gltf", ".glb"}
  /// Throws Error (SceneError for a faulty model).
  Model (*import)(std::filesystem::path const& path, ModelOptions const& options);
  /// The same from the bytes of a file that lies in no folder; `name` stands for it in messages.
  Model (*import_bytes)(std::string bytes, std::string const& name, ModelOptions const& options);
  /// Whether bytes are of this format, if they tell; null where they never do.
  bool (*recognise)(std::string_view bytes);
};

/// Every model format that this build reads.
std::span<MeshFormat const> mesh_formats();

/// The format for a file of that name (extension in any case), or nullptr.
MeshFormat const* find_mesh_format(std::span<MeshFormat const> formats, std::filesystem::path const& path);

}  // namespace lichtraum
