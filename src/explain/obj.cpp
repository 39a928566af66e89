#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr std::string_view obj_command = "lichtraum check model.obj";

constexpr Explanation obj_table[] = {
    {DiagnosticCode::unknown_obj_keyword,
     R"(A line begins with a word that neither OBJ nor MTL has. It is left out.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
facet 1 2 3
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     obj_command},
    {DiagnosticCode::undrawn_obj,
     R"(The model has free-form curves or surfaces, which are not drawn, or lines or
points beside faces: lines are drawn where there are no faces, and points where
there are no lines either. Export curves and surfaces as polygons, and lines and
points to a file of their own.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
l 1 2
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     obj_command},
    {DiagnosticCode::faulty_face,
     R"(A face has a corner that cannot be read, or fewer than three (a line fewer than
two). It is left out. A corner is the number of a vertex, and perhaps those of
its texture coordinate and normal: 1, 1/2, 1//3 or 1/2/3, from 1 on.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
f 1 2 x
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
f 3 2 1
)",
     obj_command},
    {DiagnosticCode::missing_vertex,
     R"(A face names a vertex, a texture coordinate or a normal that the file does not
have. Without the vertex the face is left out; without the others it is drawn.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1//1 2//1 3//1
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
vn 0 0 1
f 1//1 2//1 3//1
)",
     obj_command},
    {DiagnosticCode::missing_obj_material,
     R"(A face has a material that is in none of the MTL files. It is drawn grey. Is the
line with mtllib missing, or the .mtl file an older one?
)",
     R"(usemtl steel
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
     obj_command},
    {DiagnosticCode::unreadable_mtl,
     R"(An MTL file, which has the materials of an OBJ model, does not exist, may not be
read, or is one of very many. What needs it is drawn grey. Keep it beside the
model.
)",
     R"(mtllib stele.mtl
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     R"(mtllib steel.mtl
v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     obj_command},
    {DiagnosticCode::missing_obj_word,
     R"(A line of OBJ or MTL ends where the name of a material or a file belongs, or a
property of MTL comes before the first newmtl, which names what has it. The line
has no effect.
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
usemtl
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     obj_command},
    {DiagnosticCode::unread_color,
     R"(MTL may give colours as spectra (spectral) or in CIE XYZ (xyz), which hardly any
program writes. Only red, green and blue are read; the colour is left out. For
example, Kd spectral steel.rfl; write Kd 0.5 0.5 0.55 instead.
)",
     "", ""},
    {DiagnosticCode::parts_joined,
     R"(The model has more objects and groups than are kept apart. Those that follow are
joined, by material. The picture is the same. For example, a city of 100,000
houses with a name each.
)",
     "", ""},
    {DiagnosticCode::not_obj,
     R"(The file is something else with the ending .obj: a web page that was saved in
its place, an archive, a Git LFS pointer. The hint says what helps.
)",
     R"(<!DOCTYPE html>
<title>model.obj</title>
)",
     R"(v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3
)",
     obj_command},
};
static_assert(explains_all(obj_table, "11"));

}  // namespace

std::span<Explanation const> obj() { return obj_table; }

}  // namespace lichtraum::explain
