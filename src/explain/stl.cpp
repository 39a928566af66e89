#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr std::string_view stl_command = "lichtraum check model.stl";

constexpr Explanation stl_table[] = {
    {DiagnosticCode::not_stl,
     R"(The file is too short to be a binary STL file, and does not begin with the word
'solid', as a text does. Is it something else with the ending .stl, or cut off?
)",
     R"(facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid corner
)",
     R"(solid corner
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid corner
)",
     stl_command},
    {DiagnosticCode::stl_text,
     R"(A word in an STL text is not the one that belongs there, or the file ends too
early. The facet is left out, and reading goes on with the next.
)",
     R"(solid corner
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
)",
     R"(solid corner
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid corner
)",
     stl_command},
    {DiagnosticCode::stl_bytes,
     R"(A binary STL file says how many facets it has, and is longer or shorter than
that; or corners are not finite. What is there is drawn. Was it cut off while it
was copied? For example, a file of 1,000 bytes that says it has 100 facets,
which take 5,084.
)",
     "", ""},
};
static_assert(explains_all(stl_table, "13"));

}  // namespace

std::span<Explanation const> stl() { return stl_table; }

}  // namespace lichtraum::explain
