#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation option_table[] = {
    {DiagnosticCode::option_without_effect,
     R"(An option says something that does not matter here: --quality of a PNG, the time
of a model without animation, the exposure of a picture that has no radiance. It
is ignored. Leave it out, or choose what it belongs to, as here a picture in
JPEG.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.jpg 32 24
)",
     "lichtraum render --quality 90 scene.sdf"},
    {DiagnosticCode::unusable_device,
     R"(The device that is to draw does not exist, or fails. lichtraum devices lists
those that there are, lichtraum doctor tests them and says what to install, and
--device reference draws without any, slowly. For example, --device 3 asks for a
fourth device, which few machines have.
)",
     "", ""},
};
static_assert(explains_all(option_table, "01"));

}  // namespace

std::span<Explanation const> options() { return option_table; }

}  // namespace lichtraum::explain
