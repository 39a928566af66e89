#include "view/values_as_esdf.hpp"

#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

void check_same(Material const& material) {
  Scene const scene = scene_of(view::material_as_esdf(material));
  REQUIRE(scene.materials.size() == 1);
  Material const& copy = **scene.materials.begin();
  PhongModel const a = material.phong(), b = copy.phong();
#define CHECK_FIELD(name, ...) CHECK(a.name == b.name);
  PHONG_FIELDS(CHECK_FIELD, CHECK_FIELD, CHECK_FIELD)
#undef CHECK_FIELD
}

}  // namespace

TEST_CASE("a material that is copied as eSDF is the same", "[unit][view]") {
  check_same(Material("red", {0.1, 0.2, 1.0 / 3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}, 12.5));
  check_same(Material("glass", PhongModel{.reflect = 0.25, .transmit = 0.5, .ior = 1.5, .emission = Rgb(1, 2, 3)}));
  check_same(Material("two words # and a mark", PbrModel{}));
  CHECK((*scene_of(view::material_as_esdf(Material("two words", PhongModel{}))).materials.begin())->name() ==
        "two_words");
}

TEST_CASE("a light that is copied as eSDF is the same, where eSDF has one", "[unit][view]") {
  auto const copy_of = [](Light const& light) {
    Scene const scene = scene_of(view::light_as_esdf(light));
    REQUIRE(scene.lights.size() == 1);
    return *scene.lights.begin();
  };
  for (Rgb const& la : {Rgb(0), Rgb(0.1, 0.2, 0.3)}) {
    Light const copy = copy_of(Light(
        "lamp", PointLight{.ld = Rgb(0.5, 0.25, 1.0 / 3), .la = la, .position = Vec3(1, -2, 3e-7), .radius = 0.5}));
    auto const* const lamp = copy.get<PointLight>();
    REQUIRE(lamp);
    CHECK(lamp->ld == Rgb(0.5, 0.25, 1.0 / 3));
    CHECK(lamp->la == la);
    CHECK(lamp->position == Vec3(1, -2, 3e-7));
    CHECK(lamp->radius == 0.5);
  }
  CHECK(copy_of(Light::ambient("sky", Rgb(0.5, 0.6, 0.7))).la() == Rgb(0.5, 0.6, 0.7));
  for (Light const& none :
       {Light::directional("sun", Vec3(0, -1, 0), Rgb(1)), Light::falling_off("bulb", Vec3(0), Rgb(1), 5)}) {
    CHECK(view::light_as_esdf(none).starts_with("# "));
    CHECK(scene_of(view::light_as_esdf(none)).lights.empty());
  }
}
