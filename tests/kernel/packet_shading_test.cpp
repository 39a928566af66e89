/// Sixteen points shaded at once are what each of them is alone, to the last bit.

#include <algorithm>
#include <map>

#include "reference.hpp"
#include "render/drawn_roots.hpp"
#include "scene/flatten.hpp"
#include "scene_arguments.hpp"
#include "shared/frame.h"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr std::size_t packet_size = 64;
constexpr device::uint no_primitive = 0xffffffff;  // NO_PRIMITIVE of the kernels

struct ProbePoint {
  device::uint kind;
  device::uint different;
  device::uint lit;
};

/// Every kind of shape, with materials whose exponents are whole, fractional, large and zero, and mirrors and glass.
std::string scene_text(Random& random) {
  char const* const exponents[] = {"0", "1", "7.25", "90", "70000"};
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text += "define material m" + std::to_string(i) + " 0.1 0.2 0.3  0.9 0.5 0.1  0.3 0.6 0.2  " + exponents[i] +
            (i == 3 ? " reflect=0.3 transmit=0.5 ior=1.4\n" : "\n");
  }
  auto const number = [&](double low, double high) { return " " + std::to_string(random.uniform(low, high)); };
  auto const point = [&](double reach) {
    return number(-reach, reach) + number(-reach, reach) + number(-reach, reach);
  };
  for (int i = 0; i < 60; ++i) {
    std::string const id = std::to_string(i), material = " m" + std::to_string(i % 5) + "\n";
    text += "define shape sphere s" + id + point(4) + number(0.2, 0.7) + material;
    text += "define shape sphere e" + id + point(0.5) + number(0.3, 0.6) + material;
    text += "transform e" + id + " scale" + number(0.3, 2) + number(0.3, 2) + number(0.3, 2) + "\n";
    text += "transform e" + id + " rotate" + number(0, 360) + point(1) + "\n";
    text += "transform e" + id + " translate" + point(4) + "\n";
    text += "define shape box b" + id + " 0 0 0" + number(0.2, 0.9) + (i % 4 == 0 ? " 0" : number(0.2, 0.9)) +
            number(0.2, 0.9) + material;
    text += "transform b" + id + " rotate" + number(0, 360) + point(1) + "\n";
    text += "transform b" + id + " translate" + point(4) + "\n";
    text += "define shape triangle t" + id + point(4) + point(4) + point(4) + material;
  }
  return text + "define light ambient sky 0.3 0.2 0.1\ndefine camera eye 40\n";
}

}  // namespace

TEST_CASE("sixteen points at once are shaded as one by one, to the last bit", "[packet][layouts][shading]") {
  NEEDS_OPENCL_DEVICE();
  Random random(11);
  Scene const scene = scene_of(scene_text(random));
  SceneBuffers const buffers = compile_scene(flatten(drawn_roots(scene, "")), scene.lights, Traversal::packet);
  ProbeProgram const program("packet_shading.cl", scene_options(buffers));

  std::vector<float4> origins, directions;
  std::size_t const packets = std::max<std::size_t>(scaled_count(600), 12);  // enough to meet every kind of shape
  for (std::size_t i = 0; i < packets; ++i) {
    // From outside, and from within, where surfaces are seen from their backs; narrow, so that rays share what they
    // meet.
    Vec3 const origin = i % 3 == 0 ? random.in_cube(4) : random.direction() * 12.;
    Vec3 const center = random.in_cube(4) - origin;
    double const spread = i % 2 == 0 ? 0.3 : 3;
    for (std::size_t ray = 0; ray < packet_size; ++ray) {
      Vec3 const direction = glm::normalize(center + random.in_cube(spread));
      origins.push_back(to_float4(origin));
      directions.push_back(to_float4(direction, i % 7 == 0 && ray % 5 == 0 ? 0 : 1));
    }
  }
  std::vector<device::FrameParameters> frame(1);
  frame[0].ambient = {0.3f, 0.2f, 0.1f, 0};
  frame[0].background = {0.5f, 0.25f, 0.125f, 0};
  device::float4 const light{3, 9, 5, 1};
  std::vector<ProbePoint> points(origins.size());
  std::vector<ProbeArgument> arguments = scene_arguments(buffers);
  for (auto const& argument : {in(frame), in(origins), in(directions), value(light), out(points)}) {
    arguments.push_back(argument);
  }
  program.run("probe_points", packets, arguments, 1, 1, 1);

  std::map<device::uint, std::size_t> met, lit;
  for (std::size_t i = 0; i < points.size(); ++i) {
    INFO("ray " << i << " met " << points[i].kind);
    REQUIRE(points[i].different == 0);
    ++met[points[i].kind];
    lit[points[i].kind] += points[i].lit;
  }
  for (device::uint const kind : {PRIMITIVE_TRIANGLE, PRIMITIVE_SPHERE, PRIMITIVE_ELLIPSOID, PRIMITIVE_BOX}) {
    CAPTURE(kind);
    CHECK(met[kind] > points.size() / 50);
    CHECK(lit[kind] > met[kind] / 10);
    CHECK(lit[kind] < met[kind]);
  }
  CHECK(met[no_primitive] > points.size() / 50);
}
