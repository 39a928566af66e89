#pragma once

#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/model.hpp"

namespace LICHTRAUM_API lichtraum {

/// Reads a Wavefront OBJ model with its MTL files: a Mesh for each material of each object or group. Throws what
/// import_model throws.
Model import_obj(std::filesystem::path const& path, ModelOptions const& options = {});

/// The same from text. `name` stands for the file in messages; MTL files and pictures are looked up in `folder`, or
/// left out where there is none.
Model import_obj_text(std::string text, std::string const& name, std::optional<std::filesystem::path> const& folder,
                      ModelOptions const& options = {});

/// Whether bytes are certainly OBJ: they begin with lines of its keywords alone, of which one is a vertex or a library.
bool is_obj(std::string_view bytes);

}  // namespace lichtraum
