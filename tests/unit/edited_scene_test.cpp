#include "view/edited_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lichtraum/drawn_objects.hpp"
#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

struct Opened {
  Scene scene;
  view::SceneValues values;
  explicit Opened(std::string const& text, EsdfOptions const& options = {}, std::filesystem::path const& folder = ".")
      : scene(EsdfScript::from_text(text, "scene", options, folder).take_scene()) {
    values = view::SceneValues(scene, DrawnObjects(scene, ""));
  }
};

constexpr char const* first = "# define material red is below\n";
constexpr char const* red_statement = "  define material red 0 0 0  0.5 0 0  0 0 0  1 # dull\n";
constexpr char const* middle = "define material blue 0 0 0  0 0 1  0 0 0  1\ndefine shape sphere red 0 0 0  1 red\n";
constexpr char const* lamp = "define light diffuse lamp 0 5 0  1 1 1\n";
constexpr char const* last = "define light ambient sky 1 1 1\n";

void set_material(view::SceneValues& values, Rgb const& kd) {
  auto& material = values.materials.at(0);
  material.value = Material(material.value.name(), PhongModel{.kd = kd});
  material.is_edited = true;
}

}  // namespace

TEST_CASE("a scene is saved with what was edited, all else to the byte", "[unit][view]") {
  Opened opened(std::string(first) + red_statement + middle + lamp + last);
  CHECK_THROWS_AS(view::edited_scene(first, opened.values), Error);  // nothing was edited
  set_material(opened.values, Rgb(0.25, 1, 0));
  opened.values.lights[0] = Light("lamp", PointLight{.ld = Rgb(2), .position = Vec3(1, 2, 3)});
  std::string const text = view::edited_scene(std::string(first) + red_statement + middle + lamp + last, opened.values);
  CHECK(text == std::string(first) + "  define material red  0.8 0.8 0.8  0.25 1 0  0 0 0  1 # dull\n" + middle +
                    "define light diffuse lamp  1 2 3  2 2 2\n" + last);
  Opened const again(text);
  CHECK(again.values.materials.at(0).value.phong().kd == Rgb(0.25, 1, 0));
  CHECK(again.values.lights.at(0).brightness() == Rgb(2));
}

TEST_CASE("edits have lights only where one was edited: those of a pose move on", "[unit][view][edits]") {
  Opened opened(std::string(red_statement) + middle + lamp + last);
  set_material(opened.values, Rgb(0.25, 1, 0));
  CHECK(!opened.values.edits().lights);
  CHECK(opened.values.edits().materials.size() == 1);
  CHECK(opened.values.is_edited());
  opened.values.reset();
  CHECK(!opened.values.is_edited());
  opened.values.lights[1] = Light::ambient("sky", Rgb(1, 1, 0.5));
  CHECK(opened.values.edits().lights == opened.values.lights);
  CHECK(opened.values.is_edited());
  opened.values.reset_light(1);
  CHECK(!opened.values.edits().lights);
}

TEST_CASE("a scene is saved with its environment turned and dimmed", "[unit][view]") {
  std::string const room = "define light  environment room 0.5 0.5 1 brightness=2 rotation=7 # evening\n";
  Opened opened(room + lamp);
  opened.values.environment->rotation_degrees = -30;
  opened.values.environment->brightness = 0.25;
  CHECK(opened.values.is_edited());
  std::string const text = view::edited_scene(room + lamp, opened.values);
  CHECK(text == std::string("define light environment room 0.5 0.5 1 rotation=-30 brightness=0.25 # evening\n") + lamp);
  Opened const again(text);
  CHECK(again.values.environment->rotation_degrees == -30);
  CHECK(again.values.environment->brightness == 0.25);

  // Of one that the scene's file does not have.
  opened.values.environment->name.clear();
  CHECK_THROWS_WITH(view::edited_scene(room + lamp, opened.values), contains_text("--environment"));
}

TEST_CASE("a scene is saved with its line breaks and its byte order mark", "[unit][view]") {
  for (std::string const line_break : {"\n", "\r\n", "\r"}) {
    auto const scene = [&](char const* kd) {
      return "\xEF\xBB\xBF" + fmt::format("define material red  0.8 0.8 0.8  {}  0 0 0  1", kd) + line_break +
             "define shape sphere ball 0 0 0  1 red" + line_break + line_break + "# no line break at the end";
    };
    Opened opened(scene("0.5 0 0"));
    set_material(opened.values, Rgb(0.25, 1, 0));
    CHECK(view::edited_scene(scene("0.5 0 0"), opened.values) == scene("0.25 1 0"));
  }
}

TEST_CASE("a scene is saved with any light that chooses no tone map", "[unit][view]") {
  for (std::string const form : {"sun 5 8 2  0.9 0.9 0.8", "sun 5 8 2  0.9 0.9 0.8 radius=0.5",
                                 "diffuse sun 5 8 2  0 0 0  0.9 0.9 0.8", "sun 5 8 2  0 0 0  0.9 0.9 0.8"}) {
    INFO(form);
    std::string const scene = "define light " + form + "\n";
    Opened opened(scene);
    Light::Model model = opened.values.lights.at(0).model();
    std::get<PointLight>(model).ld = Rgb(2);
    opened.values.lights[0] = Light("sun", model);
    CHECK(Opened(view::edited_scene(scene, opened.values)).values.lights == opened.values.lights);
  }
}

TEST_CASE("a scene is saved with the names that it has", "[unit][view]") {
  std::string const scene =
      "define material wall/left 0 0 0  0.5 0 0  0 0 0  1\ndefine shape sphere ball 0 0 0  1 wall/left\n"
      "define light diffuse lamp(1)  0 5 0  1 1 1\n";
  Opened opened(scene);
  set_material(opened.values, Rgb(0.25, 1, 0));
  opened.values.lights[0] = Light("lamp(1)", PointLight{.ld = Rgb(2)});
  Opened const again(view::edited_scene(scene, opened.values));
  CHECK(again.values.materials.at(0).value.phong().kd == Rgb(0.25, 1, 0));
  CHECK(again.values.lights.at(0).name() == "lamp(1)");
}

TEST_CASE("a scene is not saved where an edit would be lost", "[unit][view]") {
  Opened opened(std::string(red_statement) + middle + "define light lamp 0 5 0  1 1 1  2\n");
  set_material(opened.values, Rgb(1));
  CHECK_THROWS_WITH(view::edited_scene(std::string(middle), opened.values), contains_text("material red"));
  opened.values.reset();
  opened.values.lights[0] = Light("lamp", PointLight{.ld = Rgb(3)});
  CHECK_THROWS_WITH(view::edited_scene("define light lamp 0 5 0  1 1 1  2\n", opened.values),
                    contains_text("tone map"));
}

TEST_CASE("a scene is not saved with what was edited of a mesh in it", "[unit][view]") {
  TemporaryFolder const folder;
  folder.write("mesh.obj", "mtllib mesh.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("mesh.mtl", "newmtl red\nKd 0.5 0 0\n");
  std::string const scene = std::string(red_statement) + middle + "define shape mesh m mesh.obj\n";
  Opened opened(scene, {}, folder.path());
  auto& materials = opened.values.materials;
  REQUIRE(materials.size() == 2);
  auto const of_mesh = std::ranges::find(materials, false, &view::SceneValues::EditableMaterial::is_listed);
  REQUIRE(of_mesh != materials.end());
  CHECK(of_mesh->value.name() == "red");
  of_mesh->is_edited = true;
  CHECK_THROWS_WITH(view::edited_scene(scene, opened.values), contains_text("the material red that was changed"));
  opened.values.reset();
  std::ranges::find(materials, true, &view::SceneValues::EditableMaterial::is_listed)->is_edited = true;
  CHECK_NOTHROW(view::edited_scene(scene, opened.values));
}

TEST_CASE("a scene is not saved where two lines define what was edited", "[unit][view]") {
  EsdfOptions options;
  options.keep_going = true;
  std::string const again = "define material red 0 0 0  0 0.5 0  0 0 0  1\ndefine shape sphere ball 3 0 0  1 red\n";
  std::string const scene = std::string(red_statement) + middle + again + lamp + lamp;
  Opened opened(scene, options);
  REQUIRE(opened.values.materials.size() == 2);
  for (auto& material : opened.values.materials) {
    material.is_edited = true;
    CHECK_THROWS_WITH(view::edited_scene(scene, opened.values), contains_text("scene's file defines"));
    opened.values.reset();
  }
  opened.values.lights[0] = Light("lamp", PointLight{.ld = Rgb(3)});
  CHECK_THROWS_WITH(view::edited_scene(scene, opened.values), contains_text("more than one line"));
}

TEST_CASE("a scene is not saved where it could not be read", "[unit][view]") {
  std::string const scene = std::string(red_statement) + middle;
  CHECK_NOTHROW(view::check_readable(scene, "scene.sdf", {}));
  CHECK_THROWS_WITH(view::check_readable(scene + "define shape sphere b 0 0 0  1 gone\n", "scene.sdf", {}),
                    contains_text("nothing is saved") && contains_text("scene.sdf:4:"));
}
