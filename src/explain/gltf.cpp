#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr std::string_view gltf_command = "lichtraum check model.gltf";

constexpr Explanation gltf_table[] = {
    {DiagnosticCode::not_gltf,
     R"(The file is not JSON, or JSON that cannot be a glTF model. The message says
where reading stopped. Was the file cut off while it was copied, or is it
something else with the ending .gltf?
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::gltf_version,
     R"(The model has another version of glTF. lichtraum reads version 2, of 2017.
Export it again, or convert it.
)",
     R"({
  "asset": {"version": "1.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::broken_glb,
     R"(The header or the JSON of a .glb file is damaged or missing, so nothing of it
can be read. Most often the file was cut off while it was copied. Copy or export
it again. For example, a page that says "not found" was saved as model.glb.
)",
     "", ""},
    {DiagnosticCode::cut_glb,
     R"(A .glb file is shorter than it says, so some of its data is missing. What is
there is drawn. Copy or export it again. For example, a download of 20 MB that
stopped after 15.
)",
     "", ""},
    {DiagnosticCode::gltf_property,
     R"(A property of the model is missing, has a wrong type, or refers to something
that is not there. It is left out, or the default is taken, and the rest is
read. The message begins with its place in the file, a JSON pointer.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0, "name": 7}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::unsupported_extension,
     R"(The model uses an extension of glTF that lichtraum does not support. What can be
read without it is shown, so the picture may differ from that of other programs.
lichtraum info lists a model's extensions.
)",
     R"({
  "asset": {"version": "2.0"},
  "extensionsUsed": ["ACME_fur"], "extensionsRequired": ["ACME_fur"],
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::unreadable_buffer,
     R"(A buffer, which holds the model's numbers, cannot be read: its file is missing,
outside of the folders that may be read, or shorter than declared. Keep .bin
files beside the .gltf.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 48}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::unreadable_accessor,
     R"(An accessor, which says where vertices, indices or key frames are, does not fit
what it refers to: numbers are out of range, of a wrong type, or too few. What
needs it is left out.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
    {"bufferView": 0, "componentType": 5126, "count": 9, "type": "SCALAR"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::undrawn_primitive,
     R"(A part of a mesh is not drawn: it has no positions, no whole triangle or line,
or a mode that glTF does not know.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [
    {"attributes": {"POSITION": 0}}, {"attributes": {"NORMAL": 0}}
  ]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::unfolds_too_far,
     R"(A small file declares more data than it could mean in earnest: many views of the
same bytes, or zeros without end. It is refused before it fills the memory. For
example, 1,000 meshes that each name the same 50 MB, read anew for each.
)",
     "", ""},
    {DiagnosticCode::faulty_animation,
     R"(A channel of an animation cannot be read: times that do not increase, or more or
fewer values than times. It is left out; the rest moves. For example, key frames
at 0, 2 and 1 seconds.
)",
     "", ""},
    {DiagnosticCode::faulty_node,
     R"(A node has a transform that cannot be used, occurs twice in the tree, or has
instances that cannot be read. It is left out, or drawn once.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}, {"mesh": 0, "scale": [0, 0, 0]}],
  "scenes": [{"nodes": [0, 1]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::faulty_skin,
     R"(A skin, which bends a mesh by a skeleton, does not fit the mesh, or has more or
fewer matrices than joints. The mesh is drawn as it was modelled. For example,
inverseBindMatrices has 10 matrices, and joints 12 nodes.
)",
     "", ""},
    {DiagnosticCode::faulty_view,
     R"(A camera has no valid opening angle, or a light has angles that cannot be, or
does not exist. The camera is left out; the light shines in all directions, or
not.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 4, "znear": 1}}],
  "nodes": [{"mesh": 0, "camera": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
  "nodes": [{"mesh": 0, "camera": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
    {DiagnosticCode::faulty_gltf_material,
     R"(A material has a share that is not between 0 and 1, or names a texture that does
not exist. The share is brought into its range; the texture is left out.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "materials": [{"pbrMetallicRoughness": {"metallicFactor": 3}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "materials": [{"pbrMetallicRoughness": {"metallicFactor": 1}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     gltf_command},
};
static_assert(explains_all(gltf_table, "10"));

}  // namespace

std::span<Explanation const> gltf() { return gltf_table; }

}  // namespace lichtraum::explain
