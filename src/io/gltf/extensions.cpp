#include "io/gltf/extensions.hpp"

#include <algorithm>

namespace lichtraum::gltf {
namespace {

constexpr Extension table[] = {
    {"EXT_mesh_gpu_instancing", "instances that share one mesh; of a skinned mesh only one is drawn"},
    {"EXT_meshopt_compression", "decoded, all modes and filters"},
    {"EXT_texture_webp", "decoded"},
    {"KHR_draco_mesh_compression", "decoded"},
    {"KHR_lights_punctual", "read: point, spot and directional lights, range"},
    {"KHR_materials_anisotropy", "path: stretched highlights"},
    {"KHR_materials_clearcoat", "path: a coat above all else"},
    {"KHR_materials_diffuse_transmission",
     "path: what leaves and paper let through, less what KHR_materials_volume absorbs"},
    {"KHR_materials_dispersion", "path: solids refract red, green and blue by three indices"},
    {"KHR_materials_emissive_strength", "read"},
    {"KHR_materials_ior", "bends refracted rays; path: reflections, too"},
    {"KHR_materials_iridescence", "path: interference in a thin film, changing with the angle"},
    {"KHR_materials_pbrSpecularGlossiness", "read as a dielectric of its specular colours"},
    {"KHR_materials_sheen", "path: fibres that stand up, above the rest"},
    {"KHR_materials_specular", "read; scales the highlight"},
    {"KHR_materials_transmission", "refracted rays"},
    {"KHR_materials_unlit", "shown in its own colour"},
    {"KHR_materials_variants", "the variant that --variant names; else what the meshes name themselves"},
    {"KHR_materials_volume", "makes a body refract; path: colours what is inside by distance"},
    {"KHR_mesh_quantization", "read"},
    {"KHR_meshopt_compression", "decoded, all modes and filters of EXT_meshopt_compression"},
    {"KHR_node_visibility", "invisible nodes are left out, but for cameras and joints"},
    {"KHR_texture_basisu", "the fallback picture is used; without one the texture is left out"},
    {"KHR_texture_transform", "read, for each texture of a material"},
};

}  // namespace

std::span<Extension const> supported_extensions() { return table; }

Extension const* find_extension_support(std::string_view name) {
  auto const found = std::find_if(std::begin(table), std::end(table), [name](auto const& e) { return e.name == name; });
  return found == std::end(table) ? nullptr : found;
}

}  // namespace lichtraum::gltf
