/// What arrives of a light at one point: fall-off, cones.

#include "compile/light_table.hpp"
#include "reference.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("Lights fall off, have cones and directions as KHR_lights_punctual says", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(73);
  std::size_t const count = scaled_count(4000);
  std::vector<Light> lights;
  std::vector<device::PunctualLight> table;
  std::vector<float4> positions, to_lights(count), arriving(count);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const place = random.in_cube(3), direction = random.direction();
    Rgb const ld(random.uniform(0, 5), 1, 2);
    double const range = i % 3 == 0 ? infinity : random.uniform(1, 8);
    double const inner = i % 5 == 0 ? 0 : random.uniform(0, 60);
    Light const kinds[] = {Light::point("", place, ld), Light::falling_off("", place, ld, range),
                           Light::spot("", place, direction, ld, {inner, inner + random.uniform(5, 30)}, range),
                           Light::directional("", direction, ld)};
    lights.push_back(kinds[i % 4]);
    table.push_back(make_light_table({kinds[i % 4]}, DeviceBounds()).front());
    positions.push_back(to_float4(random.in_cube(4)));
  }
  ProbeProgram("material.cl")
      .run("probe_sample_light", count, {in(table), in(positions), out(to_lights), out(arriving)});
  std::size_t dark = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const position = to_vec3(positions[i]);
    Rgb const expected = lights[i].arriving_at(position);
    Vec3 const to_light = glm::normalize(lights[i].way_from(position));
    dark += expected == Rgb(0);
    INFO("light " << i << ", " << lights[i]);
    // A narrow cone's edge takes a cosine's last digits a hundredfold.
    if (max_abs(to_vec3(arriving[i]) - expected) > 1e-4 * (1 + max_abs(expected))) FAIL("what arrives");
    if (max_abs(to_vec3(to_lights[i]) - to_light) > 1e-5) FAIL("where from");
    double const distance = lights[i].position() ? glm::length(lights[i].way_from(position)) : infinity;
    if (!(to_lights[i].w == distance || std::abs(to_lights[i].w - distance) < 1e-5 * distance)) FAIL("how far");
  }
  if (count >= 1000) {
    CHECK(dark > count / 20);
    CHECK(dark < count / 2);
  }
}

TEST_CASE("A lamp with a radius is seen as an even disc from everywhere", "[kernel][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(75);
  std::size_t const count = scaled_count(20000);
  double const radius = 0.7;
  std::vector<device::PunctualLight> table;
  std::vector<Vec3> middles;
  std::vector<float4> positions, uniform, to_lights(count), arriving(count);
  for (std::size_t i = 0; i < count; ++i) {
    middles.push_back(random.in_cube(3));
    Light const lamp("",
                     PointLight{.ld = Rgb(3, 2, 1), .position = middles[i], .falls_off = i % 2 == 0, .radius = radius});
    table.push_back(make_light_table({lamp}, DeviceBounds()).front());
    positions.push_back(to_float4(middles[i] + random.direction() * random.uniform(0.1, 5)));
    uniform.push_back(to_float4({random.uniform(0, 1), random.uniform(0, 1), 0}));
  }
  ProbeProgram("material.cl")
      .run("probe_sample_lamp", count, {in(table), in(positions), in(uniform), out(to_lights), out(arriving)});
  double quarters[2][2] = {}, inner = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const position = to_vec3(positions[i]), way = middles[i] - position;
    Vec3 const z = glm::normalize(way);
    Vec3 const across = position + double(to_lights[i].w) * to_vec3(to_lights[i]) - middles[i];
    INFO("lamp " << i);
    if (std::abs(glm::dot(across, z)) > 1e-5 || glm::length(across) > radius + 1e-5) FAIL("not on the disc");
    double const distance = to_lights[i].w;
    Rgb const expected = Rgb(3, 2, 1) / (i % 2 == 0 ? distance * distance : 1.0);
    if (max_abs(to_vec3(arriving[i]) - expected) > 1e-4 * max_abs(expected)) FAIL("what arrives");
    Vec3 const x = glm::normalize(glm::cross(z, Vec3(0.3, 0.8, 0.5))), y = glm::cross(z, x);
    ++quarters[glm::dot(across, x) > 0][glm::dot(across, y) > 0];
    inner += glm::length(across) < radius * std::sqrt(0.5);
  }
  double const deviation = 4.5 * std::sqrt(double(count));
  for (auto const& half : quarters) {
    for (double const quarter : half) CHECK(std::abs(quarter - 0.25 * double(count)) < 0.44 * deviation);
  }
  CHECK(std::abs(inner - 0.5 * double(count)) < 0.5 * deviation);
}
