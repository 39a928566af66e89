#pragma once

#include <optional>
#include <string_view>

namespace lichtraum {

/// How a file begins that is something else than was expected.
struct FileSignature {
  std::string_view start;
  std::string_view what;  ///< "a PNG picture"
  std::string_view hint;  ///< what to do; may be empty
};

/// By the first bytes after white space; nothing for what is not known.
std::optional<FileSignature> recognise_signature(std::string_view bytes);

}  // namespace lichtraum
