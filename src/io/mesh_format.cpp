#include "io/mesh_format.hpp"

#include <algorithm>

#include "core/ascii.hpp"

namespace lichtraum {

std::span<MeshFormat const> mesh_formats() { return {}; }

MeshFormat const* find_mesh_format(std::span<MeshFormat const> formats, std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  auto const found = std::find_if(formats.begin(), formats.end(), [&](MeshFormat const& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
  });
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace lichtraum
