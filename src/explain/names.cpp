#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation name_table[] = {
    {DiagnosticCode::already_defined,
     R"(Two things of one kind have the same name. Materials, shapes, lights and cameras
have names of their own: a shape may have the name of a material, but not that
of another shape. Rename one of the two.
)",
     R"(define camera eye 45
define camera eye 60
)",
     R"(define camera eye 45
define camera wide 60
)"},
    {DiagnosticCode::second_environment,
     R"(A scene has one environment: the light that comes from all around. Leave one of
them out.
)",
     R"(define light environment sky 0.3 0.5 1
define light environment room studio
)",
     R"(define light environment room studio
)"},
    {DiagnosticCode::shape_and_camera,
     R"('transform' moves shapes and cameras, and here one of each has the name. The
shape is transformed. If the camera is meant, rename one of the two.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere main  0 0 -5  1  red
define camera main 45
transform main translate 0 1 0
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define camera main 45
transform main translate 0 1 0
)"},
    {DiagnosticCode::contains_itself,
     R"(A composite is a group of shapes that are defined before it, so it cannot be one
of them.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define shape composite pair ball pair
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define shape composite pair ball
)"},
    {DiagnosticCode::undefined_shape,
     R"(A composite names a shape that is not defined, or not yet: statements run in
order, so a group comes after what is in it. Check the spelling, or move the
line.
)",
     R"(define shape composite pair ball
define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define shape composite pair ball
)"},
    {DiagnosticCode::undefined_material,
     R"(A shape names a material that is not defined, or not yet: statements run in
order, so a material comes before the shapes that have it. Check the spelling,
or move the line. With --keep-going such a shape is magenta.
)",
     R"(define material white  1 1 1  1 1 1  0 0 0  10
define shape sphere ball  0 0 -5  1  whit
)",
     R"(define material white  1 1 1  1 1 1  0 0 0  10
define shape sphere ball  0 0 -5  1  white
)"},
    {DiagnosticCode::undefined_camera,
     R"('render' names a camera that is not defined, or not yet, and there is not
exactly one that could be meant. Check the spelling, or define the camera
before.
)",
     R"(define camera front 45
define camera side 45
render frnt picture.png 320 240
)",
     R"(define camera front 45
define camera side 45
render front picture.png 320 240
)"},
    {DiagnosticCode::undefined_object,
     R"('transform' names something that is neither a shape nor a camera, or not yet:
statements run in order, so a shape is defined before it is moved. Check the
spelling, or move the line.
)",
     R"(transform eye translate 0 1 0
define camera eye 45
)",
     R"(define camera eye 45
transform eye translate 0 1 0
)"},
};
static_assert(explains_all(name_table, "04"));

}  // namespace

std::span<Explanation const> names() { return name_table; }

}  // namespace lichtraum::explain
