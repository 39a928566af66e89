#include "io/mesh_format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/ascii.hpp"
#include "io/unread_model.hpp"
#include "lichtraum/gltf.hpp"
#include "lichtraum/obj.hpp"
#include "lichtraum/ply.hpp"
#include "lichtraum/stl.hpp"

namespace lichtraum {

std::span<MeshFormat const> mesh_formats() {
  static MeshFormat const table[] = {
      {"glTF", {".gltf", ".glb"}, import_gltf},
      {"Wavefront OBJ", {".obj"}, import_obj},
      {"PLY", {".ply"}, import_ply},
      {"STL", {".stl"}, import_stl},
  };
  return table;
}

MeshFormat const* find_mesh_format(std::span<MeshFormat const> formats, std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  auto const found = std::find_if(formats.begin(), formats.end(), [&](MeshFormat const& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
  });
  return found == formats.end() ? nullptr : &*found;
}

bool is_model_file(std::filesystem::path const& path) { return find_mesh_format(mesh_formats(), path) != nullptr; }

Model import_model(std::filesystem::path const& path, ModelOptions const& options) {
  MeshFormat const* const format = find_mesh_format(mesh_formats(), path);
  if (!format) {
    auto const unread = recognise_unread_model(path);
    throw Error(ErrorKind::usage, unread ? fmt::format("'{}' is {}: {}", path.string(), unread->what, unread->hint)
                                         : fmt::format("'{}' is not a model in a known format", path.string()));
  }
  return format->import(path, options);
}

Scene load_model(std::filesystem::path const& path, ModelOptions const& options) {
  return std::move(import_model(path, options).scene);
}

}  // namespace lichtraum
