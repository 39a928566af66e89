#pragma once

#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/model.hpp"

namespace LICHTRAUM_API lichtraum {

/// Reads an STL model, ASCII or binary: a Mesh for each solid, in the file's units. Throws what import_model throws.
Model import_stl(std::filesystem::path const& path, ModelOptions const& options = {});

/// The same from the file's bytes. `name` stands for the file in messages.
Model import_stl_bytes(std::string_view bytes, std::string const& name, ModelOptions const& options = {});

/// Whether bytes are certainly an STL file: they begin with the word "solid", or their length fits a binary file.
bool is_stl(std::string_view bytes);

}  // namespace lichtraum
