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
namespace {

Model import_obj_alone(std::string bytes, std::string const& name, ModelOptions const& options) {
  return import_obj_text(std::move(bytes), name, std::nullopt, options);
}
Model import_ply_alone(std::string bytes, std::string const& name, ModelOptions const& options) {
  return import_ply_bytes(bytes, name, std::nullopt, options);
}
Model import_stl_alone(std::string bytes, std::string const& name, ModelOptions const& options) {
  return import_stl_bytes(bytes, name, options);
}

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }
bool is_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }

MeshFormat const& format_of(std::filesystem::path const& path) {
  if (MeshFormat const* const format = find_mesh_format(mesh_formats(), path)) return *format;
  auto const unread = recognise_unread_model(path);
  throw Error(ErrorKind::usage, unread ? fmt::format("'{}' is {}: {}", path.string(), unread->what, unread->hint)
                                       : fmt::format("'{}' is not a model in a known format", path.string()));
}

}  // namespace

std::span<MeshFormat const> mesh_formats() {
  static MeshFormat const table[] = {
      {"glTF", {".gltf", ".glb"}, import_gltf, import_gltf_bytes, is_glb},
      {"Wavefront OBJ", {".obj"}, import_obj, import_obj_alone, is_obj},
      {"PLY", {".ply"}, import_ply, import_ply_alone, is_ply},
      {"STL", {".stl"}, import_stl, import_stl_alone, is_stl},
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

std::vector<std::string_view> model_formats() {
  std::vector<std::string_view> names;
  for (MeshFormat const& format : mesh_formats()) {
    for (std::string_view const extension : format.extensions) names.push_back(extension.substr(1));
  }
  return names;
}

std::string_view model_format_of(std::string_view bytes) {
  for (MeshFormat const& format : mesh_formats()) {
    if (format.recognise && format.recognise(bytes)) return format.extensions.back().substr(1);
  }
  return {};
}

Model import_model(std::filesystem::path const& path, ModelOptions const& options) {
  return format_of(path).import(path, options);
}

Model import_model_bytes(std::string bytes, std::string const& name, ModelOptions const& options) {
  return format_of(name).import_bytes(std::move(bytes), name, options);
}

Scene load_model(std::filesystem::path const& path, ModelOptions const& options) {
  return std::move(import_model(path, options).scene);
}

}  // namespace lichtraum
