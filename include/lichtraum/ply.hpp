#pragma once

#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/model.hpp"

namespace LICHTRAUM_API lichtraum {

/// Reads a PLY model, in ASCII or binary of either byte order, as a Mesh for each of its pictures. Throws what
/// import_model throws.
Model import_ply(std::filesystem::path const& path, ModelOptions const& options = {});

/// The same from the file's bytes. `name` stands for the file in messages; pictures are looked up in `folder`, or left
/// out where there is none.
Model import_ply_bytes(std::string_view bytes, std::string const& name,
                       std::optional<std::filesystem::path> const& folder, ModelOptions const& options = {});

}  // namespace lichtraum
