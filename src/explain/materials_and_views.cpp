#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation material_table[] = {
    {DiagnosticCode::more_than_all_light,
     R"(A material reflects a share of the light and lets another share through.
Together they cannot be more than 1, which is all of it.
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100  reflect=0.4 transmit=0.8
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100  reflect=0.2 transmit=0.8
)"},
    {DiagnosticCode::more_than_all_light_in_extras,
     R"(The numbers after m, with the meanings that --material-extras gives them, make
reflectance and transmittance add up to more than 1. Reflectance gets what
transmittance leaves. Are the meanings in the right order?
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100  0.4 0.8
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100  0.2 0.8
)",
     "lichtraum check --material-extras reflectance,transmittance scene.sdf"},
    {DiagnosticCode::extra_material_numbers,
     R"(Some programs write numbers after m, and each means something else by them. They
are left out unless --material-extras says what they mean. The standard's form
has none, and lichtraum's has keys: reflect, transmit and ior.
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100  0.2 0.8
)",
     R"(define material glass  0 0 0  0 0 0  1 1 1  100
)"},
    {DiagnosticCode::unknown_light,
     R"(The word after 'define light' is no kind of light. The kinds are diffuse,
ambient and environment, in lower case.
)",
     R"(define light difuse lamp  0 5 0  1 1 1
)",
     R"(define light diffuse lamp  0 5 0  1 1 1
)"},
    {DiagnosticCode::ambient_light_form,
     R"(An ambient light has a name and a colour, and comes from everywhere. This one
has more numbers: with six, the first three are skipped; with nine, it is a lamp
with a position.
)",
     R"(define light ambient all  0 5 0  0.2 0.2 0.2
)",
     R"(define light ambient all  0.2 0.2 0.2
)"},
    {DiagnosticCode::incomplete_lens,
     R"(A lens has a diameter (aperture) and a distance at which things are sharp
(focus). Give both, or none for a picture that is sharp everywhere.
)",
     R"(define camera eye 45 aperture=0.1
)",
     R"(define camera eye 45 aperture=0.1 focus=4
)"},
    {DiagnosticCode::unusable_up,
     R"(A camera's up is 0 0 0, or lies along the direction that it looks in, so it does
not say which side of the picture is up. Another axis is taken.
)",
     R"(define camera eye 45  0 9 0  0 -1 0  0 1 0
)",
     R"(define camera eye 45  0 9 0  0 -1 0  0 0 -1
)"},
};
static_assert(explains_all(material_table, "07"));

}  // namespace

std::span<Explanation const> materials_and_views() { return material_table; }

}  // namespace lichtraum::explain
