#include "lichtraum/scene_edits.hpp"

#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/textured_meshes.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Resolution const size{80, 60};

/// Two balls of one material each, an instance of many, lights of eSDF; `red`, `green` and `sun` are what is edited.
std::string scene_text(std::string const& red, std::string const& sun) {
  std::string text = "define material red " + red +
                     "\ndefine material green 0.1 0.5 0.1  0.1 0.5 0.1  0 0 0  1\n"
                     "define light ambient sky 0.2 0.2 0.3\ndefine light diffuse sun " +
                     sun +
                     "\ndefine shape sphere a -1 0 0  0.8 red\ndefine shape sphere b 1 0 0  0.8 green\n"
                     "define shape box floor -9 -2 -9  9 -1 9 green\n";
  std::string names;
  for (int i = 0; i < 10; ++i) {
    std::string const number = std::to_string(i);
    text += "define shape sphere s" + number + " " + number + " 0 0 0.4 red\n";
    names += " s" + number;
  }
  return text + "define shape composite row" + names +
         "\ndefine shape composite left row\ntransform left translate -4 1.5 -2\n"
         "define shape composite right row\ntransform right translate -4 2.5 -3\n"
         "define camera eye 50\ntransform eye translate 0 1 6\n";
}

std::string const plain_red = "0.8 0.1 0.1  0.8 0.1 0.1  0 0 0  1", plain_sun = "3 5 6  1 1 1";

std::vector<Light> lights_of(Scene const& scene) { return {scene.lights.begin(), scene.lights.end()}; }

template <class Check>
void for_each_renderer(Check const& check) {
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [layout, traversal] : layouts_of(device)) {
      INFO("device " << device.index << ", " << layout);
      check(*make_renderer(device, traversal));
    }
  }
  INFO("reference");
  check(*make_renderer(reference_device()));
}

Image draw(Renderer& renderer, std::shared_ptr<PreparedScene const> const& prepared, Scene const& scene) {
  renderer.set_scene(prepared);
  Image image;
  render_image(renderer, whole_picture(scene.cameras.front(), size), image);
  return image;
}

}  // namespace

TEST_CASE("an edited scene looks as if it had been written so", "[image][edits]") {
  REQUIRE_OPENCL_DEVICE();
  // Matt becomes glass and mirror: shadows let light through, rays go on.
  std::string const glass = "0.1 0.1 0.9  0 0 0.3  0.5 0.5 0.5  40 reflect=0.2 transmit=0.7 ior=1.4";
  Scene const scene = scene_of(scene_text(plain_red, plain_sun));
  Scene const wanted = scene_of(scene_text(glass, "-4 6 5  1.2 0.9 0.4"));
  SceneEdits edits;
  edits.lights = lights_of(wanted);
  edits.materials.emplace(scene.materials.find("red")->get(), **wanted.materials.find("red"));
  for_each_renderer([&](Renderer& renderer) {
    auto const prepared = renderer.prepare(scene);
    Image const before = draw(renderer, prepared, scene);
    Image const expected = draw(renderer, renderer.prepare(wanted), wanted);
    REQUIRE(expected.data() != before.data());
    auto const edited = renderer.edit(prepared, edits);
    CHECK(draw(renderer, edited, scene).data() == expected.data());
    CHECK(edited->fingerprint == renderer.prepare(wanted)->fingerprint);
    CHECK(renderer.edit(edited, edits)->fingerprint == edited->fingerprint);
    CHECK(prepared->fingerprint == make_renderer(reference_device())->prepare(scene)->fingerprint);
    CHECK(edited->fingerprint != prepared->fingerprint);
    // And back.
    CHECK(draw(renderer, prepared, scene).data() == before.data());
    edits.lights = lights_of(scene);
    SceneEdits const none{edits.lights, {}};
    CHECK(draw(renderer, renderer.edit(prepared, none), scene).data() == before.data());
    CHECK(renderer.edit(prepared, none)->fingerprint == prepared->fingerprint);
    edits.lights = lights_of(wanted);
  });
}

TEST_CASE("an edited material keeps its textures", "[image][edits]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = make_textured_scene();
  Scene wanted = make_textured_scene();
  SceneEdits edits;
  edits.lights = lights_of(scene);
  for (auto const& material : scene.materials) {
    if (!material->pbr()) continue;
    auto pbr = *material->pbr();
    pbr.base_color.g *= 0.4;
    pbr.roughness = 0.3;
    pbr.emissive += Rgb(0, 0, 0.2);
    Material const changed(material->name(), pbr);
    edits.materials.emplace(material.get(), changed);
    **wanted.materials.find(material->name()) = changed;
  }
  REQUIRE(!edits.materials.empty());
  for_each_renderer([&](Renderer& renderer) {
    auto const prepared = renderer.prepare(scene);
    Image const expected = draw(renderer, renderer.prepare(wanted), scene);
    CHECK(draw(renderer, prepared, scene).data() != expected.data());
    CHECK(draw(renderer, renderer.edit(prepared, edits), scene).data() == expected.data());
    CHECK(renderer.edit(prepared, edits)->fingerprint == renderer.prepare(wanted)->fingerprint);
    CHECK(prepared->fingerprint == make_renderer(reference_device())->prepare(scene)->fingerprint);
  });
}

TEST_CASE("after a scene was read again, its own materials are edited", "[image][edits]") {
  REQUIRE_OPENCL_DEVICE();
  auto const renderer = make_renderer(opencl_devices().front());
  Scene const first = scene_of(scene_text(plain_red, plain_sun)), again = scene_of(scene_text(plain_red, plain_sun));
  auto const prepared = renderer->prepare(again, {}, renderer->prepare(first));
  SceneEdits edits;
  edits.lights = lights_of(again);
  edits.materials.emplace(again.materials.find("red")->get(), Material("red", Rgb(0), Rgb(0), Rgb(0), 1));
  CHECK(draw(*renderer, renderer->edit(prepared, edits), again).data() != draw(*renderer, prepared, again).data());
  // What is prepared after an edited scene has its own materials.
  auto const after = renderer->prepare(again, {}, renderer->edit(prepared, edits));
  CHECK(after->fingerprint == prepared->fingerprint);
  CHECK(draw(*renderer, after, again).data() == draw(*renderer, prepared, again).data());
}

TEST_CASE("lights that nobody edited are the scene's, which may move", "[image][edits]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const moved_sun = "-4 6 5  0.3 0.9 0.4", blue = "0.1 0.1 0.9  0 0 0.3  0 0 0  1";
  Scene const scene = scene_of(scene_text(plain_red, plain_sun)), moved = scene_of(scene_text(plain_red, moved_sun));
  Scene const wanted = scene_of(scene_text(blue, moved_sun));
  for_each_renderer([&](Renderer& renderer) {
    auto const prepared = renderer.prepare(moved, {}, renderer.prepare(scene));
    SceneEdits edits;
    edits.materials.emplace(moved.materials.find("red")->get(), **wanted.materials.find("red"));
    auto const edited = renderer.edit(prepared, edits);
    auto const expected = renderer.prepare(wanted);
    CHECK(edited->fingerprint == expected->fingerprint);
    CHECK(draw(renderer, edited, moved).data() == draw(renderer, expected, wanted).data());
  });
}

TEST_CASE("without a scene there is nothing to draw", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  auto const renderer = make_renderer(opencl_devices().front());
  Film film;
  CHECK_THROWS_AS(renderer->render(whole_picture(Camera(), size), film), Error);
}

TEST_CASE("a scene that does not fit the device leaves the one before", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  DeviceInfo small_device = opencl_devices().front();
  small_device.max_allocation_bytes = 100'000;
  auto const renderer = make_renderer(small_device);
  auto const spheres = [](int count) {
    std::string text =
        "define camera eye 45\ndefine material m 1 1 1  1 1 1  0 0 0  1\ndefine light ambient sky 1 1 1\n";
    for (int i = 0; i < count; ++i) {
      text += "define shape sphere s" + std::to_string(i) + " " + std::to_string(i % 9 - 4) + " 0 -30 0.5 m\n";
    }
    return scene_of(text);
  };
  Scene const few = spheres(9);
  RenderRequest const request = whole_picture(few.cameras.front(), {64, 48});
  auto const draw = [&] {
    Film film;
    CHECK(renderer->render(request, film).statistics.rays.camera_hits > 0);
    auto const radiance = film.floats(FilmPlane::radiance);
    return std::vector<float>(radiance.begin(), radiance.end());
  };
  renderer->set_scene(few);
  auto const before = draw();
  CHECK_THROWS_AS(renderer->set_scene(spheres(20'000)), Error);
  CHECK(draw() == before);
  renderer->set_scene(few);
  CHECK(draw() == before);
}
