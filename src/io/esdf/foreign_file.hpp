#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lichtraum/diagnostic_code.hpp"

namespace lichtraum::esdf {

/// What a file is that is certainly no eSDF.
struct ForeignFile {
  DiagnosticCode code;
  std::string message;
  std::string hint;
};

std::optional<ForeignFile> recognise_foreign_file(std::filesystem::path const& path, std::string_view text);

}  // namespace lichtraum::esdf
