#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "lichtraum/device.hpp"
#include "lichtraum/renderer.hpp"
#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

/// A scene with something of every kind, all of it still open to change.
struct Draft {
  std::string prefix;  // of every name

  Vec3 center{0};
  double radius = 1;
  Transform world_from_ellipsoid = Transform::scaling({1, 2, 3});
  Vec3 box_max{1};
  Vec3 corner{0, 1, 0};
  MeshGeometry mesh;
  std::vector<Vec3> steps;  // of a row that is shown twice
  Transform world_from_row = Transform::translation({0, 0, 3});
  bool is_row_first = true;
  bool has_box = true;

  PhongModel phong;
  PbrModel pbr;
  bool is_ball_phong = true;
  TextureImage image{"", 2, 1, std::vector<std::uint8_t>(8, 100)};
  Texture texture;

  std::vector<Light::Model> lights{AmbientLight{}, PointLight{}, SpotLight{}, DirectionalLight{}};
  EnvironmentMap sky{2, 1, {1, 1, 1, 2, 2, 2}};
  std::optional<EnvironmentLight> environment{{"sky", nullptr, 0, 1}};
  Rgb background{0};
  ToneMap tone_map = ToneMap::none;
  Vec3 up{0, 1, 0};

  Draft() {
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, 1});
    mesh.texcoords.assign(2, {{0, 0}, {1, 0}, {0, 1}});
    mesh.colors.assign(3, {1, 1, 1, 1});
    for (int i = 0; i < 10; ++i) steps.emplace_back(i, 0, 0);
  }

  Scene scene() const {
    Scene made;
    auto const named = [&](std::string const& name) { return prefix + name; };
    auto const pictured = std::make_shared<Texture>(texture);
    pictured->image = std::make_shared<TextureImage>(image);
    PbrModel textured = pbr;
    for (auto const slot : texture_slots) {
      if (!(textured.*slot)) continue;  // what is there stands for the one picture
      (textured.*slot).texture = pictured;
    }
    auto const smooth = std::make_shared<Material>(named("smooth"), phong);
    auto const metal = std::make_shared<Material>(named("metal"), textured);
    made.materials.insert(smooth);
    made.materials.insert(metal);

    auto const show = [&](std::shared_ptr<Shape> const& shape) { made.shapes.insert(shape); };
    auto const row = std::make_shared<Composite>(named("row"));
    for (Vec3 const& step : steps) {
      auto const member =
          std::make_shared<Sphere>(named("step " + std::to_string(row->children().size())), step, 0.5, smooth);
      row->add(member);
    }
    auto const moved = std::make_shared<Composite>(named("moved"), Composite::Children{row});
    moved->apply(world_from_row);
    auto const rows = std::make_shared<Composite>(named("rows"), Composite::Children{row, moved});
    if (is_row_first) show(rows);
    show(std::make_shared<Sphere>(named("ball"), center, radius, is_ball_phong ? smooth : metal));
    if (!is_row_first) show(rows);
    auto const ellipsoid = std::make_shared<Sphere>(named("ellipsoid"), Vec3(0), 1, smooth);
    ellipsoid->apply(world_from_ellipsoid);
    show(ellipsoid);
    if (has_box) show(std::make_shared<Box>(named("box"), Vec3(0), box_max, nullptr));
    show(std::make_shared<Triangle>(named("triangle"), Vec3(0), Vec3(1, 0, 0), corner, smooth));
    show(std::make_shared<Mesh>(named("mesh"), std::make_shared<MeshGeometry>(mesh), metal));

    for (std::size_t i = 0; i < lights.size(); ++i) {
      made.lights.insert(Light(named("light " + std::to_string(i)), lights[i]));
    }
    if (environment) {
      made.environment = environment;
      made.environment->map = std::make_shared<EnvironmentMap>(sky);
    }
    made.background = background;
    made.tone_map = tone_map;
    made.up = up;
    return made;
  }

  std::string fingerprint() const {
    static auto const renderer = make_renderer(reference_device());
    return renderer->prepare(scene())->fingerprint;
  }
};

struct Change {
  std::string what;
  std::function<void(Draft&)> make;
};

void change(double& value) { value = std::isinf(value) ? 1 : value * 0.5 + 0.125; }
void change(Rgb& value) { value.g = value.g * 0.5 + 0.125; }
void change(bool& value) { value = !value; }
void change(AlphaMode& value) { value = AlphaMode::blend; }
void change(TextureSlot& slot) { slot.texture = slot ? nullptr : std::make_shared<Texture>(); }

std::vector<Change> material_changes() {
  std::vector<Change> changes;
#define LICHTRAUM_FIELD(name, ...) changes.push_back({"Phong's " #name, [](Draft& d) { change(d.phong.name); }});
  PHONG_FIELDS(LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD)
#undef LICHTRAUM_FIELD
#define LICHTRAUM_FIELD(name, ...) changes.push_back({"glTF's " #name, [](Draft& d) { change(d.pbr.name); }});
#define LICHTRAUM_MODE(type, name, initial) LICHTRAUM_FIELD(name)
  PBR_FIELDS(LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_MODE)
#undef LICHTRAUM_FIELD
#undef LICHTRAUM_MODE
  changes.push_back({"other material", [](Draft& d) { d.is_ball_phong = false; }});
  return changes;
}

std::vector<Change> texture_changes() {
  auto const slot = [](Draft& d) -> TextureSlot& { return d.pbr.base_color_texture; };
  return {{"texel", [](Draft& d) { ++d.image.rgba[7]; }},
          {"shape of the picture", [](Draft& d) { std::swap(d.image.width, d.image.height); }},
          {"wrap s", [](Draft& d) { d.texture.wrap_s = TextureWrap::clamp_to_edge; }},
          {"wrap t", [](Draft& d) { d.texture.wrap_t = TextureWrap::mirrored_repeat; }},
          {"filter", [](Draft& d) { d.texture.filter = TextureFilter::nearest; }},
          {"set of coordinates", [=](Draft& d) { slot(d).texcoord = 1; }},
          {"offset", [=](Draft& d) { slot(d).offset.y = 0.5; }},
          {"rotation", [=](Draft& d) { slot(d).rotation_radians = 0.5; }},
          {"scale", [=](Draft& d) { slot(d).scale.x = 2; }}};
}

std::vector<Change> shape_changes() {
  return {{"center", [](Draft& d) { d.center.z = 0.5; }},
          {"radius", [](Draft& d) { d.radius = 2; }},
          {"ellipsoid",
           [](Draft& d) {
             d.world_from_ellipsoid = Transform::scaling({1, 2, 4});
           }},
          {"box", [](Draft& d) { d.box_max.y = 2; }},
          {"no box", [](Draft& d) { d.has_box = false; }},
          {"triangle", [](Draft& d) { d.corner.x = 0.5; }},
          {"position", [](Draft& d) { d.mesh.positions[1][1] = 0.5f; }},
          {"winding", [](Draft& d) { std::swap(d.mesh.indices[0], d.mesh.indices[1]); }},
          {"normal",
           [](Draft& d) {
             d.mesh.normals[1] = {0, 1, 0};
           }},
          {"no normals", [](Draft& d) { d.mesh.normals.clear(); }},
          {"tangent", [](Draft& d) { d.mesh.tangents[2][3] = -1; }},
          {"texture coordinate", [](Draft& d) { d.mesh.texcoords[0][1][0] = 0.5f; }},
          {"colour", [](Draft& d) { d.mesh.colors[0][3] = 0.5f; }},
          {"inside of what is shown twice", [](Draft& d) { d.steps[5].y = 1; }},
          {"place of what is shown twice",
           [](Draft& d) {
             d.world_from_row = Transform::translation({0, 0, 4});
           }},
          {"order of objects and instances", [](Draft& d) { d.is_row_first = false; }}};
}

std::vector<Change> light_changes() {
  auto const point = [](Draft& d) -> PointLight& { return std::get<PointLight>(d.lights[1]); };
  auto const spot = [](Draft& d) -> SpotLight& { return std::get<SpotLight>(d.lights[2]); };
  return {{"ambient", [](Draft& d) { std::get<AmbientLight>(d.lights[0]).la.b = 0.5; }},
          {"point ld", [=](Draft& d) { point(d).ld.r = 0.5; }},
          {"point la", [=](Draft& d) { point(d).la.r = 0.5; }},
          {"point position", [=](Draft& d) { point(d).position.x = 0.5; }},
          {"point falls off", [=](Draft& d) { point(d).falls_off = true; }},
          {"point radius", [=](Draft& d) { point(d).radius = 0.5; }},
          {"point range", [=](Draft& d) { point(d).range = 5; }},
          {"spot direction",
           [=](Draft& d) {
             spot(d).direction = {0, 1, 0};
           }},
          {"spot inner", [=](Draft& d) { spot(d).cone.inner_degrees = 10; }},
          {"spot outer", [=](Draft& d) { spot(d).cone.outer_degrees = 50; }},
          {"directional",
           [](Draft& d) {
             std::get<DirectionalLight>(d.lights[3]).direction = {0, 1, 0};
           }},
          {"another kind", [](Draft& d) { d.lights[3] = SpotLight{}; }},
          {"one more", [](Draft& d) { d.lights.push_back(PointLight{}); }},
          {"no environment", [](Draft& d) { d.environment.reset(); }},
          {"environment's texel", [](Draft& d) { d.sky.radiance[5] = 3; }},
          {"environment's shape", [](Draft& d) { std::swap(d.sky.width, d.sky.height); }},
          {"environment's rotation", [](Draft& d) { d.environment->rotation_degrees = 90; }},
          {"environment's brightness", [](Draft& d) { d.environment->brightness = 2; }},
          {"up", [](Draft& d) { d.up.z = 1; }},
          {"background", [](Draft& d) { d.background.r = 0.5; }},
          {"tone map", [](Draft& d) { d.tone_map = ToneMap::reinhard; }}};
}

}  // namespace

TEST_CASE("whatever changes in a scene changes its fingerprint", "[unit][fingerprint]") {
  Draft plain;
  plain.pbr.base_color_texture.texture = std::make_shared<Texture>();
  plain.pbr.normal_texture.texture = std::make_shared<Texture>();
  std::map<std::string, std::string> seen{{plain.fingerprint(), "nothing"}};
  for (auto const& changes : {shape_changes(), material_changes(), texture_changes(), light_changes()}) {
    for (Change const& next : changes) {
      Draft changed = plain;
      next.make(changed);
      auto const [found, is_new] = seen.emplace(changed.fingerprint(), next.what);
      INFO(next.what << " is taken for: " << found->second);
      CHECK(is_new);
    }
  }
}

TEST_CASE("names, and where things lie in memory, are not in a scene's fingerprint", "[unit][fingerprint]") {
  Draft plain, renamed;
  for (Draft* const draft : {&plain, &renamed}) draft->pbr.normal_texture.texture = std::make_shared<Texture>();
  CHECK(plain.fingerprint() == renamed.fingerprint());
  renamed.prefix = "another ";
  renamed.image.name = "another";
  CHECK(plain.fingerprint() == renamed.fingerprint());
}
