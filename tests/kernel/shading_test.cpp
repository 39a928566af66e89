#include "reference.hpp"
#include "shared/develop.h"
#include "shared/frame.h"
#include "shared/phong_material.h"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("Phong's model is the formula's", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(70);
  std::size_t const count = scaled_count(50000);
  std::vector<device::PhongMaterial> materials(count);
  std::vector<float4> normals, smooth_normals, lights, viewers, reflected(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto const rgb = [&] { return Vec3(random.uniform(), random.uniform(), random.uniform()); };
    // Exponents of every sort: none, whole, between, far beyond what matters.
    double const m = std::array{0., 1., std::floor(random.uniform(2, 200)), random.uniform(0, 50), 1e5}[i % 5];
    double const reflect = i % 3 == 0 ? 0 : random.uniform(0, 0.6), transmit = i % 2 == 0 ? 0 : random.uniform(0, 0.4);
    auto const store_rgb = [&](float(&out)[3]) {
      Vec3 const color = rgb();
      for (int c = 0; c < 3; ++c) out[c] = float(color[c]);
    };
    store_rgb(materials[i].ka);
    store_rgb(materials[i].kd);
    store_rgb(materials[i].ks);
    materials[i].m = float(m);
    materials[i].reflect = float(reflect);
    materials[i].transmit = float(transmit);
    Vec3 const n = random.direction();
    Vec3 l = random.direction();
    Vec3 v = random.direction();
    if (glm::dot(v, n) < 0) v = -v;
    if (i % 4 == 0) v = 2 * glm::dot(n, l) * n - l;                         // into the highlight
    if (i % 7 == 0) l = glm::normalize(glm::cross(n, random.direction()));  // the light on the horizon
    normals.push_back(to_float4(n));
    smooth_normals.push_back(to_float4(i % 2 == 0 ? n : glm::normalize(n + random.in_cube(0.5))));
    lights.push_back(to_float4(l));
    viewers.push_back(to_float4(v));
  }
  ProbeProgram("shading.cl")
      .run("probe_reflect_light", count,
           {in(materials), in(normals), in(smooth_normals), in(lights), in(viewers), out(reflected)});
  for (std::size_t i = 0; i < count; ++i) {
    auto const& material = materials[i];
    Vec3 const n = to_vec3(normals[i]), l = to_vec3(lights[i]), v = to_vec3(viewers[i]);
    double const cosine = glm::dot(n, l);
    if (std::abs(cosine) < 1e-6) continue;  // roundings decide whether the light is above the horizon
    Vec3 expected(0);
    double const m = material.m;
    double const rv = std::max(0., glm::dot(2 * cosine * n - l, v));
    if (cosine > 0) {
      double const matt = (1. - double(material.reflect) - double(material.transmit)) * cosine;
      double const share = i % 2 == 0 ? 1 : bump_share(to_vec3(smooth_normals[i]), n, l);
      expected = share * matt * to_vec3(material.kd) + (m == 0 ? 1. : std::pow(rv, m)) * to_vec3(material.ks);
    }
    // A rounding of r.v counts m times in its power.
    double const tolerance = 1e-6 + (cosine > 0 ? 16 * rounding_unit * m * std::pow(std::min(1., rv + 1e-6), m) : 0);
    INFO(i << ": m " << m << " r.v " << rv << " n.l " << cosine);
    if (max_abs(to_vec3(reflected[i]) - expected) > tolerance) FAIL("reflected light");
  }
}

TEST_CASE("Refraction follows Snell's law, total reflection included", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(71);
  std::size_t const count = scaled_count(50000);
  std::vector<float4> directions, normals, refracted(count), mirrored(count);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const n = random.direction();
    Vec3 d = random.direction();
    if (glm::dot(d, n) > 0) d = -d;
    if (i % 10 == 0) d = -n;
    directions.push_back(to_float4(d, i % 5 == 0 ? 1 : random.uniform(0.4, 2.5)));
    normals.push_back(to_float4(n));
  }
  ProbeProgram("shading.cl").run("probe_refract", count, {in(directions), in(normals), out(refracted), out(mirrored)});
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const d = to_vec3(directions[i]), n = to_vec3(normals[i]);
    double const eta = directions[i].w, cosine = -glm::dot(d, n);
    Vec3 const mirror = d + 2 * cosine * n;
    INFO(i << ": eta " << eta << " cosine " << cosine);
    if (glm::length(to_vec3(mirrored[i]) - mirror) > 1e-6) FAIL("mirror");
    // By angles: the tangent's direction stays, sines are in the ratio eta.
    Vec3 const tangent = d + cosine * n;
    double const sine = eta * glm::length(tangent);
    if (std::abs(sine - 1) < 1e-5) continue;  // at the critical angle roundings decide
    bool const found = refracted[i].w != 0;
    if (found != (sine < 1)) FAIL("total reflection");
    total += !found;
    if (!found) continue;
    Vec3 const expected = eta * tangent - std::sqrt(1 - sine * sine) * n;
    if (glm::length(to_vec3(refracted[i]) - expected) > 1e-6 / std::sqrt(1 - std::min(sine, 1.))) FAIL("refracted");
  }
  if (count >= 1000) CHECK(total > count / 20);
}

TEST_CASE("tone maps and transfer functions are the host's to the bit", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(73);
  std::vector<float4> radiance{to_float4(Vec3(0)),      to_float4(Vec3(1e30)), to_float4(Vec3(INFINITY)),
                               to_float4({-1, 0.5, 2}), to_float4(Vec3(0.08)), to_float4(Vec3(0.8))};
  while (radiance.size() < scaled_count(20000)) {
    auto const channel = [&] { return std::pow(10., random.uniform(-7, 4)); };
    radiance.push_back(to_float4({channel(), channel(), channel()}));
  }
  ProbeProgram const program("shading.cl");
  for (device::uint tone_map = TONE_MAP_NONE; tone_map <= TONE_MAP_ACES; ++tone_map) {
    for (device::uint const transfer : {TRANSFER_LINEAR, TRANSFER_SRGB}) {
      std::vector<float4> developed(radiance.size());
      device::DevelopParameters const parameters{1, 1.5f, tone_map, transfer};
      program.run("probe_develop", radiance.size(), {in(radiance), value(parameters), out(developed)});
      for (std::size_t i = 0; i < radiance.size(); ++i) {
        auto const [r, g, b] = device::develop_color({radiance[i].x, radiance[i].y, radiance[i].z}, parameters);
        INFO(radiance[i].x << " " << radiance[i].y << " " << radiance[i].z << ", tone map " << tone_map);
        if (developed[i].x != r || developed[i].y != g || developed[i].z != b) FAIL("not the same");
      }
    }
  }
}

TEST_CASE("Affine maps", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(72);
  std::size_t const count = scaled_count(20000);
  std::vector<device::AffineTransform> maps;
  std::vector<float4> vectors, points(count), mapped(count), transposed(count), solved(count);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::pow(10., random.uniform(-6, 6));
    Mat3 const stretch(random.uniform(0.1, 1), 0, 0, 0, random.uniform(0.1, 1), 0, 0, 0, -random.uniform(0.1, 1));
    maps.push_back(to_device({random.rotation() * stretch * random.rotation() * scale, random.in_cube(1e3)}));
    vectors.push_back(to_float4(random.in_cube(std::pow(10., random.uniform(-6, 6)))));
  }
  maps[0] = to_device({Mat3(0), Vec3(1, 2, 3)});  // no inverse
  ProbeProgram("shading.cl")
      .run("probe_affine", count, {in(maps), in(vectors), out(points), out(mapped), out(transposed), out(solved)});
  CHECK(to_vec3(solved[0]) == Vec3(0));
  for (std::size_t i = 1; i < count; ++i) {
    Affine const map = from_device(maps[i]);
    Vec3 const v = to_vec3(vectors[i]);
    double const terms = max_abs(map.linear[0]) + max_abs(map.linear[1]) + max_abs(map.linear[2]);
    double const tolerance = 8 * rounding_unit * terms * max_abs(v);
    INFO("map " << i);
    if (max_abs(to_vec3(mapped[i]) - map.linear * v) > tolerance) FAIL("vector");
    if (max_abs(to_vec3(points[i]) - map.point(v)) > tolerance + 8 * rounding_unit * max_abs(map.offset)) FAIL("point");
    if (max_abs(to_vec3(transposed[i]) - glm::transpose(map.linear) * v) > tolerance) FAIL("transpose");
    Vec3 const expected = glm::inverse(map.linear) * v;
    // Condition numbers reach 100.
    if (glm::length(to_vec3(solved[i]) - expected) > 1e-4 * glm::length(expected)) FAIL("solve");
  }
}
