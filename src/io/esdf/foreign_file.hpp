#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lichtraum::esdf {

/// What a file is that is certainly no eSDF.
struct ForeignFile {
  std::string message;
  std::string hint;
};

std::optional<ForeignFile> recognise_foreign_file(std::string_view text);

}  // namespace lichtraum::esdf
