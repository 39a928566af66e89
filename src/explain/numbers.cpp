#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation number_table[] = {
    {DiagnosticCode::not_a_number,
     R"(Something else stands where a number is expected. Numbers are written as 2, -0.5
or 1e3: with a point for decimals, an ASCII minus, spaces between them, and
without units. Infinity and NaN are no numbers.
)",
     R"(define camera eye 22,5
)",
     R"(define camera eye 22.5
)"},
    {DiagnosticCode::number_too_large,
     R"(Devices compute with numbers of single precision, which reach about 3.4e38. This
one is larger. Is there a digit too many in the exponent?
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  1e40
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  1e4
)"},
    {DiagnosticCode::out_of_range,
     R"(A number means something that has limits, and lies outside of them: an opening
angle between 0 and 180 degrees, a share of the light from 0 to 1, a radius or a
brightness of at least 0. The message says which limits.
)",
     R"(define camera eye 200
)",
     R"(define camera eye 60
)"},
    {DiagnosticCode::not_a_whole_number,
     R"(A number counts something, such as pixels or samples, so it is whole and not
negative. The message says from where to where it may lie.
)",
     R"(define camera eye 45
render eye picture.png 320.5 240
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
    {DiagnosticCode::number_with_f,
     R"(A number ends in f, as in some programming languages. The f is skipped here.
Leave it out.
)",
     R"(define camera eye 45.0f
)",
     R"(define camera eye 45.0
)"},
    {DiagnosticCode::color_out_of_range,
     R"(Red, green and blue go from 0 to 1, but these are negative, or look like numbers
from 0 to 255. They are used as they are, so the picture will be far too bright
or wrong. Divide numbers from 0 to 255 by 255. Values up to 10 pass without a
warning, also of ambient light, as some scenes exaggerate on purpose. Lamps may
be brighter still: of them, only whole numbers up to 255 are warned of.
)",
     R"(define material red  1 0 0  255 0 0  0 0 0  10
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
)"},
    {DiagnosticCode::zero_direction,
     R"(Three numbers are a direction: where a camera looks, an axis to rotate about, or
what a plane faces. 0 0 0 is none.
)",
     R"(define camera eye 45
transform eye rotate 30 0 0 0
)",
     R"(define camera eye 45
transform eye rotate 30 0 1 0
)"},
};
static_assert(explains_all(number_table, "05"));

}  // namespace

std::span<Explanation const> numbers() { return number_table; }

}  // namespace lichtraum::explain
