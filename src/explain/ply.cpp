#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr std::string_view ply_command = "lichtraum check model.ply";

constexpr Explanation ply_table[] = {
    {DiagnosticCode::ply_header,
     R"(The header of a PLY file cannot be read, so neither can the data, whose form it
describes. The message says at which word. Lines of the header are format,
element, property, comment, obj_info and end_header.
)",
     R"(ply
format ascii 1.0
element vertex 3
property float x
property real y
property float z
element face 1
property list uchar int vertex_index
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
)",
     R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_index
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
)",
     ply_command},
    {DiagnosticCode::ply_data,
     R"(The data of a PLY file does not fit its header: it ends too early, or a list or
a face has a size that cannot be. What was read before is drawn.
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
)",
     R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_index
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
)",
     ply_command},
};
static_assert(explains_all(ply_table, "12"));

}  // namespace

std::span<Explanation const> ply() { return ply_table; }

}  // namespace lichtraum::explain
