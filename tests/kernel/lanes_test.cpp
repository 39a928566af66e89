/// Sixteen points shaded at once are what each of them is alone, to the last bit.

#include <algorithm>
#include <cstring>
#include <map>

#include "compile/light_table.hpp"
#include "reference.hpp"
#include "scene/drawn_roots.hpp"
#include "scene/flatten.hpp"
#include "scene_arguments.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr std::size_t batch_size = 64;

constexpr std::size_t values_a_ray = 38;  // VALUES of lanes.cl

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
    text += "define shape cylinder c" + id + point(4) + point(4) + number(0.1, 0.4) + material;
    text += "define shape cone d" + id + point(4) + point(4) + number(0.1, 0.6) + material;
    text += "define shape triangle t" + id + point(4) + point(4) + point(4) + material;
  }
  text += "define shape plane floor 0 -5 0 0.1 1 0.2 m1\n";
  return text + "define light ambient sky 0.3 0.2 0.1\ndefine camera eye 40\n";
}

}  // namespace

TEST_CASE("sixteen points at once are shaded as one by one, to the last bit", "[layouts][lanes][shading]") {
  NEEDS_OPENCL_DEVICE();
  Random random(11);
  Scene const scene = scene_of(scene_text(random));
  SceneBuffers const buffers = compile_scene(flatten(drawn_roots(scene, "")), scene.lights, TreeLayout::wide);

  std::vector<float4> origins, directions;
  std::size_t const batches = std::max<std::size_t>(scaled_count(600), 12);  // enough to meet every kind of shape
  for (std::size_t i = 0; i < batches; ++i) {
    // From outside, and from within, where surfaces are seen from their backs; narrow, so that rays share what they
    // meet.
    Vec3 const origin = i % 3 == 0 ? random.in_cube(4) : random.direction() * 12.;
    Vec3 const center = random.in_cube(4) - origin;
    double const spread = i % 2 == 0 ? 0.3 : 3;
    for (std::size_t ray = 0; ray < batch_size; ++ray) {
      Vec3 const direction = glm::normalize(center + random.in_cube(spread));
      origins.push_back(to_float4(origin));
      directions.push_back(to_float4(direction, i % 7 == 0 && ray % 5 == 0 ? 0 : 1));
    }
  }
  std::map<int, std::size_t> met, lit;
  std::vector<Light> const lights{Light::point("", {3, 9, 5}, Rgb(1, 0.9, 0.8)),
                                  Light::spot("", {3, 9, 5}, {-3, -9, -5}, Rgb(90), {10, 40}, 30),
                                  Light::directional("", {-1, -2, -1}, Rgb(1))};
  for (Light const& light : lights) {
    BigVector<device::PunctualLight> const table = make_light_table({light}, buffers.world_bounds);
    auto const values_with = [&](int lanes, std::size_t rays_a_work_item) {
      std::vector<float> values(values_a_ray * origins.size());
      std::vector<ProbeArgument> arguments = scene_arguments(buffers);
      for (auto const& argument : {in(origins), in(directions), in(table), out(values)}) arguments.push_back(argument);
      ProbeProgram const program("lanes.cl", scene_options(buffers, lanes));
      program.run("probe_points", origins.size() / rays_a_work_item, arguments, 1, 1, 1);
      return values;
    };
    std::vector<float> const one = values_with(1, 1), sixteen = values_with(16, batch_size);
    for (std::size_t i = 0; i < one.size(); ++i) {
      INFO("ray " << i / values_a_ray << ", value " << i % values_a_ray);
      if (std::memcmp(&one[i], &sixteen[i], sizeof(float)) != 0) FAIL(one[i] << " and " << sixteen[i]);
    }
    for (std::size_t i = 0; i < one.size(); i += values_a_ray) {
      ++met[int(one[i])];
      lit[int(one[i])] += one[i + 1] != 0;
    }
  }
  std::size_t const rays = lights.size() * origins.size();
  for (device::uint const kind : {PRIMITIVE_TRIANGLE, PRIMITIVE_SPHERE, PRIMITIVE_ELLIPSOID, PRIMITIVE_BOX,
                                  PRIMITIVE_CYLINDER, PRIMITIVE_CONE, PRIMITIVE_PLANE}) {
    CAPTURE(kind);
    CHECK(met[int(kind)] > 0);
    if (rays >= 10000) CHECK(met[int(kind)] > rays / 50);  // few rays are too few for a share
    CHECK(lit[int(kind)] > met[int(kind)] / 20);
    CHECK(lit[int(kind)] < met[int(kind)]);
  }
  CHECK(met[-1] > rays / 50);
}
