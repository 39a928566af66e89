#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::string const materials =
    "define material red    0.9 0.2 0.1  0.9 0.2 0.1  0.5 0.5 0.5  30\n"
    "define material blue   0.1 0.3 0.9  0.1 0.3 0.9  0.3 0.3 0.3  8\n"
    "define material white  0.9 0.9 0.9  0.8 0.8 0.8  0 0 0  1\n"
    "define material flat   0.2 0.9 0.3  0.2 0.7 0.3  0.2 0.2 0.2  0\n"
    "define material mirror 0.1 0.1 0.1  0.1 0.1 0.1  0.8 0.8 0.8  100 reflect=0.8\n"
    "define material glass  0 0 0  0 0 0  1 1 1  200 reflect=0.1 transmit=0.9 ior=1.5\n"
    "define material smoke  0.3 0.2 0.1  0.3 0.2 0.1  0 0 0  1 transmit=0.6 ior=1\n";

std::string const lights =
    "define light ambient sky 0.2 0.2 0.25\n"
    "define light diffuse key -6 9 8  0.6 0.55 0.5\n"
    "define light diffuse fill 7 5 6  0.2 0.3 0.4\n";

/// A tetrahedron of four triangles around the origin, outward by their winding.
std::string tetrahedron(std::string const& name, std::string const& material) {
  return fmt::format(
      "define shape triangle {0}1  0.8 0.8 0.8  -0.8 0.8 -0.8  0.8 -0.8 -0.8  {1}\n"
      "define shape triangle {0}2  0.8 0.8 0.8  -0.8 -0.8 0.8  -0.8 0.8 -0.8  {1}\n"
      "define shape triangle {0}3  0.8 0.8 0.8  0.8 -0.8 -0.8  -0.8 -0.8 0.8  {1}\n"
      "define shape triangle {0}4  -0.8 0.8 -0.8  -0.8 -0.8 0.8  0.8 -0.8 -0.8  {1}\n"
      "define shape composite {0} {0}1 {0}2 {0}3 {0}4\n",
      name, material);
}

std::string one_of_each(std::string const& name, std::string const& material, int kind) {
  switch (kind) {
    case 0:
      return fmt::format("define shape sphere {0} 0.1 0 0 0.8 {1}\n", name, material);
    case 1:
      return fmt::format("define shape box {0} -0.7 -0.6 -0.5 0.7 0.6 0.5 {1}\n", name, material);
    case 2:
      return tetrahedron(name, material);
    case 3:
      return fmt::format("define shape cylinder {0} -0.2 -0.7 0 0.1 0.7 0.3 0.5 {1}\n", name, material);
    case 4:
      return fmt::format("define shape cone {0} 0 -0.6 0 0.2 0.9 0.1 0.7 {1}\n", name, material);
    default:
      return fmt::format("define shape box {0} -0.7 -0.7 0.1 0.7 0.7 0.1 {1}\n", name, material);  // flat
  }
}

/// Each kind of shape (columns) under each kind of transform (rows), before a wall that takes their shadows.
std::string shapes_and_transforms(std::string const& material) {
  std::string const transforms[] = {
      "transform {0} rotate 35 1 2 0.5\n",
      "transform {0} rotate 200 0 1 1\ntransform {0} scale 0.7\n",
      "transform {0} scale 1.2 0.6 0.9\ntransform {0} rotate 30 1 0 1\n",
      "transform {0} rotate 50 1 1 0\ntransform {0} scale -1 0.9 1\n",
      "transform {0} rotate 50 1 1 1\ntransform {0} scale 1.3 0.6 -0.8\ntransform {0} rotate -20 0 0 1\n",  // a shear
  };
  std::string text = materials + lights + "define shape box wall -20 -20 -3 20 20 -1.5 white\n";
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 6; ++column) {
      std::string const name = fmt::format("s{}{}", row, column);
      text += one_of_each(name, material, column);
      text += fmt::format(fmt::runtime(transforms[row]), name);
      text += fmt::format("transform {} translate {} {} 0\n", name, 2 * column - 5, 4 - 2 * row);
    }
  }
  return text + "define background 0.5 0.6 0.8\ndefine camera eye 40\ntransform eye translate 0 0 21\n";
}

std::string const instances = materials + lights + tetrahedron("tetra", "red") +
                              "define shape sphere ball 0 1.2 0 0.5 blue\n"
                              "define shape box plate -0.6 -1 -0.6 0.6 -0.8 0.6 white\n"
                              "transform plate rotate 15 0 0 1\n"
                              "define shape composite part tetra ball plate\n"
                              "define shape composite left part\ntransform left rotate 40 0 1 0\n"
                              "transform left translate -1.6 0 0\n"
                              "define shape composite right part ball\ntransform right scale -1 1.3 0.8\n"
                              "transform right translate 1.6 0 0\n"
                              "define shape composite pair left right\n"
                              "define shape composite upper pair\ntransform upper rotate 20 0 0 1\n"
                              "transform upper translate 0 2.2 0\n"
                              "define shape composite lower pair\ntransform lower scale 0.8 1.1 1\n"
                              "transform lower rotate -25 1 0 1\ntransform lower translate 0 -2.2 -1\n"
                              "define shape composite all upper lower\n"
                              "define shape box wall -20 -20 -5 20 20 -4 white\n"
                              "define camera eye 50\ntransform eye translate 0 0 14\n";

std::string const mirrors = materials + lights +
                            "define shape box floor -30 -2 -30 30 -1 30 white\n"
                            "define shape sphere m1 -1.3 0.2 0 1.2 mirror\n"
                            "define shape sphere m2 1.3 0.2 -0.5 1.2 mirror\n"
                            "define shape box m3 -3 -1 -3.2 3 3 -3 mirror\n"
                            "define shape sphere r 0 -0.5 1.5 0.5 red\n"
                            "define background 0.3 0.4 0.6\n"
                            "define camera eye 45\ntransform eye rotate -8 1 0 0\ntransform eye translate 0 1 8\n";

std::string const glass = materials + lights + tetrahedron("prism", "glass") +
                          "transform prism rotate 30 1 1 0\ntransform prism scale -1 1 1\n"
                          "transform prism translate 2.3 0.2 0\n"
                          "define shape sphere ball -2.2 0.2 0 1.1 glass\n"
                          "define shape box pane -0.6 -1 -0.4 0.6 1.2 0.4 glass\ntransform pane rotate 25 0 1 0\n"
                          "define shape sphere fog 0 2 -1 0.7 smoke\n"
                          "define shape box floor -30 -2 -30 30 -1 30 white\n"
                          "define shape sphere r -0.5 -0.3 -3 0.7 red\n"
                          "define shape sphere b 1.5 0 -4 1 blue\n"
                          "define background 0.3 0.4 0.6\n"
                          "define camera eye 45\ntransform eye rotate -8 1 0 0\ntransform eye translate 0 1.2 9\n";

std::string const round_glass =
    materials + lights +
    "define shape cylinder rod -2.2 -1 0 -1.6 1.2 0.3 0.7 glass\n"
    "define shape cone tip 0.3 -1.2 0 0.2 1.3 0.4 0.9 glass\n"
    "define shape cylinder lens 2.4 0 -0.3 2.6 0.1 0.4 1.1 glass\n"
    "define shape cone fog 0 3 0 0 1.5 0 0.6 smoke\n"
    "define shape plane floor 0 -1.5 0 0 1 0 white\n"
    "define shape sphere r -0.5 -0.3 -3 0.7 red\n"
    "define shape cylinder b 1.5 -1 -4 1.5 1 -4 0.6 blue\n"
    "define background 0.3 0.4 0.6\n"
    "define camera eye 45\ntransform eye rotate -8 1 0 0\ntransform eye translate 0 1.2 9\n";

/// In the world, stretched, and in two instances of what has bounds as well.
std::string planes() {
  std::string text = materials + lights +
                     "define shape plane floor 0 -2 0 0.02 2 0 white\n"
                     "define shape plane glass_wall 0 0 -3 0.1 0 1 smoke\n"
                     "transform glass_wall scale 1 1 2\n"
                     "define shape plane slope 0 -8 0 1 3 1 blue\n";
  std::string children = " slope";
  for (int i = 0; i < 8; ++i) {
    text += fmt::format("define shape sphere s{0} {1} {2} {3} 0.5 red\n", i, 1.2 * i - 4, i % 3 - 1, -i % 2);
    children += fmt::format(" s{}", i);
  }
  return text + "define shape composite group" + children +
         "\ndefine shape composite a group\ntransform a scale 0.8 1 -1\n"
         "define shape composite b group\ntransform b rotate 160 0 0.2 1\ntransform b translate 0 1.5 -2\n"
         "define shape plane mirror_wall 0 0 -30 0 0.1 1 mirror\n"
         "define background 0.3 0.4 0.6\n"
         "define camera eye 60\ntransform eye rotate -8 1 0 0\ntransform eye translate 0 1 9\n";
}

/// Of another camera, amid the shapes.
std::string const parallel_view =
    "define camera parallel 45 orthographic=8\ntransform parallel rotate -20 1 0 0\ntransform parallel rotate 30 0 1 "
    "0\n"
    "transform parallel translate 1 0.5 2\n";

std::string const only_a_plane = materials + lights +
                                 "define shape plane floor 0 -1 0 0 1 0 mirror\n"
                                 "define background 0.3 0.4 0.6\ndefine camera eye 60\n";

std::string many_lights() {
  std::string text = materials + "define shape box floor -30 -2 -30 30 -1 30 white\n";
  for (int i = 0; i < 40; ++i) {
    double const angle = 0.157 * i;
    text += fmt::format("define light diffuse l{} {} {} {} 0.05 {} 0.03\n", i, 6 * std::cos(angle), 3 + 0.05 * i,
                        6 * std::sin(angle), 0.001 * i);
  }
  for (int i = 0; i < 7; ++i) text += fmt::format("define shape sphere s{0} {1} -0.4 {2} 0.6 red\n", i, i - 3, -i % 3);
  return text + "define camera eye 45\ntransform eye rotate -15 1 0 0\ntransform eye translate 0 2 9\n";
}

/// A camera's worth of picture that all shapes fit in.
Resolution const size{200, 150};

struct Variant {
  std::string name;
  std::string text;
  Sampling sampling = {};
  int depth = 5;
  ToneMap tone_map = ToneMap::none;
  Transfer transfer = Transfer::linear;
  Rgb emission{0};  ///< of the red material
};

std::vector<Variant> variants() {
  Sampling const grid{Sampling::Pattern::grid, 9}, seeded{Sampling::Pattern::seeded, 8};
  return {
      {"matt shapes", shapes_and_transforms("red")},
      {"constant highlights", shapes_and_transforms("flat")},
      {"mirror shapes", shapes_and_transforms("mirror")},
      {"smoke shapes", shapes_and_transforms("smoke")},
      {"instances", instances},
      {"mirrors", mirrors},
      {"mirrors at depth 0", mirrors, {}, 0},
      {"mirrors at depth 1", mirrors, {}, 1},
      {"mirrors at depth 30", mirrors, {}, 30},
      {"glass", glass},
      {"glass at depth 12", glass, {}, 12},
      {"glowing shapes", mirrors, {}, 5, ToneMap::none, Transfer::linear, Rgb(0.05, 0.4, 0.3)},
      {"round glass", round_glass, {}, 12},
      {"planes", planes()},
      {"only a plane", only_a_plane},
      {"orthographic", instances + parallel_view},
      {"orthographic, mirrors", mirrors + parallel_view, grid},
      {"many lights", many_lights()},
      {"grid samples", instances, grid},
      {"seeded samples", instances, seeded},
      {"reinhard", mirrors, {}, 5, ToneMap::reinhard},
      {"srgb", mirrors, seeded, 5, ToneMap::none, Transfer::srgb},
      {"reinhard and srgb", mirrors, grid, 5, ToneMap::reinhard, Transfer::srgb},
  };
}

RenderRequest request_of(Variant const& variant, Scene const& scene) {
  Camera const* const parallel = scene.cameras.find("parallel");
  RenderRequest request = whole_picture(parallel ? *parallel : scene.cameras.front(), size);
  request.sampling = variant.sampling;
  request.max_depth = variant.depth;
  request.seed = 0x123456789abcdef;
  return request;
}

/// The whole scene, scaled and moved, with what looks at it and what lights it.
Scene placed(std::string const& text, double scale, Vec3 const& offset) {
  Scene scene = scene_of(text);
  Transform const place = Transform::translation(offset) * Transform::scaling(Vec3(scale));
  auto const roots = scene.roots();
  for (auto const& shape : scene.shapes) {
    if (std::find(roots.begin(), roots.end(), shape) != roots.end()) shape->apply(place);
  }
  Registry<Light> moved;
  for (Light const& light : scene.lights) {
    auto const* const lamp = light.get<PointLight>();
    moved.insert(lamp ? Light::point(light.name(), place.point(lamp->position), lamp->ld, lamp->la) : light);
  }
  scene.lights = std::move(moved);
  for (Camera& camera : scene.cameras) camera.set_world_from_camera(place * camera.world_from_camera());
  return scene;
}

}  // namespace

TEST_CASE("whole pictures on every OpenCL device, in every layout, agree with the reference tracer", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  for (Variant const& variant : variants()) {
    DYNAMIC_SECTION(variant.name) {
      Scene const scene = scene_of(variant.text);
      Material& red = **scene.materials.find("red");
      PhongModel glowing = red.phong();
      glowing.emission = variant.emission;
      red = Material(red.name(), glowing);
      RenderRequest const request = request_of(variant, scene);
      Development const development{0, variant.tone_map, variant.transfer};
      check_layouts(scene, request, variant.name, development);
    }
  }
}

TEST_CASE("a scene looks the same at any scale and place: no acne, no light leaks", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  struct Place {
    char const* name;
    double scale;
    Vec3 offset;
  };
  for (auto const& [name, scale, offset] :
       {Place{"thousandth", 1e-3, Vec3(0)}, Place{"million", 1e6, Vec3(0)}, Place{"thousandth, moved", 1e-3, Vec3(0.1)},
        Place{"moved", 1, Vec3(300, -200, 100)}, Place{"million, moved", 1e6, Vec3(1e8, -2e8, 3e8)}}) {
    for (auto const& [kind, text] : {std::pair<char const*, std::string>{"matt", shapes_and_transforms("red")},
                                     {"instances", instances},
                                     {"planes", planes()},
                                     {"mirrors", mirrors}}) {
      DYNAMIC_SECTION(kind << " " << name) {
        Scene const original = scene_of(text);
        Image const expected = render_reference(original, whole_picture(original.cameras.front(), size));
        Scene const scene = placed(text, scale, offset);
        RenderRequest const request = whole_picture(scene.cameras.front(), size);
        std::string const label = fmt::format("{} {}", kind, name);
        check_picture(render_reference(scene, request), expected, label + ", reference", 0);
        for (DeviceInfo const& device : opencl_devices()) {
          check_picture(render_on(device, scene, request), expected,
                        label + ", device " + std::to_string(device.index));
        }
      }
    }
  }
}

TEST_CASE("a low wall hides a light that grazes the floor, in every layout", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  for (double const height : {1e-3, 1e-4, 1e-5}) {
    Scene const scene = scene_of(
        fmt::format("define material floor 0 0 0  0.5 0.5 0.5  1 1 1  0\ndefine material wall 0 0 0  0 0 0  0 0 0  1\n"
                    "define shape plane floor 0 0 0  0 1 0 floor\n"
                    "define shape box wall -5 -1 -10.01  5 0.02 -10 wall\n"
                    "define light diffuse lamp 0 {} 0  1 1 1\ndefine camera eye 20\n"
                    "transform eye rotate -90 1 0 0\ntransform eye translate 0 6 -10.5\n",
                    height));
    check_layouts(scene, whole_picture(scene.cameras.front(), {64, 64}), fmt::format("lamp at {}", height));
  }
}
