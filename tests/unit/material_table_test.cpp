#include "compile/material_table.hpp"

#include <memory>
#include <utility>

#include "shared/scene_arrays.h"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

device::uint features(Material::Model model) { return features_of(Material("", std::move(model))); }

/// Smooth glass without thickness, which light goes straight through.
PbrModel window_glass() {
  PbrModel m;
  m.metallic = 0;
  m.roughness = 0;
  m.transmission = 1;
  return m;
}

TextureSlot some_texture() {
  TextureSlot slot;
  slot.texture = std::make_shared<Texture const>();
  return slot;
}

}  // namespace

TEST_CASE("a material asks the kernels for what it needs, and for nothing else", "[unit][material]") {
  SECTION("Phong's") {
    PhongModel m;
    CHECK(features(m) == 0);
    m.transmit = 0.5;
    m.ior = 1.5;
    CHECK(features(m) == SCENE_TRANSPARENCY);
    m.ior = 1;
    CHECK(features(m) == (SCENE_TRANSPARENCY | SCENE_PANES));
    m.emission = Rgb(1);
    CHECK(features(m) == SCENE_TRANSPARENCY);
  }
  SECTION("glTF's, by how its alpha is meant") {
    PbrModel m;
    m.alpha = 0.5;
    CHECK(features(m) == SCENE_PBR);
    m.alpha_mode = AlphaMode::mask;
    CHECK(features(m) == (SCENE_PBR | SCENE_CUTOUTS));
    m.alpha_mode = AlphaMode::blend;
    CHECK(features(m) == (SCENE_PBR | SCENE_CUTOUTS | SCENE_TRANSPARENCY));
  }
  SECTION("glTF's, by what lets light through") {
    PbrModel m = window_glass();
    device::uint const glass = SCENE_PBR | SCENE_TRANSPARENCY;
    CHECK(features(m) == (glass | SCENE_PANES));
    m.thickness = 1;
    CHECK(features(m) == glass);
    m.transmission_texture = some_texture();  // in some points more than in others
    CHECK(features(m) == (glass | SCENE_CUTOUTS));
    m.transmission_texture = {};
    m.metallic_roughness_texture = some_texture();
    CHECK(features(m) == (glass | SCENE_CUTOUTS));
  }
  SECTION("what bends or hides light is no pane") {
    auto const is_pane = [](auto const& change) {
      PbrModel m = window_glass();
      change(m);
      return (features(m) & SCENE_PANES) != 0;
    };
    CHECK(is_pane([](PbrModel& m) { m.metallic_roughness_texture = some_texture(), m.roughness = 1; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.roughness = 0.5; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.clearcoat = 1; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.sheen_color = Rgb(1); }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.iridescence = 1; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.anisotropy = 1; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.diffuse_transmission = 1; }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.emissive = Rgb(1); }));
    CHECK_FALSE(is_pane([](PbrModel& m) { m.unlit = true; }));
  }
  SECTION("tangents, for what differs around the normal, and coats that follow the mesh's") {
    auto const has_tangents = [](auto const& change) {
      PbrModel m;
      change(m);
      return (features(m) & SCENE_TANGENTS) != 0;
    };
    CHECK(has_tangents([](PbrModel& m) { m.anisotropy = 0.5; }));
    CHECK(has_tangents([](PbrModel& m) { m.clearcoat = 1, m.normal_texture = some_texture(); }));
    CHECK(has_tangents([](PbrModel& m) { m.clearcoat = 1, m.clearcoat_normal_texture = some_texture(); }));
    CHECK_FALSE(has_tangents([](PbrModel& m) { m.clearcoat = 1; }));
    CHECK_FALSE(has_tangents([](PbrModel& m) { m.normal_texture = some_texture(); }));
    CHECK_FALSE(has_tangents([](PbrModel& m) { m.anisotropy = 0.5, m.unlit = true; }));
  }
}
