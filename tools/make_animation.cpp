// make_animation [FRAMES] > wave.sdf: an animation for lichtraum, written by a program.
//
// A scene language has no loops, so a program writes the scene: 49 spheres on which a wave runs outwards. In eSDF a
// `render` draws everything as it is defined up to its line, so a frame is: move what moves, render. Transforms add to
// what was before; the program therefore writes by how much a sphere rises or falls from one frame to the next.
//
//     g++ -o make_animation tools/make_animation.cpp && ./make_animation 40 > wave.sdf
//     lichtraum render wave.sdf -o wave.mp4
//
// tools/make_animation.py does the same in Python and writes the same text.

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr int side = 7;  // spheres along x and along z
constexpr double spacing = 1.1;
constexpr double pi = 3.14159265358979323846;

struct Place {
  double x, z;
};

Place place_of(int sphere) { return {spacing * (sphere % side - side / 2), spacing * (sphere / side - side / 2)}; }

/// Where the centre of the sphere is; the phase goes from 0 to 1 and then starts again.
double height(Place const& place, double phase) {
  double const distance = std::hypot(place.x, place.z);
  return 0.9 + 0.4 * std::sin(2 * pi * (distance / 4 - phase));
}

void define_scene() {
  std::puts("define material floor 0.25 0.25 0.3  0.45 0.45 0.5  0.2 0.2 0.2  20  reflect=0.25");
  for (int i = 0; i < side; ++i) {
    double const share = double(i) / (side - 1);
    double const red = 0.85 - 0.7 * share, green = 0.3 + 0.2 * share, blue = 0.15 + 0.75 * share;
    std::printf("define material m%d %.3f %.3f %.3f  %.3f %.3f %.3f  0.6 0.6 0.6  60\n", i, red, green, blue, red,
                green, blue);
  }
  std::puts("define shape box ground -200 -0.2 -200  200 0 200  floor");
  for (int i = 0; i < side * side; ++i) {
    Place const place = place_of(i);
    std::printf("define shape sphere s%d %.4f %.4f %.4f 0.5 m%d\n", i, place.x, height(place, 0), place.z, i % side);
  }
  std::puts("define light ambient sky 0.35 0.35 0.4");
  std::puts("define light diffuse sun -8 14 9  0.75 0.7 0.6");
  std::puts("define light diffuse lamp 10 6 4  0.15 0.2 0.3");
  std::puts("define background 0.55 0.65 0.8");
  std::puts("define camera eye 42 640 360");
  std::puts("transform eye rotate -30 1 0 0");
  std::puts("transform eye translate 0 8.4 13.6");
  std::puts("transform eye rotate 30 0 1 0");
}

}  // namespace

int main(int argc, char* argv[]) {
  int const frames = argc > 1 ? std::atoi(argv[1]) : 40;
  define_scene();
  for (int frame = 0; frame < frames; ++frame) {
    if (frame > 0) {
      double const before = double(frame - 1) / frames, now = double(frame) / frames;
      for (int i = 0; i < side * side; ++i) {
        std::printf("transform s%d translate 0 %.4f 0\n", i, height(place_of(i), now) - height(place_of(i), before));
      }
    }
    std::printf("render eye wave_%04d.png\n", frame);
  }
}
