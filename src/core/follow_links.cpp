#include "core/follow_links.hpp"

namespace lichtraum {

std::optional<std::filesystem::path> follow_links(std::filesystem::path const& path) {
  std::filesystem::path place = path;
  for (int links = 0; links < 40; ++links) {
    std::error_code no_link;
    std::filesystem::path const next = std::filesystem::read_symlink(place, no_link);
    if (no_link) return place;
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  return std::nullopt;
}

}  // namespace lichtraum
