#pragma once

#include <memory>
#include <optional>

#include "io/ply/ply_data.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::ply {

/// The triangles that show one picture, or none; or lines; or points.
struct Part {
  MeshGeometry geometry;
  std::shared_ptr<TextureImage const> picture;  ///< null: none
};

/// Divides what was read among the pictures of the header, which are read unless the options bring a material. What
/// cannot be used of them is a warning. The indices are not checked yet.
std::vector<Part> divide(Data data, Header const& header, std::optional<std::filesystem::path> const& folder,
                         ModelOptions const& options, Diagnostics& diagnostics);

}  // namespace lichtraum::ply
