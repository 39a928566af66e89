#include "explain/tables.hpp"

namespace lichtraum::explain {
namespace {

constexpr Explanation picture_table[] = {
    {DiagnosticCode::no_camera,
     R"('render' is followed by the name of a camera. With a single camera in the scene
it may be left out; here there is not exactly one.
)",
     R"(define camera front 45
define camera side 45
render picture.png 320 240
)",
     R"(define camera front 45
define camera side 45
render front picture.png 320 240
)"},
    {DiagnosticCode::camera_assumed,
     R"('render' names no camera, or one that is not defined. The scene has one camera
up to here, which is taken. If that is right, write its name.
)",
     R"(define camera eye 45
render front picture.png 320 240
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
    {DiagnosticCode::no_file_name,
     R"('render' does not say which file to write. Its name comes after that of the
camera.
)",
     R"(define camera eye 45
render eye
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
    {DiagnosticCode::spaces_in_file_name,
     R"(Spaces separate arguments, but this file name seems to have some. Its parts are
joined without them. Choose a name without spaces.
)",
     R"(define camera eye 45
render eye my picture.png 320 240
)",
     R"(define camera eye 45
render eye my_picture.png 320 240
)"},
    {DiagnosticCode::stray_word,
     R"('render' takes a camera, a file, width and height, and then key=value arguments.
There is a word that is none of these.
)",
     R"(define camera eye 45
render eye picture.png 320 x 240
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
    {DiagnosticCode::extra_render_numbers,
     R"('render' takes two numbers: width and height in pixels. Some programs write
more, which are taken as samples per pixel and depth of reflections. Write
samples= and depth= to be clear.
)",
     R"(define camera eye 45
render eye picture.png 320 240 16
)",
     R"(define camera eye 45
render eye picture.png 320 240 samples=16
)"},
    {DiagnosticCode::unknown_integrator,
     R"(An integrator is the way that light is found. There are whitted, for lamps,
mirrors and glass, and path, for all light.
)",
     R"(define camera eye 45
render eye picture.png 320 240 integrator=paths
)",
     R"(define camera eye 45
render eye picture.png 320 240 integrator=path
)"},
    {DiagnosticCode::no_resolution,
     R"(Nothing says how many pixels the picture has: neither 'render' nor its camera.
Write width and height at the end of 'render'.
)",
     R"(define camera eye 45
render eye picture.png
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
};
static_assert(explains_all(picture_table, "08"));

}  // namespace

std::span<Explanation const> pictures() { return picture_table; }

}  // namespace lichtraum::explain
