/// What materials' models are as a BSDF, against expectations made by hand.

#include "bsdf_probe.hpp"
#include "lichtraum/pbr_model.hpp"
#include "shared/pbr_material.h"
#include "shared/phong_material.h"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

BsdfParameters of_phong(device::PhongMaterial const& material) {
  std::vector<device::PhongMaterial> const materials{material};
  std::vector<BsdfParameters> parameters(1);
  ProbeProgram("bsdf.cl", "-D LANES=1").run("probe_bsdf_from_phong", 1, {in(materials), out(parameters)});
  return parameters.front();
}

/// What the format's defaults make of a material: a white, rough metal.
device::PbrMaterial default_pbr() {
  device::PbrMaterial out{};
  out.flags = PBR_IS_PRESENT;
#define COLOR(name, initial, extension, key) set_color(out.name, initial);
#define SHARE(name, initial, extension, key) out.name = initial;
#define NUMBER(name, initial, least, most, extension, key) out.name = float(initial);
#define TEXTURE(name, extension, key) out.name.texture = NO_TEXTURE;
#define MODE(type, name, initial) out.name = device::uint(initial);
  PBR_DEVICE_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE)
#undef COLOR
#undef SHARE
#undef NUMBER
#undef TEXTURE
#undef MODE
  return out;
}

BsdfParameters of_pbr(device::PbrMaterial const& material) {
  std::vector<device::PbrMaterial> const materials{material};
  std::vector<BsdfParameters> parameters(1);
  ProbeProgram("bsdf.cl", "-D LANES=1").run("probe_bsdf_from_pbr", 1, {in(materials), out(parameters)});
  return parameters.front();
}

void check_color(float const (&color)[3], Vec3 const& expected) {
  for (int c = 0; c < 3; ++c) CHECK(color[c] == Approx(expected[c]).margin(1e-6));
}

}  // namespace

TEST_CASE("Phong's coefficients become lobes", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PhongMaterial phong{{9, 9, 9}, {0.5f, 0.4f, 0.2f}, {0.1f, 0.2f, 0.3f}, 6, 0.25f, 0.25f, 1.5f, {1, 2, 3}};
  BsdfParameters const all = of_phong(phong);
  check_color(all.emission, {1, 2, 3});
  check_color(all.diffuse, {0.25, 0.2, 0.1});
  check_color(all.f0, {0.1, 0.2, 0.3});
  check_color(all.f90, {0.1, 0.2, 0.3});
  check_color(all.transmitted, Vec3(0));
  CHECK(all.alpha == Approx(0.5));  // sqrt(2 / (6 + 2))
  CHECK(all.mirror == 0.25f);
  CHECK(all.glass == 0.25f);
  CHECK(all.ior == 1.5f);
  CHECK(all.opacity == 1);
  CHECK(all.is_layered == 0);
  CHECK(all.stretch == 1);
  CHECK(all.metallic == 0);
  CHECK(all.coat == 0);
  CHECK(all.inverse_attenuation_distance == 0);

  phong.transmit = 0;
  CHECK(of_phong(phong).ior == 1);  // nothing is refracted
  phong.reflect = 2;
  check_color(of_phong(phong).diffuse, Vec3(0));  // never less than nothing
  phong.m = 1e30f;
  CHECK(of_phong(phong).alpha == 0.001f);
}

TEST_CASE("highlights get what a matt surface, a mirror and glass leave", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  auto const lobes = [](Vec3 const& kd, Vec3 const& ks, float reflect, float transmit) {
    device::PhongMaterial phong{};
    for (int c = 0; c < 3; ++c) {
      phong.kd[c] = float(kd[c]);
      phong.ks[c] = float(ks[c]);
    }
    phong.reflect = reflect;
    phong.transmit = transmit;
    return of_phong(phong);
  };
  // All that there is fits: channel by channel.
  BsdfParameters const fits = lobes({1, 0, 0.5}, {0, 1, 0.5}, 0, 0);
  check_color(fits.diffuse, {1, 0, 0.5});
  check_color(fits.f0, {0, 1, 0.5});
  // The matt surface keeps its colour, the highlight its own: the scarcest channel decides.
  BsdfParameters const pearl = lobes({0.8, 0.5, 0.2}, {0.6, 0.6, 0.3}, 0, 0);
  check_color(pearl.diffuse, {0.8, 0.5, 0.2});
  check_color(pearl.f0, {0.2, 0.2, 0.1});
  check_color(pearl.f90, {0.2, 0.2, 0.1});
  // White leaves nothing, so the highlight gets varnish's share.
  BsdfParameters const white = lobes(Vec3(1), Vec3(0.6), 0, 0);
  check_color(white.f0, Vec3(0.05));
  check_color(white.diffuse, Vec3(0.95));
  BsdfParameters const dim = lobes(Vec3(1), Vec3(0.03), 0, 0);
  check_color(dim.f0, Vec3(0.03));
  check_color(dim.diffuse, Vec3(0.97));
  // Kd beyond white, which the C++ interface takes.
  check_color(lobes(Vec3(3), Vec3(0), 0, 0).diffuse, Vec3(1));
  BsdfParameters const mirror = lobes(Vec3(0.1), Vec3(1), 0.75, 0);
  check_color(mirror.diffuse, Vec3(0.025));
  check_color(mirror.f0, Vec3(0.225));
  BsdfParameters const glass = lobes(Vec3(0.5), Vec3(1), 0.25, 0.75);
  check_color(glass.diffuse, Vec3(0));
  check_color(glass.f0, Vec3(0));
}

TEST_CASE("a glTF material's defaults are a rough, white metal", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  BsdfParameters const metal = of_pbr(default_pbr());
  check_color(metal.metal, Vec3(1));
  CHECK(metal.metallic == 1);
  CHECK(metal.alpha == 1);
  CHECK(metal.is_layered == 1);
  CHECK(metal.opacity == 1);
  check_color(metal.diffuse, Vec3(0));
  check_color(metal.transmitted, Vec3(0));
  check_color(metal.translucent, Vec3(0));
  check_color(metal.emission, Vec3(0));
  CHECK(metal.mirror == 0);
  CHECK(metal.glass == 0);
  CHECK(metal.coat == 0);
  CHECK(metal.ior == 1);
}

TEST_CASE("a glTF dielectric reflects as its index of refraction and its specular factors say", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.metallic = 0;
  material.roughness = 0.5f;
  material.base_color[1] = 0.5f;
  material.emissive[0] = 7;
  BsdfParameters const plain = of_pbr(material);
  check_color(plain.f0, Vec3(0.04));
  check_color(plain.f90, Vec3(1));
  check_color(plain.diffuse, {1, 0.5, 1});
  check_color(plain.emission, {7, 0, 0});
  CHECK(plain.metallic == 0);
  CHECK(plain.alpha == 0.25f);

  material.ior = 0;  // KHR_materials_ior: all is reflected
  check_color(of_pbr(material).f0, Vec3(1));
  material.ior = 1;
  check_color(of_pbr(material).f0, Vec3(0));

  material.ior = 1.5f;
  material.specular = 0.5f;
  material.specular_color[0] = 2;
  material.specular_color[2] = 100;  // f0 is at most 1 before the factor
  BsdfParameters const specular = of_pbr(material);
  check_color(specular.f0, {0.04, 0.02, 0.5});
  check_color(specular.f90, Vec3(0.5));

  material.metallic = 0.25f;
  BsdfParameters const mixed = of_pbr(material);
  CHECK(mixed.metallic == 0.25f);
  check_color(mixed.f0, {0.04, 0.02, 0.5});  // the dielectric's as before ...
  check_color(mixed.metal, {1, 0.5, 1});
  check_color(mixed.diffuse, {0.75, 0.375, 0.75});  // ... and less below it

  material.roughness = 0;
  CHECK(of_pbr(material).alpha == 0.001f);
}

TEST_CASE("glTF's transmission is a thin wall without thickness, a solid with it", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.metallic = 0.5f;
  material.transmission = 0.25f;
  material.ior = 1.4f;
  set_color(material.attenuation_color, 0.5);
  material.attenuation_distance = 4;
  BsdfParameters const thin = of_pbr(material);
  check_color(thin.transmitted, Vec3(0.125));
  check_color(thin.diffuse, Vec3(0.375));
  CHECK(thin.ior == 1);
  CHECK(thin.inverse_attenuation_distance == 0);

  material.thickness = 0.1f;
  BsdfParameters const solid = of_pbr(material);
  check_color(solid.transmitted, Vec3(0.125));
  CHECK(solid.ior == 1.4f);
  CHECK(solid.inverse_attenuation_distance == 0.25f);
  check_color(solid.attenuation_color, Vec3(0.5));
  check_color(solid.f0, Vec3(1.0 / 36));

  material.ior = 0;  // infinite: all is reflected, and nothing is refracted
  CHECK(of_pbr(material).ior == 1);
  material.ior = 1.4f;
  material.attenuation_distance = float_infinity;
  CHECK(of_pbr(material).inverse_attenuation_distance == 0);
  material.transmission = 0;
  CHECK(of_pbr(material).ior == 1);
}

TEST_CASE("glTF's dispersion spreads a solid's index of refraction", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.metallic = 0;
  material.transmission = 0.5f;
  material.ior = 1.8f;
  material.dispersion = 2;
  CHECK(of_pbr(material).ior_spread == 0);  // a thin wall bends nothing
  material.thickness = 1;
  BsdfParameters const prism = of_pbr(material);
  CHECK(prism.ior_spread == Approx(0.04));  // Abbe's number is 10
  check_color(prism.f0, {std::pow(0.76 / 2.76, 2), std::pow(0.8 / 2.8, 2), std::pow(0.84 / 2.84, 2)});
  material.dispersion = 1000;
  CHECK(of_pbr(material).ior_spread == Approx(0.8));  // red's index is 1
  for (float const none : {0.f, -1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.dispersion = none;
    CHECK(of_pbr(material).ior_spread == 0);
  }
  material.dispersion = 2;
  for (float const none : {0.f, 1.f}) {  // 0: infinite
    material.ior = none;
    CHECK(of_pbr(material).ior_spread == 0);
  }
}

TEST_CASE("glTF's anisotropy makes microfacets rougher along x", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.roughness = 0.5f;
  auto const check_widths = [&](double along_x, double along_y) {
    BsdfParameters const p = of_pbr(material);
    CHECK(p.alpha * p.stretch == Approx(along_x));
    CHECK(p.alpha / p.stretch == Approx(along_y));
  };
  CHECK(of_pbr(material).stretch == 1);
  CHECK(of_pbr(material).alpha == 0.25f);
  material.anisotropy = 0.5f;
  check_widths(0.25 + 0.25 * 0.75, 0.25);
  material.anisotropy = 1;
  check_widths(1, 0.25);
  material.roughness = 0;
  check_widths(1, 0.001);
  material.roughness = 1;
  CHECK(of_pbr(material).stretch == 1);
  material.roughness = 0.5f;
  material.anisotropy = 7;
  check_widths(1, 0.25);
  for (float const none : {-1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.anisotropy = none;
    check_widths(0.25, 0.25);
  }
}

TEST_CASE("glTF's diffuse transmission takes its share of the matt lobe, in its own colour", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.metallic = 0.5f;
  material.transmission = 0.5f;
  material.diffuse_transmission = 0.25f;
  set_color(material.base_color, 0.8);
  material.diffuse_transmission_color[1] = 0.5f;
  material.diffuse_transmission_color[2] = 9;
  BsdfParameters const leaf = of_pbr(material);
  check_color(leaf.diffuse, Vec3(0.5 * 0.5 * 0.75 * 0.8));
  check_color(leaf.translucent, Vec3(1, 0.5, 1) * (0.5 * 0.5 * 0.25));
  check_color(leaf.transmitted, Vec3(0.5 * 0.5 * 0.8));
  material.diffuse_transmission = 3;
  check_color(of_pbr(material).diffuse, Vec3(0));
  for (float const none : {-1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.diffuse_transmission = none;
    check_color(of_pbr(material).translucent, Vec3(0));
  }
  // What lets light through has a back, and a volume where it is a body.
  material.transmission = 0;
  material.thickness = 1;
  material.attenuation_distance = 2;
  for (float const share : {0.f, 0.5f}) {
    material.diffuse_transmission = share;
    BsdfParameters const body = of_pbr(material);
    CHECK(body.shows_back == (share > 0 ? 1.f : 0.f));
    CHECK(body.inverse_attenuation_distance == share);
  }
}

TEST_CASE("glTF's iridescence is a film where it has a thickness", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  CHECK(of_pbr(material).film == 0);
  material.iridescence = 0.5f;
  BsdfParameters const film = of_pbr(material);
  CHECK(film.film == 0.5f);
  CHECK(film.film_ior == 1.3f);
  CHECK(film.film_thickness == 400);  // the maximum, where no texture says otherwise
  material.iridescence = 3;
  material.iridescence_ior = 0.5f;
  CHECK(of_pbr(material).film == 1);
  CHECK(of_pbr(material).film_ior == 1);
  material.unlit = 1;
  CHECK(of_pbr(material).film == 0);
  material.unlit = 0;
  for (float const none : {0.f, -1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.iridescence_thickness_maximum = none;
    CHECK(of_pbr(material).film == 0);
  }
  material.iridescence_thickness_maximum = 400;
  for (float const none : {-1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.iridescence = none;
    CHECK(of_pbr(material).film == 0);
  }
}

TEST_CASE("glTF's sheen is what its factors say, within what makes sense", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  check_color(of_pbr(material).sheen, Vec3(0));
  for (int c = 0; c < 3; ++c) material.sheen_color[c] = 0.25f * float(c + 1);
  material.sheen_roughness = 0.5f;
  BsdfParameters const cloth = of_pbr(material);
  check_color(cloth.sheen, {0.25, 0.5, 0.75});
  CHECK(cloth.sheen_alpha == 0.25f);
  set_color(material.sheen_color, 7);
  material.sheen_roughness = 3;
  check_color(of_pbr(material).sheen, Vec3(1));
  CHECK(of_pbr(material).sheen_alpha == 1);
  for (float const none : {0.f, -1.f, std::numeric_limits<float>::quiet_NaN()}) {
    material.sheen_roughness = none;
    set_color(material.sheen_color, none);
    check_color(of_pbr(material).sheen, Vec3(0));
    CHECK(of_pbr(material).sheen_alpha == 0.07f * 0.07f);
  }
}

TEST_CASE("glTF's coat, alpha and unlit materials", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  device::PbrMaterial material = default_pbr();
  material.clearcoat = 0.5f;
  material.clearcoat_roughness = 0.5f;
  material.alpha = 0.25f;
  BsdfParameters const opaque = of_pbr(material);
  CHECK(opaque.coat == 0.5f);
  CHECK(opaque.coat_alpha == 0.25f);
  CHECK(opaque.opacity == 1);
  material.alpha_mode = ALPHA_MASK;
  CHECK(of_pbr(material).opacity == 1);  // what is cut out, traversal does not meet
  material.alpha_mode = ALPHA_BLEND;
  CHECK(of_pbr(material).opacity == 0.25f);

  material.unlit = 1;
  set_color(material.sheen_color, 1);
  material.transmission = 1;
  set_color(material.emissive, 5);
  set_color(material.base_color, 0.5);
  BsdfParameters const unlit = of_pbr(material);
  check_color(unlit.emission, Vec3(0.5));
  for (auto const& color :
       {unlit.diffuse, unlit.f0, unlit.f90, unlit.metal, unlit.transmitted, unlit.translucent, unlit.sheen}) {
    CHECK(max_abs(to_vec3(color)) == 0);
  }
  CHECK(unlit.coat == 0);
  CHECK(unlit.metallic == 0);
  CHECK(unlit.opacity == 0.25f);
}
