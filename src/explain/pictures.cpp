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
Write width and height at the end of 'render', or draw with --size 640x480.
)",
     R"(define camera eye 45
render eye picture.png
)",
     R"(define camera eye 45
render eye picture.png 320 240
)"},
    {DiagnosticCode::name_used_twice,
     R"(Several pictures would be written to the same file, so only the last one is
kept. Give each a name of its own, or number them: -o picture-%04d.png.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
render eye other.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::other_format,
     R"(The scene asks for a picture in a format that lichtraum does not write, so
another ending is added and the picture is a PNG. It writes .png, .ppm, .jpg,
.exr and .pfm.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.gif 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::shapes_left_out,
     R"(Devices compute with single precision, and have coordinates up to 1e18. Shapes
that are larger or farther away are left out, as are those that are too small to
have a size. Choose another unit of length.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
define shape sphere far  0 0 -1e30  1  red
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
define shape sphere far  0 0 -1e3  1  red
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::no_light,
     R"(Nothing gives light, so all that the picture shows is black. Define a lamp, an
ambient light or an environment, or a material with emission, above the render:
statements run in order. An environment is light for the integrator path only.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define camera eye 45
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::black_picture,
     R"(The camera sees shapes and there are lamps, but no light reaches what it sees,
or next to none reaches nine tenths of what it sees of a model. Often a lamp is
inside a shape, or outside of a closed room; or the materials reflect nothing.
Or it is behind more glass or mirrors than rays are followed through: --depth 20
follows them through 20, where whitted's default is 5. Where there is some
light, --exposure brightens the picture.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  0 0 -5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::empty_view,
     R"(No ray of the camera meets anything: it looks the wrong way, stands too far
away, or the scene has no shapes, or defines them below the render. The message
says where the scene lies, as the camera sees it, and whether another reading of
rotations or transforms (--rotation, --transform-order) would show it. Or all
that the camera meets are the hidden backs of a model's surfaces: --both-sides
shows them.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::noise_left,
     R"(The limit that --noise sets was not reached with the samples that are allowed.
The picture is written with the noise that is left. Allow more with --samples,
or accept more noise. For example, --noise 0.001 --samples 64, where a dim room
would need thousands of samples.
)",
     "", ""},
    {DiagnosticCode::samples_left_out,
     R"(Some samples of the picture were infinite or not a number, and were left out.
Lamps, environments or materials with extreme numbers cause it. If those of your
scene are ordinary, please report it. For example, a surface shines with 1e38
and mirrors show it again and again: the sum is more than a number can be.
)",
     "", ""},
    {DiagnosticCode::other_denoiser,
     R"(Noise was to be taken out in one way and is taken out in another, or not at all.
Most often Open Image Denoise is not installed, or a part of it; the message
says what was missing. docs/DENOISING.md says how to install it. For example,
--denoise oidn on a machine that has no Open Image Denoise.
)",
     "", ""},
    {DiagnosticCode::undrawable_scene,
     R"(The scene was read, but a picture cannot be drawn as the scene asks: there is no
camera, the picture or the scene needs more memory than there is, or the picture
lies outside of the folders that may be written to. It is also said of a picture
or a film that is to be read and is damaged. The message says which, and what to
do. What only the command line asks, such as --camera left where there is only a
camera called right, is refused without a code. For example, render eye
picture.png 100000 100000, which needs 240 GB.
)",
     "", ""},
    {DiagnosticCode::film_of_one_picture,
     R"(A film was asked for, and there is one picture to show in it: the model has no
animation, or the scene has one render. --turntable circles what is in view;
several scenes, or a scene that draws several pictures, make a film as well. For
example, lichtraum render teapot.obj -o film.mp4, which lacks --turntable 90.
)",
     "", ""},
    {DiagnosticCode::outside_animation,
     R"(A model is to be drawn at a time before its animation begins or after it ends,
where it stands still, as at its beginning or end. The message says how long the
animation is, as lichtraum info does. For example, --time 99 of an animation
that is over after 1.25 seconds.
)",
     "", ""},
    {DiagnosticCode::white_picture,
     R"(More than half of the pixels that show something are pure white: there is more
light than the picture can store, and what differs in it is lost. A negative
--exposure darkens the picture, by half for each step; --tonemap neutral keeps
colours and shows what is brighter than white. The background colour does not
count, and files that store radiance (.exr, .pfm) keep all of it.
)",
     R"(define material white  1 1 1  1 1 1  0 0 0  10
define shape sphere ball  0 0 -5  1  white
define light ambient sky  0.2 0.2 0.2
define light diffuse lamp  5 5 5  4 4 4
define camera eye 45
render eye picture.png 32 24
)",
     R"(define material white  1 1 1  1 1 1  0 0 0  10
define shape sphere ball  0 0 -5  1  white
define light ambient sky  0.2 0.2 0.2
define light diffuse lamp  5 5 5  0.8 0.8 0.8
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::far_scene,
     R"(The scene lies so far from the origin, compared with its size, that the device's
numbers, which have 24 bits, do not tell its details apart: reflections and
shadows are displaced, and what is curved has steps. Move it to the origin, and
its cameras and lights with it. A model that is drawn by itself is moved when it
is read (W0907); in a scene it stands where its file says, and is translated.
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  500000 0 -5600005  1  red
define light diffuse lamp  500005 5 -5599995  1 1 1
define camera eye 45
transform eye translate 500000 0 -5600000
render eye picture.png 32 24
)",
     R"(define material red  1 0 0  1 0 0  0 0 0  10
define shape sphere ball  0 0 -5  1  red
define light diffuse lamp  5 5 5  1 1 1
define camera eye 45
render eye picture.png 32 24
)",
     "lichtraum render scene.sdf"},
    {DiagnosticCode::repaired_environment,
     R"(Some values of the environment's picture are negative, infinite or no numbers,
which light cannot be. 0 stands for them, and of infinite ones the largest other
value. Resampling and sharpening leave such values, and suns that are too bright
for half floats. Where more than one value in a hundred is of that kind, the
picture is refused: then it is no picture of light, such as a normal map. For
example, a sky that was scaled down has -0.0004 beside its sun.
)",
     "", ""},
};
static_assert(explains_all(picture_table, "08"));

}  // namespace

std::span<Explanation const> pictures() { return picture_table; }

}  // namespace lichtraum::explain
