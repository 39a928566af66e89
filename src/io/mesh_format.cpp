#include "io/mesh_format.hpp"

#include <algorithm>

#include "core/ascii.hpp"
#include "lichtraum/gltf.hpp"

namespace lichtraum {
namespace {

std::shared_ptr<Shape> load_gltf_mesh(std::filesystem::path const& path, std::string name,
                                      std::shared_ptr<Material const> material) {
  GltfOptions options;
  options.material = std::move(material);
  Scene const scene = load_gltf(path, options);
  Composite::Children roots;
  for (auto const& root : scene.roots()) roots.push_back(*scene.shapes.find(root->name()));
  return std::make_shared<Composite>(std::move(name), std::move(roots));
}

}  // namespace

std::span<MeshFormat const> mesh_formats() {
  static MeshFormat const table[] = {{"glTF", {".gltf", ".glb"}, load_gltf_mesh}};
  return table;
}

MeshFormat const* find_mesh_format(std::span<MeshFormat const> formats, std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  auto const found = std::find_if(formats.begin(), formats.end(), [&](MeshFormat const& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
  });
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace lichtraum
