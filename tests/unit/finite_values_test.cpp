#include <cmath>
#include <stdexcept>

#include "lichtraum/orbit.hpp"
#include "lichtraum/renderer.hpp"
#include "support/catch.hpp"
#include "support/gltf_import.hpp"

// Numbers that nothing can be drawn of are refused where somebody gives them to the library. Files are read before.

using namespace lichtraum;

namespace {

double const bad_numbers[] = {double(NAN), double(INFINITY), -double(INFINITY)};

/// The vectors that have one such coordinate.
std::vector<Vec3> bad_vectors() {
  std::vector<Vec3> vectors;
  for (double const bad : bad_numbers) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 vector(1, 2, 3);
      vector[axis] = bad;
      vectors.push_back(vector);
    }
  }
  return vectors;
}

template <class Make>
void check_is_refused(Make const& make) {
  CHECK_THROWS_AS(make(), std::invalid_argument);
}

/// A scene with one thing changed, made ready to be drawn.
template <class Change>
void check_is_refused_in_a_scene(Change const& change) {
  Scene scene;
  scene.environment = EnvironmentLight{"grey", uniform_environment(1, 1, 1)};
  auto const renderer = make_renderer(reference_device());
  CHECK_NOTHROW(renderer->prepare(scene));
  change(scene);
  check_is_refused([&] { renderer->prepare(scene); });
}

}  // namespace

TEST_CASE("shapes and transforms are made of finite numbers", "[unit]") {
  for (Vec3 const& bad : bad_vectors()) {
    CAPTURE(bad.x, bad.y, bad.z);
    check_is_refused([&] { Sphere("s", bad, 1, nullptr); });
    check_is_refused([&] { Box("b", bad, {0, 0, 0}, nullptr); });
    check_is_refused([&] { Box("b", {0, 0, 0}, bad, nullptr); });
    check_is_refused([&] { Triangle("t", bad, {1, 0, 0}, {0, 1, 0}, nullptr); });
    check_is_refused([&] { Triangle("t", {1, 0, 0}, {0, 1, 0}, bad, nullptr); });
    check_is_refused([&] { Cylinder("c", bad, {0, 0, 0}, 1, nullptr); });
    check_is_refused([&] { Cone("c", {0, 0, 0}, bad, 1, nullptr); });
    check_is_refused([&] { Plane("p", bad, {0, 1, 0}, nullptr); });
    check_is_refused([&] { Transform::translation(bad); });
    check_is_refused([&] { Transform::rotation(30, bad); });
    check_is_refused([&] { Transform::scaling(bad); });
    check_is_refused([&] { Transform::look_along(bad, {0, 0, 1}, {0, 1, 0}); });
    check_is_refused([&] { Transform::look_along({}, bad, {0, 1, 0}); });
    check_is_refused([&] { Transform::look_along({}, {0, 0, 1}, bad); });
    check_is_refused([&] { orbit_rotation({}, bad); });
  }
  for (double const bad : bad_numbers) {
    check_is_refused([&] { Transform::rotation(bad, {0, 1, 0}); });
    check_is_refused([&] { orbit_rotation({bad, 0}); });
    Mat4 matrix(1);
    matrix[1][2] = bad;
    check_is_refused([&] { Transform::from_matrix(matrix); });
  }
}

TEST_CASE("lights are made of finite numbers", "[unit]") {
  for (Vec3 const& bad : bad_vectors()) {
    check_is_refused([&] { Light::ambient("l", bad); });
    check_is_refused([&] { Light::point("l", bad, Rgb(1)); });
    check_is_refused([&] { Light::point("l", {}, bad); });
    check_is_refused([&] { Light::point("l", {}, Rgb(1), bad); });
    check_is_refused([&] { Light::directional("l", bad, Rgb(1)); });
    check_is_refused([&] { Light::spot("l", {}, bad, Rgb(1), {0, 30}); });
  }
  CHECK_NOTHROW(Light::falling_off("l", {}, Rgb(1), INFINITY));
  check_is_refused([&] { Light::falling_off("l", {}, Rgb(1), NAN); });
  check_is_refused([&] { Light::spot("l", {}, {0, 0, 1}, Rgb(1), {NAN, 30}); });
}

TEST_CASE("materials are made of finite numbers", "[unit]") {
  for (Vec3 const& bad : bad_vectors()) {
    check_is_refused([&] { Material("m", bad, Rgb(1), Rgb(1), 1); });
    check_is_refused([&] { Material("m", PhongModel{.emission = bad}); });
    check_is_refused([&] { Material("m", PbrModel{.base_color = bad}); });
  }
  for (double const bad : bad_numbers) {
    check_is_refused([&] { Material("m", Rgb(1), Rgb(1), Rgb(1), bad); });
    check_is_refused([&] { Material("m", PhongModel{.ior = bad}); });
    check_is_refused([&] { Material("m", PbrModel{.roughness = bad}); });
    TextureSlot slot;
    slot.scale.y = bad;
    check_is_refused([&] { Material("m", PbrModel{.normal_texture = slot}); });
  }
  CHECK_NOTHROW(Material("m", PbrModel{.attenuation_distance = INFINITY}));
  check_is_refused([&] { Material("m", PbrModel{.attenuation_distance = NAN}); });
  CHECK_THROWS_WITH(Material("m", PbrModel{.thickness = INFINITY}), "a material's thickness must be finite");
}

TEST_CASE("scenes are drawn of finite numbers", "[unit]") {
  for (double const bad : bad_numbers) {
    check_is_refused_in_a_scene([&](Scene& scene) { scene.up.x = bad; });
    check_is_refused_in_a_scene([&](Scene& scene) { scene.environment->brightness = bad; });
    check_is_refused_in_a_scene([&](Scene& scene) { scene.environment->rotation_degrees = bad; });
  }
  check_is_refused_in_a_scene([](Scene& scene) { scene.up = Vec3(0); });
}

TEST_CASE("a camera that is to see more than numbers reach stands within", "[unit][camera]") {
  CameraFit fit;
  fit.extent = 1;
  fit.framed = CameraFit::Framed{{Vec3(-1e300), Vec3(1e300)}};
  Camera camera("c", 45);
  camera.set_fit(fit);
  CHECK(camera.fitted({640, 480}).world_from_camera().point(Vec3(0)) == Vec3(0));
}

TEST_CASE("a model's numbers that are too large to be multiplied are left out", "[unit][gltf]") {
  testing::GltfWriter writer;
  writer.add_mesh(testing::triangle_positions)["material"] = 0;
  writer.json["materials"] = {{{"emissiveFactor", {1e200, 1, 1}},
                               {"extensions",
                                {{"KHR_materials_emissive_strength", {{"emissiveStrength", 1e200}}},
                                 {"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {1e200, 1, 1, 1}}}}}}}};
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 1e200}, {"color", {1e200, 1, 1}}}};
  writer.json["nodes"].push_back({{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  Model const model = testing::import_model(writer);
  CHECK(!model.scene.lights.find("lamp"));
  REQUIRE(model.scene.materials.size() == 1);
  PbrModel const* const pbr = model.scene.materials.front()->pbr();
  REQUIRE(pbr);
  CHECK(pbr->emissive == Rgb(0));
  CHECK(pbr->base_color == Rgb(1));
}

TEST_CASE("models of the largest numbers are read, however little is seen of them", "[unit][gltf]") {
  for (char const* const key : {"translation", "scale"}) {
    for (double const size : {1e38, 1e100, 1e160, 1e300, 1.7e308}) {
      CAPTURE(key, size);
      testing::GltfWriter writer;
      writer.add_mesh({-3e38f, 0, 0, 3e38f, 0, 0, 0, 3e38f, 0});
      writer.json["nodes"][0][key] = {size, -size, size};
      writer.json["nodes"].push_back({{"children", {0}}, {key, {size, size, size}}});
      writer.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 1}}}}};
      writer.json["nodes"].push_back({{"camera", 0}, {key, {size, size, size}}});
      for (auto const& nodes : {nlohmann::json{0}, nlohmann::json{1}, nlohmann::json{1, 2}}) {
        writer.json["scenes"] = {{{"nodes", nodes}}};
        try {
          testing::import_model(writer);
        } catch (Error const& error) {
          CHECK(error.kind() == ErrorKind::scene);
        }
      }
    }
  }
}
