#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation shape_table[] = {
    {DiagnosticCode::unknown_shape,
     R"(The word after 'define shape' is no kind of shape. The kinds are sphere, box,
triangle, cylinder, cone, plane, mesh, obj and composite, in lower case.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape spere ball  0 0 -5  1  red
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
)"},
    {DiagnosticCode::material_first,
     R"(The material stands before the numbers. It is the last argument of a shape.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball red 0 0 -5  1
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
)"},
    {DiagnosticCode::zero_size,
     R"(A shape has no extent: a radius or a height of 0, or both ends of a cylinder or
a cone at one point. There would be nothing to see.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  0  red
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
)"},
    {DiagnosticCode::negative_radius,
     R"(A radius is negative. Its absolute value is taken, but something else may have
been meant: are the numbers in the right order?
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 5  -1  red
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
)"},
    {DiagnosticCode::invisible_shape,
     R"(A box or a triangle is a line or a point, so no ray can hit it. A box is given
by two opposite corners; a triangle by three that are not on a line.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape box crate  0 0 0  0 0 2  red
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape box crate  0 0 0  1 1 2  red
)"},
    {DiagnosticCode::unknown_transform,
     R"(The word after the name is no operation. 'transform' knows translate, rotate and
scale.
)",
     R"(define camera eye 45
transform eye move 0 1 0
)",
     R"(define camera eye 45
transform eye translate 0 1 0
)"},
    {DiagnosticCode::unknown_axis,
     R"(A rotation has an angle in degrees and then an axis: three numbers, or one of
the letters x, y and z.
)",
     R"(define camera eye 45
transform eye rotate 30 up
)",
     R"(define camera eye 45
transform eye rotate 30 0 1 0
)"},
    {DiagnosticCode::zero_scale,
     R"(A scale by 0 makes a shape flat, and cannot be undone. To have a thin shape, use
a small factor; to hide one, leave it out.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
transform ball scale 0
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
transform ball scale 0.01
)"},
    {DiagnosticCode::transforms_too_large,
     R"(The transforms of an object together move or scale it so far that numbers cannot
hold it, or scale it to nothing. Are there exponents that are wrong?
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
transform ball scale 1e38
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
transform ball scale 1e3
)"},
    {DiagnosticCode::transformed_light,
     R"('transform' moves shapes and cameras, not lights. Write the light's place where
it is defined.
)",
     R"(define light diffuse lamp  0 0 0  1 1 1
transform lamp translate 0 5 0
)",
     R"(define light diffuse lamp  0 5 0  1 1 1
)"},
    {DiagnosticCode::axis_before_angle,
     R"('transform ... rotate' takes the angle in degrees and then the axis. Here the
first three numbers are an axis of x, y or z, and the last one would be an
angle. It is read as it stands: by 0 degrees or by one, about another axis.
)",
     R"(camera eye 45
transform eye rotate 0 1 0 30
)",
     R"(camera eye 45
transform eye rotate 30 0 1 0
)"},
};
static_assert(explains_all(shape_table, "06"));

}  // namespace

std::span<Explanation const> shapes() { return shape_table; }

}  // namespace lichtraum::explain
