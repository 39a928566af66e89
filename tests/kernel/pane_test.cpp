/// What rays to lights find left of each colour behind panes, against the formula of docs/GLTF.md.

#include <cmath>
#include <memory>

#include "compile/scene_buffers.hpp"
#include "reference.hpp"
#include "scene/flatten.hpp"
#include "scene_arguments.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/opencl_probe.hpp"
#include "support/pbr.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

PbrModel tinted_pane() {
  PbrModel model = pbr({0.9, 0.5, 0.25}, 0.25, 0.02);
  model.transmission = 0.75;
  model.ior = 1.8;
  model.specular = 0.5;
  model.specular_color = {1, 0.5, 3};
  return model;
}

/// From above to below the middle of what lies there, in a direction that has this slope.
Rgb visibility(Scene const& scene, TreeLayout layout, double tangent) {
  auto const buffers = compile_scene(flatten(scene.roots()), scene.lights, layout);
  ProbeProgram const program("pane.cl", scene_options(buffers) + " -D LIGHT_PASSES_GLASS=0");
  Vec3 const direction = glm::normalize(Vec3(tangent, -1, 0));
  Vec3 const origin = Vec3(0.1, 0, 0.2) - 4.0 * direction;
  std::vector<float4> const origins{to_float4(origin)}, directions{to_float4(direction)};
  std::vector<float4> found(1);
  std::vector<ProbeArgument> arguments = scene_arguments(buffers);
  arguments.insert(arguments.end(), {in(origins), in(directions), value(8.0f), out(found)});
  program.run("probe_visibility", 1, arguments);
  return to_vec3(found[0]);
}

void check(Rgb const& found, Rgb const& expected) {
  for (int c = 0; c < 3; ++c) CHECK(found[c] == Approx(expected[c]).margin(1e-6));
}

Scene scene_with(char const* things, Material::Model const& model) {
  Scene scene = scene_of(std::string("define material m 0 0 0  1 1 1  0 0 0 1\n") + things);
  *(*scene.materials.find("m")) = Material("m", model);
  return scene;
}

constexpr char const* sheet = "define shape triangle t -9 0 -9  9 0 -9  0 0 9 m\n";
/// In a group that is stretched, turned and moved.
constexpr char const* stretched_sheet =
    "define shape triangle t -9 4.5 -18  9 -4.5 -18  0 0 18 m\n"
    "define shape composite g t\ntransform g scale 1 2 0.5\ntransform g rotate 20 0 0 1\n"
    "transform g translate 0 0.5 0\n";

}  // namespace

TEST_CASE("Rays to lights pass panes in the share that the surface leaves, in their colour", "[kernel][panes]") {
  NEEDS_OPENCL_DEVICE();
  double const ratio = (0.8 / 2.8) * (0.8 / 2.8);
  double const f0 = 0.5 * 3 * ratio;  // of the channel that reflects most, which is what all of them lose
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    for (double const tangent : {0.0, 0.5, 3.0, 12.0}) {
      INFO("tangent " << tangent);
      double const grazing = std::pow(1 - 1 / std::sqrt(1 + tangent * tangent), 5);
      double const left = 1 - (f0 + (0.5 - f0) * grazing);
      Rgb const expected = left * Rgb(0.9, 0.5, 0.25) * (0.75 * 0.75);
      check(visibility(scene_with(sheet, tinted_pane()), layout, tangent), expected);

      PbrModel blended = tinted_pane();
      blended.alpha_mode = AlphaMode::blend;
      blended.alpha = 0.5;
      check(visibility(scene_with(sheet, blended), layout, tangent), 0.5 + 0.5 * expected);
    }
  }
}

TEST_CASE("What a pane lets through depends on its angle in the world, not in its object", "[kernel][panes]") {
  NEEDS_OPENCL_DEVICE();
  Scene const scene = scene_with(stretched_sheet, tinted_pane());
  Transform const world = scene.shapes.find("g")->get()->world_from_object();
  Vec3 const a = world.point({-9, 4.5, -18}), b = world.point({9, -4.5, -18}), c = world.point({0, 0, 18});
  Vec3 const normal = glm::normalize(glm::cross(b - a, c - a));
  double const ratio = (0.8 / 2.8) * (0.8 / 2.8);
  double const f0 = 0.5 * 3 * ratio;  // of the channel that reflects most, which is what all of them lose
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    for (double const tangent : {0.0, 0.3, 0.8}) {
      double const cosine = std::abs(glm::dot(normal, glm::normalize(Vec3(tangent, -1, 0))));
      double const left = 1 - (f0 + (0.5 - f0) * std::pow(1 - cosine, 5));
      check(visibility(scene, layout, tangent), left * Rgb(0.9, 0.5, 0.25) * (0.75 * 0.75));
    }
  }
}

TEST_CASE("What refracts, scatters, shines or is covered is no pane, and stops rays to lights", "[kernel][panes]") {
  NEEDS_OPENCL_DEVICE();
  std::vector<std::pair<char const*, PbrModel>> cases;
  auto const add = [&](char const* name, auto const& change) {
    PbrModel model = tinted_pane();
    change(model);
    cases.emplace_back(name, model);
  };
  add("thick", [](PbrModel& m) { m.thickness = 1; });
  add("rough", [](PbrModel& m) { m.roughness = 0.05; });
  add("opaque", [](PbrModel& m) { m.transmission = 0; });
  add("metal", [](PbrModel& m) { m.metallic = 1; });
  add("unlit", [](PbrModel& m) { m.unlit = true; });
  add("coated", [](PbrModel& m) { m.clearcoat = 1; });
  add("cloth", [](PbrModel& m) { m.sheen_color = Rgb(0, 0.5, 0); });
  add("iridescent", [](PbrModel& m) { m.iridescence = 1; });
  add("brushed", [](PbrModel& m) { m.anisotropy = 1; });
  add("paper", [](PbrModel& m) { m.diffuse_transmission = 1; });
  add("lamp", [](PbrModel& m) { m.emissive = Rgb(0, 0, 1); });
  // Whether it is smooth is then known at each point only. These triangles have no place in a texture, so it is rough.
  add("rough by its texture", [](PbrModel& m) {
    TextureImage const white{"white", 1, 1, {255, 255, 255, 255}};
    m.metallic_roughness_texture.texture = std::make_shared<Texture>(Texture{std::make_shared<TextureImage>(white)});
    m.roughness = 0.5;
  });
  // The pane that lies aside asks for all of the code.
  std::string const aside = "define material p 0 0 0  1 1 1  0 0 0 1 transmit=0.5\ndefine shape sphere s 99 0 0 1 p\n";
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    for (auto const& [name, model] : cases) {
      INFO(name);
      check(visibility(scene_with((aside + sheet).c_str(), model), layout, 0.5), Rgb(0));
      check(visibility(scene_with((aside + "define shape sphere t 0 0 0 1 m\n").c_str(), model), layout, 0), Rgb(0));
    }
    // Walls are triangles: a ball is none.
    check(visibility(scene_with((aside + "define shape sphere t 0 0 0 1 m\n").c_str(), tinted_pane()), layout, 0),
          Rgb(0));
  }
}

TEST_CASE("eSDF's glass is a pane of any shape where it does not refract", "[kernel][panes]") {
  NEEDS_OPENCL_DEVICE();
  PhongModel const clear{.kd = Rgb(0.5), .ks = Rgb(0.5), .reflect = 0.1, .transmit = 0.6};
  PhongModel refracting = clear, lamp = clear;
  refracting.ior = 1.2;
  lamp.emission = Rgb(0, 1, 0);
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    check(visibility(scene_with(sheet, clear), layout, 3), Rgb(0.6));
    for (char const* const body : {"define shape sphere t 0 0 0 1 m\n", "define shape box t -1 -1 -1  1 1 1 m\n",
                                   "define shape cylinder t 0 -1 0  0 1 0 1 m\n"}) {
      INFO(body);
      check(visibility(scene_with(body, clear), layout, 0.1), Rgb(0.36));
      check(visibility(scene_with(body, refracting), layout, 0.1), Rgb(0));
      check(visibility(scene_with(body, lamp), layout, 0.1), Rgb(0));
    }
  }
}
