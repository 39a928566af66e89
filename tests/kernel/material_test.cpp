/// What a material is at one point: textures, Phong's coefficients.

#include "compile/material_table.hpp"
#include "reference.hpp"
#include "scene/pbr_evaluation.hpp"
#include "scene/texture_lookup.hpp"
#include "shared/phong_from_pbr.h"
#include "shared/srgb.h"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::shared_ptr<TextureImage const> random_image(Random& random, int width, int height) {
  TextureImage image;
  image.width = width;
  image.height = height;
  for (int i = 0; i < 4 * width * height; ++i) image.rgba.push_back(std::uint8_t(random.index(256)));
  return std::make_shared<TextureImage const>(std::move(image));
}

/// Textures of every wrap mode and filter, square, long, and of a single texel, in random places.
std::vector<TextureSlot> random_slots(Random& random) {
  std::vector<TextureSlot> slots;
  for (auto const& [width, height] : {std::pair{7, 5}, {1, 1}, {2, 64}}) {
    auto const image = random_image(random, width, height);
    for (int wrap_s = 0; wrap_s < 3; ++wrap_s) {
      for (int wrap_t = 0; wrap_t < 3; ++wrap_t) {
        for (int filter = 0; filter < 2; ++filter) {
          for (bool const is_placed : {false, true}) {
            TextureSlot slot;
            slot.texture = std::make_shared<Texture const>(
                Texture{image, TextureWrap(wrap_s), TextureWrap(wrap_t), TextureFilter(filter)});
            if (is_placed) {
              slot.offset = {random.uniform(-2, 2), random.uniform(-2, 2)};
              slot.rotation_radians = random.uniform(-4, 4);
              slot.scale = {random.uniform(-3, 3), random.uniform(-3, 3)};
            }
            slots.push_back(slot);
          }
        }
      }
    }
  }
  return slots;
}

MaterialTable table_of(std::vector<TextureSlot> const& slots) {
  std::vector<std::shared_ptr<Material const>> materials;
  for (TextureSlot const& slot : slots) {
    materials.push_back(std::make_shared<Material>("", PbrModel{.base_color_texture = slot}));
  }
  return make_material_table(materials);
}

/// How far, in texels, a nearest lookup is from the next texel; infinite for another.
double distance_to_edge(TextureSlot const& slot, glm::dvec2 const& uv) {
  if (slot.texture->filter != TextureFilter::nearest) return infinity;
  TextureImage const& image = *slot.texture->image;
  glm::dvec2 const place = transform_coordinate(slot, uv) * glm::dvec2(image.width, image.height);
  auto const distance = [](double x) { return std::abs(x - std::round(x)); };
  return std::min(distance(place.x), distance(place.y));
}

}  // namespace

TEST_CASE("Textures are looked up by every wrap mode, filter and transform", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(70);
  auto const kinds = random_slots(random);
  MaterialTable const table = table_of(kinds);
  CHECK(table.textures.size() == kinds.size());
  CHECK(table.texels.size() == 7 * 5 + 1 + 2 * 64);  // each picture once
  std::size_t const count = std::max(kinds.size(), scaled_count(40000));
  std::vector<device::TextureSlot> slots;
  std::vector<std::array<float, 2>> coordinates;
  for (std::size_t i = 0; i < count; ++i) {
    slots.push_back(table.pbr[i % kinds.size()].base_color_texture);
    double const reach = i % 3 == 0 ? 20 : 1.5;
    coordinates.push_back({float(random.uniform(-reach, reach)), float(random.uniform(-reach, reach))});
  }
  for (std::size_t i = 0; i < kinds.size() && i < count; ++i) {  // corners, and what is no place at all
    coordinates[i] = std::array<std::array<float, 2>, 4>{
        {{0, 0}, {1, 1}, {float_nan, 0.5f}, {float_infinity, -float_infinity}}}[i / 2 % 4];
  }
  ProbeProgram const program("material.cl");
  for (bool const is_color : {true, false}) {
    std::vector<float4> samples(count);
    program.run("probe_sample_texture", count,
                {in(table.textures), in(table.texels), in(slots), in(coordinates),
                 value(device::uint(is_color ? 1 : 0)), out(samples)});
    std::size_t wrong = 0, compared = 0;
    for (std::size_t i = 0; i < count; ++i) {
      TextureSlot const& slot = kinds[i % kinds.size()];
      glm::dvec2 const uv(coordinates[i][0], coordinates[i][1]);
      if (distance_to_edge(slot, uv) < 2e-3) continue;
      auto const expected = look_up(slot, uv, is_color ? TexelContent::color : TexelContent::data);
      double const error = std::max(max_abs(to_vec3(samples[i]) - Vec3(expected)), std::abs(samples[i].w - expected.a));
      ++compared;
      // A coordinate of 60 pictures times 64 texels has lost twelve of its 24 bits.
      wrong += !(error < 2e-3);
    }
    CHECK(wrong == 0);
    CHECK(compared > count / 2);
  }
}

TEST_CASE("The table of sRGB is its formula", "[kernel]") {
  for (int i = 0; i < 256; ++i) {
    double const c = i / 255.0;
    double const expected = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    if (std::abs(device::linear_from_srgb_table[i] - expected) > 1e-7) FAIL(i);
  }
  SUCCEED();
}

TEST_CASE("All that kernels read of a glTF material is on the device", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(71);
  double next = 1;  // each number another
  PbrModel m;
#define COLOR(name, initial, extension, key) m.name = Rgb(next + 0.1, next + 0.2, next + 0.3), ++next;
#define SHARE(name, initial, extension, key) m.name = 1 / ++next;
#define NUMBER(name, initial, least, most, extension, key) m.name = ++next;
#define TEXTURE(name, extension, key)                                                            \
  m.name.texture = std::make_shared<Texture const>(Texture{random_image(random, 2, 2)}), ++next; \
  m.name.texcoord = int(random.index(3)) * 2;
#define MODE(type, name, initial) m.name = type(1);
  PBR_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE)
#undef COLOR
#undef SHARE
#undef NUMBER
#undef TEXTURE
#undef MODE
  m.transmission_texture.scale = {2, 3};
  auto const pbr = std::make_shared<Material>("", m);
  MaterialTable const table = make_material_table({nullptr, pbr, std::make_shared<Material>()});
  REQUIRE(table.pbr.size() == 3);
  std::vector<device::PbrMaterial> read(3);
  ProbeProgram("material.cl").run("probe_pbr_materials", 3, {in(table.pbr), out(read)});
  CHECK(read[0].flags == 0);
  CHECK(read[2].flags == 0);
  device::PbrMaterial const& r = read[1];
  CHECK(r.flags == (PBR_IS_PRESENT | PBR_VARIES | PBR_CUTOUT | PBR_FILTERS | PBR_VARIES_MORE));
  CHECK(r.alpha_mode == ALPHA_MASK);
  CHECK(r.transmission_texture.row_u[0] == 2);
  CHECK(r.transmission_texture.row_v[1] == 3);
  auto const check_slot = [&](device::TextureSlot const& found, TextureSlot const& expected) {
    REQUIRE(found.texture < table.textures.size());
    device::uint texel = 0;
    for (int c = 3; c >= 0; --c) texel = texel << 8 | expected.texture->image->rgba[std::size_t(c)];
    CHECK(table.texels[table.textures[found.texture].first_texel] == texel);
    CHECK(int(found.texcoord) <= expected.texcoord / 2);  // sets 0, 2, 4 are counted without gaps
  };
#define COLOR(name, initial, extension, key) CHECK(to_vec3(r.name) == Vec3(glm::vec3(m.name)));
#define SHARE(name, initial, extension, key) CHECK(r.name == float(m.name));
#define NUMBER(name, initial, least, most, extension, key) CHECK(r.name == float(m.name));
#define TEXTURE(name, extension, key) check_slot(r.name, m.name);
#define MODE(type, name, initial) CHECK(r.name == device::uint(m.name));
  PBR_DEVICE_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE)
#undef COLOR
#undef SHARE
#undef NUMBER
#undef TEXTURE
#undef MODE
}

TEST_CASE("Phong's coefficients follow the documented mapping, in either language", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(72);
  std::size_t const count = scaled_count(4000);
  std::vector<device::PbrPoint> points(count);
  for (auto& p : points) {
    auto const number = [&] { return float(random.index(5) == 0 ? double(random.index(2)) : random.uniform()); };
    for (int c = 0; c < 3; ++c) p.color[c] = number(), p.emission[c] = 2 * number(), p.specular_color[c] = number();
    p.alpha = number(), p.metallic = number(), p.roughness = number(), p.transmission = number();
    p.occlusion = number(), p.ior = random.index(5) == 0 ? 0 : 1 + number(), p.refraction_ior = 1 + number(),
    p.specular = number();
    p.is_unlit = random.index(8) == 0 ? 1 : 0;
  }
  std::vector<device::PhongMaterial> found(count);
  ProbeProgram("material.cl").run("probe_phong_from_pbr", count, {in(points), out(found)});
  for (std::size_t i = 0; i < count; ++i) {
    device::PbrPoint const& p = points[i];
    double const metallic = p.metallic, alpha = p.alpha, width = std::max(double(p.roughness) * p.roughness, 0.02);
    double const m = std::max((2 / (width * width) - 2) / 4, 0.0);
    double const transmit = 1 - alpha * (1 - p.transmission * (1 - metallic));
    double const r0 = std::pow((p.ior - 1.0) / (p.ior + 1.0), 2);
    Rgb const color(p.color[0], p.color[1], p.color[2]);
    Rgb const specular_color(p.specular_color[0], p.specular_color[1], p.specular_color[2]);
    Rgb const dielectric = double(p.specular) * r0 * specular_color;
    Rgb const f0 = metallic * color + (1 - metallic) * dielectric;
    Rgb const as_metal = p.ior == 0 ? (1 - metallic) * glm::max((dielectric - 0.04) / 0.96, Rgb(0)) : Rgb(0);
    double const most_as_metal = std::max({as_metal.r, as_metal.g, as_metal.b});
    Rgb kd = (1 - most_as_metal) * (1 - 0.6 * metallic) * color + 0.4 * as_metal,
        emission(p.emission[0], p.emission[1], p.emission[2]);
    Rgb ks;
    for (int c = 0; c < 3; ++c) ks[c] = alpha * std::min(f0[c] * (m + 8) / 8, 1.0);
    double reflect = 0.6 * std::max(metallic, most_as_metal) * std::pow(1 - p.roughness, 2) * (1 - transmit);
    if (p.is_unlit) {
      emission = color;
      kd = ks = Rgb(0);
      reflect = 0;
    }
    INFO("point " << i);
    bool const agrees =
        max_abs(to_vec3(found[i].kd) - kd) < 1e-6 && max_abs(to_vec3(found[i].ka) - kd * double(p.occlusion)) < 1e-6 &&
        max_abs(to_vec3(found[i].ks) - ks) < 1e-4 && (p.is_unlit || std::abs(found[i].m - m) <= 1e-5 * (1 + m)) &&
        std::abs(found[i].reflect - reflect) < 1e-6 &&
        std::abs(found[i].transmit - (p.is_unlit ? 1 - alpha : transmit)) < 1e-6 &&
        max_abs(to_vec3(found[i].emission) - alpha * emission) < 1e-6 &&
        found[i].ior == (p.is_unlit ? 1 : p.refraction_ior);
    if (!agrees) FAIL("the mapping");
  }
}
