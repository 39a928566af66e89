#include "io/unread_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/ascii.hpp"

namespace lichtraum {
namespace {

struct UnreadFormat {
  std::string_view what;
  std::vector<std::string_view> extensions;
  std::vector<std::string_view> starts;  ///< of its bytes; none where others begin like that, too
  std::string_view converter;
  std::string_view becomes = "a .glb";
};

UnreadFormat const formats[] = {
    {"an FBX model", {".fbx"}, {"Kaydara FBX Binary", "; FBX "}, "assimp export in.fbx out.glb -fglb2"},
    {"a USD scene", {".usd", ".usda", ".usdc", ".usdz"}, {"#usda ", "PXR-USDC"}, "usd2gltf -i in.usdz -o out.glb"},
    {"a 3MF model", {".3mf"}, {}, "assimp export in.3mf out.glb -fglb2"},
    {"a COLLADA model", {".dae"}, {"<COLLADA"}, "assimp export in.dae out.glb -fglb2"},
    {"a Blender file",
     {".blend"},
     {"BLENDER"},
     "blender -b in.blend --python-expr \"import bpy; bpy.ops.export_scene.gltf(filepath='out.glb')\""},
    {"an OFF model", {".off"}, {"OFF\n", "OFF "}, "assimp export in.off out.glb -fglb2"},
    {"a STEP model", {".step", ".stp"}, {"ISO-10303-21;"}, "gmsh -2 in.step -o out.stl", "an .stl"},
    {"a VTK data set",
     {".vtk", ".vtp", ".vtu"},
     {"# vtk DataFile", "<VTKFile"},
     "python3 -c \"import pyvista; pyvista.read('in.vtk').extract_surface().triangulate().save('out.ply')\"",
     "a .ply"},
};

/// Without an XML declaration, which says nothing about what follows.
std::string_view without_declaration(std::string_view bytes) {
  if (!bytes.starts_with("<?xml")) return bytes;
  constexpr std::size_t examined_bytes = 4096;
  std::string_view const head = bytes.substr(0, examined_bytes);
  std::size_t const end = head.find("?>");
  std::size_t const next = end == std::string_view::npos ? end : head.find_first_not_of(" \t\r\n", end + 2);
  return next == std::string_view::npos ? bytes : bytes.substr(next);
}

}  // namespace

std::optional<UnreadModel> recognise_unread_model(std::filesystem::path const& path, std::string_view bytes) {
  std::string_view const content = without_declaration(bytes);
  std::string const extension = to_lower_ascii(path.extension().string());
  auto const find = [&](auto const& matches) { return std::find_if(std::begin(formats), std::end(formats), matches); };
  auto found = find([&](UnreadFormat const& format) {
    return std::any_of(format.starts.begin(), format.starts.end(), [&](auto s) { return content.starts_with(s); });
  });
  if (found == std::end(formats)) {
    found = find([&](UnreadFormat const& format) {
      return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
    });
  }
  if (found == std::end(formats)) return std::nullopt;
  return UnreadModel{fmt::format("{}, which lichtraum does not read", found->what),
                     fmt::format("make {} of it: {}", found->becomes, found->converter)};
}

}  // namespace lichtraum
