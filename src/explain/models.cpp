#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation model_table[] = {
    {DiagnosticCode::nothing_to_draw,
     R"(The model has no triangles, lines or points that could be drawn. Either the file
has none, or all of them were left out, for which there are warnings.
)",
     R"(ply
format ascii 1.0
element vertex 0
property float x
property float y
property float z
end_header
)",
     R"(ply
format ascii 1.0
element vertex 1
property float x
property float y
property float z
end_header
0 0 0
)",
     "lichtraum check model.ply"},
    {DiagnosticCode::geometry_left_out,
     R"(Triangles or points are left out because a corner is not a finite number, or is
a vertex that the model does not have. The rest is drawn. The message says how
many; export the model again. Gaussian splats are drawn as points: those that
more than half of the light goes through are left out.
)",
     R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 2
property list uchar int vertex_index
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
3 0 1 9
)",
     R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 2
property list uchar int vertex_index
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
3 2 1 0
)",
     "lichtraum check model.ply"},
    {DiagnosticCode::texture_left_out,
     R"(A picture that the model names cannot be used: it is not there, lies outside of
the folders that may be read, or is damaged. The surface is drawn without it.
Pictures belong beside the model, by the names that it has for them.
)",
     R"({
  "asset": {"version": "2.0"},
  "buffers": [{"uri": "triangle.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
  ],
  "images": [{"uri": "woood.png"}],
  "textures": [{"source": 0}],
  "materials": [
    {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
  ],
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
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"mesh": 0}],
  "scenes": [{"nodes": [0]}]
}
)",
     "lichtraum check model.gltf"},
    {DiagnosticCode::faulty_number,
     R"(A line of an OBJ, MTL, PLY or STL file has a word that is not a number, one that
is too large, or too few of them. What it belongs to is left out. Exporters that
write commas for decimal points cause this often. Colours of vertices that
should go from 0 to 1 may go up to 255 or 65535: they are read as such.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
vn 0 0,5 1
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
vn 0 0.5 1
)",
     "lichtraum check model.obj"},
    {DiagnosticCode::textures_halved,
     R"(Together, the model's pictures would take more than an eighth of the memory, or
more than 2 GiB; up to 512 MiB are always there. The largest are halved, some
several times, until all fit. With a smaller --max-texture they are as large on
every machine. For example, 100 pictures of 4096 x 4096 pixels.
)",
     "", ""},
    {DiagnosticCode::file_elsewhere,
     R"(A picture or an MTL file is not where the model says, for example as that is a
folder of another machine. One of the same name beside the model, in its folder
textures, tex or maps, or called like the model is used instead. Is it the one
that was meant? lichtraum check --verbose names all of them.
)",
     R"(mtllib C:\work\steel.mtl
usemtl steel
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     R"(mtllib steel.mtl
usemtl steel
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     "lichtraum check model.obj"},
    {DiagnosticCode::far_from_origin,
     R"(The model lies so far from the origin, compared with its size, that the numbers
of the device could not tell its vertices apart, as models with coordinates of
maps do. It was moved to the origin, by the offset that the message says, so
that it keeps its detail. Cameras and lamps for it go where it is now.
)",
     R"(v 500000 5600000 100
v 500010 5600000 100
v 500000 5600010 100
f 1 2 3
)",
     R"(v 0 0 0
v 10 0 0
v 0 10 0
f 1 2 3
)",
     "lichtraum check model.obj"},
};
static_assert(explains_all(model_table, "09"));

}  // namespace

std::span<Explanation const> models() { return model_table; }

}  // namespace lichtraum::explain
