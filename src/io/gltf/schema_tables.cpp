#include "io/gltf/schema_tables.hpp"

namespace lichtraum::gltf {
namespace {

// The types of section 5 of the glTF 2.0 specification, innermost first.

constexpr Property texture_info_properties[] = {
    {"index", Kind::reference, Need::required, 0, "textures"},
    {"texCoord", Kind::integer},
    {"scale", Kind::number},
    {"strength", Kind::number},
    {"extensions", Kind::extensions},
};
constexpr Schema texture_info{texture_info_properties, nullptr};

constexpr Property metallic_roughness_properties[] = {
    {"baseColorFactor", Kind::numbers, Need::optional, 4},
    {"baseColorTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"metallicFactor", Kind::number},
    {"roughnessFactor", Kind::number},
    {"metallicRoughnessTexture", Kind::object, Need::optional, 0, {}, &texture_info},
};
constexpr Schema metallic_roughness{metallic_roughness_properties};

constexpr Property material_properties[] = {
    {"name", Kind::string},
    {"pbrMetallicRoughness", Kind::object, Need::optional, 0, {}, &metallic_roughness},
    {"normalTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"occlusionTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"emissiveTexture", Kind::object, Need::optional, 0, {}, &texture_info},
    {"emissiveFactor", Kind::numbers, Need::optional, 3},
    {"alphaMode", Kind::string},
    {"alphaCutoff", Kind::number},
    {"doubleSided", Kind::boolean},
    {"extensions", Kind::extensions},
};
constexpr Schema material{material_properties};

constexpr Property texture_properties[] = {
    {"name", Kind::string},
    {"sampler", Kind::reference, Need::optional, 0, "samplers"},
    {"source", Kind::reference, Need::optional, 0, "images"},
    {"extensions", Kind::extensions},
};
constexpr Schema texture{texture_properties};

constexpr Property sampler_properties[] = {
    {"magFilter", Kind::integer},
    {"minFilter", Kind::integer},
    {"wrapS", Kind::integer},
    {"wrapT", Kind::integer},
};
constexpr Schema sampler{sampler_properties};

constexpr Property image_properties[] = {
    {"name", Kind::string},
    {"uri", Kind::string},
    {"mimeType", Kind::string},
    {"bufferView", Kind::reference, Need::optional, 0, "bufferViews"},
};
constexpr Schema image{image_properties};

constexpr Property buffer_properties[] = {
    {"uri", Kind::string, Need::essential},
    {"byteLength", Kind::integer, Need::required},
    {"extensions", Kind::extensions},
};
constexpr Schema buffer{buffer_properties, R"({"byteLength":0})"};

constexpr Property buffer_view_properties[] = {
    {"buffer", Kind::reference, Need::required, 0, "buffers"},
    {"byteOffset", Kind::integer, Need::essential},
    {"byteLength", Kind::integer, Need::required},
    {"byteStride", Kind::integer, Need::essential},
    {"extensions", Kind::extensions},
};
constexpr Schema buffer_view{buffer_view_properties, R"({"buffer":0,"byteLength":0})"};

constexpr Property sparse_indices_properties[] = {
    {"bufferView", Kind::reference, Need::required, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
    {"componentType", Kind::integer, Need::required},
};
constexpr Schema sparse_indices{sparse_indices_properties, nullptr};

constexpr Property sparse_values_properties[] = {
    {"bufferView", Kind::reference, Need::required, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
};
constexpr Schema sparse_values{sparse_values_properties, nullptr};

constexpr Property sparse_properties[] = {
    {"count", Kind::integer, Need::required},
    {"indices", Kind::object, Need::required, 0, {}, &sparse_indices},
    {"values", Kind::object, Need::required, 0, {}, &sparse_values},
};
constexpr Schema sparse{sparse_properties, nullptr};

constexpr Property accessor_properties[] = {
    {"bufferView", Kind::reference, Need::essential, 0, "bufferViews"},
    {"byteOffset", Kind::integer, Need::essential},
    {"componentType", Kind::integer, Need::required},
    {"normalized", Kind::boolean},
    {"count", Kind::integer, Need::required},
    {"type", Kind::string, Need::required},
    {"sparse", Kind::object, Need::essential, 0, {}, &sparse},
};
constexpr Schema accessor{accessor_properties, R"({"componentType":5126,"count":0,"type":"SCALAR"})"};

constexpr Property primitive_properties[] = {
    {"attributes", Kind::named_references, Need::required, 0, "accessors"},
    {"indices", Kind::reference, Need::essential, 0, "accessors"},
    {"material", Kind::reference, Need::optional, 0, "materials"},
    {"mode", Kind::integer, Need::essential},
    {"targets", Kind::target_list, Need::optional, 0, "accessors"},
    {"extensions", Kind::extensions},
};
constexpr Schema primitive{primitive_properties, R"({"attributes":{}})"};

constexpr Property mesh_properties[] = {
    {"name", Kind::string},
    {"primitives", Kind::objects, Need::required, 0, {}, &primitive},
    {"weights", Kind::numbers},
};
constexpr Schema mesh{mesh_properties, R"({"primitives":[]})"};

constexpr Property node_properties[] = {
    {"name", Kind::string},
    {"mesh", Kind::reference, Need::optional, 0, "meshes"},
    {"camera", Kind::reference, Need::optional, 0, "cameras"},
    {"skin", Kind::reference, Need::optional, 0, "skins"},
    {"children", Kind::references, Need::optional, 0, "nodes"},
    {"matrix", Kind::numbers, Need::optional, 16},
    {"translation", Kind::numbers, Need::optional, 3},
    {"rotation", Kind::numbers, Need::optional, 4},
    {"scale", Kind::numbers, Need::optional, 3},
    {"weights", Kind::numbers},
    {"extensions", Kind::extensions},
};
constexpr Schema node{node_properties};

constexpr Property scene_properties[] = {
    {"name", Kind::string},
    {"nodes", Kind::references, Need::optional, 0, "nodes"},
};
constexpr Schema scene{scene_properties};

constexpr Property perspective_properties[] = {
    {"yfov", Kind::number, Need::required},
    {"znear", Kind::number},
    {"zfar", Kind::number},
    {"aspectRatio", Kind::number},
};
constexpr Schema perspective{perspective_properties, nullptr};

constexpr Property orthographic_properties[] = {
    {"xmag", Kind::number, Need::required},
    {"ymag", Kind::number, Need::required},
    {"znear", Kind::number},
    {"zfar", Kind::number},
};
constexpr Schema orthographic{orthographic_properties, nullptr};

constexpr Property camera_properties[] = {
    {"name", Kind::string},
    {"type", Kind::string, Need::required},
    {"perspective", Kind::object, Need::essential, 0, {}, &perspective},
    {"orthographic", Kind::object, Need::essential, 0, {}, &orthographic},
};
constexpr Schema camera{camera_properties};

constexpr Property skin_properties[] = {
    {"joints", Kind::references, Need::required, 0, "nodes"},
    {"inverseBindMatrices", Kind::reference, Need::optional, 0, "accessors"},
};
constexpr Schema skin{skin_properties, R"({"joints":[]})"};

constexpr Property target_properties[] = {
    {"node", Kind::reference, Need::required, 0, "nodes"},
    {"path", Kind::string, Need::required},
};
constexpr Schema channel_target{target_properties, nullptr};

constexpr Property channel_properties[] = {
    {"sampler", Kind::integer, Need::required},
    {"target", Kind::object, Need::required, 0, {}, &channel_target},
};
constexpr Schema channel{channel_properties, nullptr};

constexpr Property animation_sampler_properties[] = {
    {"input", Kind::reference, Need::required, 0, "accessors"},
    {"output", Kind::reference, Need::required, 0, "accessors"},
    {"interpolation", Kind::string},
};
// No accessor has that number, and the importer looks.
constexpr Schema animation_sampler{animation_sampler_properties, R"({"input":2147483647,"output":2147483647})"};

constexpr Property animation_properties[] = {
    {"name", Kind::string},
    {"channels", Kind::objects, Need::optional, 0, {}, &channel},
    {"samplers", Kind::objects, Need::optional, 0, {}, &animation_sampler},
};
constexpr Schema animation{animation_properties};

constexpr Property asset_properties[] = {
    {"version", Kind::string},
    {"minVersion", Kind::string},
    {"generator", Kind::string},
    {"copyright", Kind::string},
};
constexpr Schema asset{asset_properties};

constexpr Property root_properties[] = {
    {"asset", Kind::object, Need::optional, 0, {}, &asset},
    {"extensionsUsed", Kind::strings},
    {"extensionsRequired", Kind::strings},
    {"buffers", Kind::objects, Need::optional, 0, {}, &buffer},
    {"bufferViews", Kind::objects, Need::optional, 0, {}, &buffer_view},
    {"accessors", Kind::objects, Need::optional, 0, {}, &accessor},
    {"images", Kind::objects, Need::optional, 0, {}, &image},
    {"samplers", Kind::objects, Need::optional, 0, {}, &sampler},
    {"textures", Kind::objects, Need::optional, 0, {}, &texture},
    {"materials", Kind::objects, Need::optional, 0, {}, &material},
    {"meshes", Kind::objects, Need::optional, 0, {}, &mesh},
    {"cameras", Kind::objects, Need::optional, 0, {}, &camera},
    {"skins", Kind::objects, Need::optional, 0, {}, &skin},
    {"nodes", Kind::objects, Need::optional, 0, {}, &node},
    {"scenes", Kind::objects, Need::optional, 0, {}, &scene},
    {"animations", Kind::objects, Need::optional, 0, {}, &animation},
    {"scene", Kind::reference, Need::optional, 0, "scenes"},
    {"extensions", Kind::extensions},
};
constexpr Schema root{root_properties};

}  // namespace

Schema const& root_schema() { return root; }

}  // namespace lichtraum::gltf
