#include "view/unused_name.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace lichtraum::view {

std::string unused_name(std::string const& stem, char const* extension) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}_{:04}{}", stem, number, extension);
    std::error_code unknown;
    if (!std::filesystem::exists(std::filesystem::symlink_status(name, unknown))) return name;
  }
}

}  // namespace lichtraum::view
