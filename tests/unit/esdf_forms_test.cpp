#include <filesystem>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/temporary_folder.hpp"

// Every form of a statement and what it means.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

template <class T>
T const& shape(Scene const& scene, std::string_view name) {
  auto const* const found = scene.shapes.find(name);
  REQUIRE(found);
  auto const* const cast = dynamic_cast<T const*>(found->get());
  REQUIRE(cast);
  return *cast;
}

Material const& material(Scene const& scene, std::string_view name) {
  auto const* const found = scene.materials.find(name);
  REQUIRE(found);
  return **found;
}

Light const& light(Scene const& scene, std::string_view name) {
  auto const* const found = scene.lights.find(name);
  REQUIRE(found);
  return *found;
}

Camera const& camera(Scene const& scene, std::string_view name) {
  auto const* const found = scene.cameras.find(name);
  REQUIRE(found);
  return *found;
}

void check_near(Vec3 const& a, Vec3 const& b) {
  INFO(a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z);
  CHECK(glm::length(a - b) < 1e-12);
}

}  // namespace

TEST_CASE("materials", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define material a .1 .2 .3 .4 .5 .6 .7 .8 .9 10\n"
      "define material b 1 0 0 1 0 0 1 0 0 0\n"
      "define material c 0 0 0 0 0 0 1 1 1 5 reflect=.25\n"
      "define material d 0 0 0 0 0 0 1 1 1 5 ior=1.5 transmit=.75 reflect=.125\n");
  CHECK(scene.materials.size() == 4);
  Material const& a = material(scene, "a");
  CHECK(a.ka() == Rgb(.1, .2, .3));
  CHECK(a.kd() == Rgb(.4, .5, .6));
  CHECK(a.ks() == Rgb(.7, .8, .9));
  CHECK(a.m() == 10);
  CHECK(a.reflect() == 0);
  CHECK(a.transmit() == 0);
  CHECK(material(scene, "b").m() == 0);
  CHECK(material(scene, "c").reflect() == .25);
  CHECK(material(scene, "d").reflect() == .125);
  CHECK(material(scene, "d").transmit() == .75);
  CHECK(material(scene, "d").ior() == 1.5);
}

TEST_CASE("what a material sends out", "[unit][esdf]") {
  auto const material = [](std::string const& rest) {
    return *scene_of("define material m .1 .2 .3 .4 .5 .6 .7 .8 .9 25" + rest + "\n").materials.front();
  };
  CHECK(material("").emission() == Rgb(0));
  CHECK(material(" emission 4 0 1e30").emission() == Rgb(4, 0, 1e30));
  CHECK(material(" emission 4 4 3 ior=1.5").ior() == 1.5);
  CHECK(material(" reflect=0.5 emission 4 4 3 ior=1.5").emission() == Rgb(4, 4, 3));
  CHECK(material(" reflect=0.5 emission 4 4 3 ior=1.5").reflect() == 0.5);
  CHECK(scene_of("define material emission 1 1 1 1 1 1 1 1 1 1 emission 1 2 3\n").materials.front()->emission() ==
        Rgb(1, 2, 3));
}

TEST_CASE("what material extras mean, the options say", "[unit][esdf]") {
  std::string const text = "define material a 0 0 0 0 0 0 0 0 0 1 .25 1.5 .5\n";
  Scene const ignored = scene_of(text);
  CHECK(material(ignored, "a").is_opaque());
  CHECK(material(ignored, "a").reflect() == 0);

  using enum MaterialExtra;
  EsdfOptions options;
  options.material_extras = {opacity, ior, reflectance};
  Scene const scene = scene_of("define material a 0 0 0 0 0 0 0 0 0 1 .75 1.5 .5\n", options);
  CHECK(material(scene, "a").transmit() == .25);
  CHECK(material(scene, "a").ior() == 1.5);
  CHECK(material(scene, "a").reflect() == .5);
  CHECK(shown("define material a 0 0 0 0 0 0 0 0 0 1 .75 1.5 .5\n", options).empty());

  options.material_extras = {ignore, transmittance};
  Scene const other = scene_of(text, options);  // 1.5 is brought into range; the third number has no name
  CHECK(material(other, "a").transmit() == 1);
  CHECK(material(other, "a").reflect() == 0);
  CHECK_THAT(shown(text, options), contains_text("s.sdf:1:47: warning: material: 3 numbers after m, only the first 2"));

  options.material_extras = {reflectance, transmittance};
  Scene const too_much = scene_of("define material a 0 0 0 0 0 0 0 0 0 1 .8 .7\n", options);
  CHECK(material(too_much, "a").transmit() == .7);
  CHECK(material(too_much, "a").reflect() == Approx(.3));

  // A key says it more clearly than a number.
  Scene const both = scene_of("define material a 0 0 0 0 0 0 0 0 0 1 .5 .25 reflect=.125\n", options);
  CHECK(material(both, "a").reflect() == .125);
  CHECK(material(both, "a").transmit() == .25);
}

TEST_CASE("primitives", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                               "define shape sphere s 1 2 3 4 red\n"
                               "define shape sphere negative 1 2 3 -4 red\n"
                               "define shape box b 4 5 6 1 2 9 red\n"
                               "define shape triangle t 1 2 3 4 5 6 7 8 9 red\n");
  CHECK(shape<Sphere>(scene, "s").center() == Vec3(1, 2, 3));
  CHECK(shape<Sphere>(scene, "s").radius() == 4);
  CHECK(shape<Sphere>(scene, "s").material() == *scene.materials.find("red"));
  CHECK(shape<Sphere>(scene, "negative").radius() == 4);
  CHECK(shape<Box>(scene, "b").min() == Vec3(1, 2, 6));
  CHECK(shape<Box>(scene, "b").max() == Vec3(4, 5, 9));
  auto const& t = shape<Triangle>(scene, "t").vertices();
  CHECK(t[0] == Vec3(1, 2, 3));
  CHECK(t[1] == Vec3(4, 5, 6));
  CHECK(t[2] == Vec3(7, 8, 9));
  CHECK(scene.roots().size() == 4);
}

TEST_CASE("cylinders, cones and planes", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                               "define shape cylinder c 1 2 3 4 5 6 7 red\n"
                               "define shape cylinder c_up 1 2 3 4 5 red\n"
                               "define shape cone d 1 2 3 4 5 6 -7 red\n"
                               "define shape cone d_down 0 50 -100 50 -50 red\n"
                               "define shape plane p 1 2 3 0 5 0 red\n");
  CHECK(shape<Cylinder>(scene, "c").p1() == Vec3(1, 2, 3));
  CHECK(shape<Cylinder>(scene, "c").p2() == Vec3(4, 5, 6));
  CHECK(shape<Cylinder>(scene, "c").radius() == 7);
  CHECK(shape<Cylinder>(scene, "c").material() == *scene.materials.find("red"));
  CHECK(shape<Cylinder>(scene, "c_up").p2() == Vec3(1, 7, 3));
  CHECK(shape<Cylinder>(scene, "c_up").radius() == 4);
  CHECK(shape<Cone>(scene, "d").base() == Vec3(1, 2, 3));
  CHECK(shape<Cone>(scene, "d").tip() == Vec3(4, 5, 6));
  CHECK(shape<Cone>(scene, "d").radius() == 7);
  CHECK(shape<Cone>(scene, "d_down").tip() == Vec3(0, 0, -100));
  CHECK(shape<Cone>(scene, "d_down").radius() == 50);
  CHECK(shape<Plane>(scene, "p").point() == Vec3(1, 2, 3));
  CHECK(shape<Plane>(scene, "p").normal() == Vec3(0, 5, 0));
}

TEST_CASE("composites share their children", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                               "define shape sphere s 0 0 0 1 red\n"
                               "define shape composite one s s\n"
                               "define shape composite two s one\n"
                               "define shape composite top one two one\n");
  auto const& one = shape<Composite>(scene, "one");
  auto const& two = shape<Composite>(scene, "two");
  auto const& top = shape<Composite>(scene, "top");
  REQUIRE(one.children().size() == 2);
  CHECK(one.children()[0] == one.children()[1]);
  CHECK(one.children()[0] == two.children()[0]);
  REQUIRE(top.children().size() == 3);
  CHECK(top.children()[0].get() == &one);
  CHECK(top.children()[1].get() == &two);
  CHECK(top.children()[2].get() == &one);
  REQUIRE(scene.roots().size() == 1);
  CHECK(scene.roots()[0].get() == &top);
}

TEST_CASE("lights of the standard", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define light sdf 1 2 3 .1 .2 .3 .4 .5 .6\n"
      "define light ambient amb .1 .1 .2\n"
      "define light diffuse dif 1 2 3 .4 .5 .6\n");
  CHECK(light(scene, "sdf").kind() == "point");
  CHECK(*light(scene, "sdf").position() == Vec3(1, 2, 3));
  CHECK(light(scene, "sdf").la() == Rgb(.1, .2, .3));
  CHECK(light(scene, "sdf").brightness() == Rgb(.4, .5, .6));
  CHECK(light(scene, "amb").kind() == "ambient");
  CHECK(light(scene, "amb").la() == Rgb(.1, .1, .2));
  CHECK(light(scene, "dif").kind() == "point");
  CHECK(*light(scene, "dif").position() == Vec3(1, 2, 3));
  CHECK(light(scene, "dif").brightness() == Rgb(.4, .5, .6));
  CHECK(light(scene, "dif").la() == Rgb(0));
  CHECK(scene.tone_map == ToneMap::none);
}

TEST_CASE("a light with a position may have a radius", "[unit][esdf]") {
  auto const radius = [](std::string const& light) {
    Scene const scene = scene_of("define light " + light + "\n");
    return scene.lights.front().get<PointLight>()->radius;
  };
  CHECK(radius("diffuse lamp 0 0 0 1 1 1 radius=0.25") == 0.25);
  CHECK(radius("diffuse a=b 0 0 0 1 1 1 radius=0.25") == 0.25);
  CHECK(radius("a=b 0 0 0 1 1 1 2 2 2 radius=3") == 3);
  CHECK(radius("lamp 0 0 0 1 1 1 60 radius=3") == 3);
  CHECK(radius("diffuse 0 0 0 1 1 1 2 2 2 radius=1e3") == 1000);  // called 'diffuse'
  CHECK(radius("diffuse lamp 0 0 0 1 1 1 radius=0") == 0);
  CHECK(radius("diffuse lamp 0 0 0 1 1 1") == 0);
}

TEST_CASE("a camera may have a lens", "[unit][esdf]") {
  auto const lens = [](std::string const& words) {
    Scene const scene = scene_of("define camera eye 45" + words + "\n");
    return scene.cameras.front().lens();
  };
  CHECK(lens("") == Lens());
  CHECK(lens(" aperture=0.5 focus=7") == Lens{0.5, 7});
  CHECK(lens(" 640 480 focus=7 aperture=0.5") == Lens{0.5, 7});
  CHECK(lens(" 1 2 3 0 0 -1 aperture=0.5 focus=7") == Lens{0.5, 7});
}

TEST_CASE("a camera may be orthographic, with a lens or without", "[unit][esdf]") {
  auto const camera = [](std::string const& words) {
    Scene const scene = scene_of("define camera eye 45" + words + "\ntransform eye scale 2\n");
    return scene.cameras.front();
  };
  CHECK(!camera("").is_orthographic());
  CHECK(camera(" orthographic=6").width() == 6);
  CHECK(camera(" orthographic=6").lens() == Lens());
  CHECK(camera(" 640 480 orthographic=0.5").resolution() == Resolution{640, 480});
  CHECK(camera(" focus=7 orthographic=6 aperture=0.5").lens() == Lens{0.5, 7});
  CHECK(camera(" focus=7 orthographic=6 aperture=0.5").width() == 6);
  CHECK(camera(" 1 2 3 0 0 -1 orthographic=2").width() == 2);
  // The width is in units of the camera's own frame.
  Ray const ray = camera(" orthographic=6").generate_ray(0, 50, {100, 100});
  CHECK(glm::distance(ray.origin, Vec3(-6, 0, 0)) < 1e-12);
}

TEST_CASE("lights of the dialects", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define light bright 1 2 3 .5 .25 1 10\n"
      "define light colour 1 2 3 .5 .25 1\n"
      "define light diffuse both 1 2 3 .1 .2 .3 .4 .5 .6\n"
      "define light ambient placed 1 2 3 .1 .2 .3\n"
      "define light ambient point 1 2 3 .1 .2 .3 .4 .5 .6\n"
      "define light ambient 1 2 3 .1 .2 .3 .4 .5 .6\n");
  CHECK(light(scene, "bright").brightness() == Rgb(5, 2.5, 10));
  CHECK(light(scene, "bright").la() == Rgb(0));
  CHECK(light(scene, "colour").brightness() == Rgb(.5, .25, 1));
  CHECK(light(scene, "both").la() == Rgb(.1, .2, .3));
  CHECK(light(scene, "both").brightness() == Rgb(.4, .5, .6));
  CHECK(light(scene, "placed").kind() == "ambient");
  CHECK(light(scene, "placed").la() == Rgb(.1, .2, .3));
  for (std::string const name : {"point", "ambient"}) {
    CHECK(light(scene, name).kind() == "point");
    CHECK(*light(scene, name).position() == Vec3(1, 2, 3));
    CHECK(light(scene, name).la() == Rgb(.1, .2, .3));
    CHECK(light(scene, name).brightness() == Rgb(.4, .5, .6));
  }
  Scene const unnamed = scene_of("define light ambient 9 9 9 .1 .2 .3\n");
  CHECK(light(unnamed, "ambient").kind() == "ambient");
  CHECK(unnamed.ambient() == Rgb(.1, .2, .3));
}

TEST_CASE("lights may be called like their classes", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define light diffuse 1 2 3 .1 .2 .3 .4 .5 .6\n"
      "define light ambient 1 2 3 .1 .2 .3 2\n");
  CHECK(light(scene, "diffuse").la() == Rgb(.1, .2, .3));
  CHECK(light(scene, "ambient").kind() == "point");
  CHECK(light(scene, "ambient").brightness() == Rgb(.2, .4, .6));
}

TEST_CASE("an environment is a file's, the studio, or one colour", "[unit][esdf]") {
  std::string const define = "define light environment sky ";
  auto const environment = [&](std::string const& rest) {
    auto const found = scene_of(define + rest + "\n").environment;
    REQUIRE(found);
    REQUIRE(found->map);
    CHECK(found->name == "sky");
    return *found;
  };
  EnvironmentLight const color = environment("0.5 2 0");
  CHECK(color.map->width == 1);
  CHECK(color.map->height == 1);
  CHECK(color.map->radiance == std::vector<float>{0.5f, 2, 0});
  CHECK(color.rotation_degrees == 0);
  CHECK(color.brightness == 1);
  EnvironmentLight const studio = environment("studio brightness=0.5 rotation=-400");
  CHECK(studio.map->radiance == environment_map("studio")->radiance);
  CHECK(studio.source == "studio");
  CHECK(studio.rotation_degrees == -400);
  CHECK(studio.brightness == 0.5);
  CHECK(environment("1 1 1 brightness=0").brightness == 0);
  CHECK(scene_of(define + "1 1 1\ndefine light sun 0 0 0 1 1 1 1 1 1\n").lights.size() == 1);
}

TEST_CASE("the file of an environment lies beside the scene", "[unit][esdf]") {
  TemporaryFolder const folder;
  std::filesystem::create_directory(folder / "maps");
  folder.write("maps/sky.hdr", "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x40\x40\x40\x80");
  folder.write("maps/short.hdr", "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x40");
  std::vector<std::filesystem::path> read;
  EsdfOptions options;
  options.on_read = [&](std::filesystem::path const& file) { read.push_back(file.filename()); };
  auto const load = [&](std::string const& file) {
    return EsdfScript::from_text("\ndefine light environment sky " + file + "\n", "s.sdf", options, folder.path())
        .take_scene();
  };
  Scene const scene = load("maps/sky.hdr");
  REQUIRE(scene.environment);
  CHECK(scene.environment->map->width == 2);
  CHECK(read == std::vector<std::filesystem::path>{"sky.hdr"});
  for (std::string const file : {"maps/short.hdr", "maps/none.hdr", "maps", "../sky.hdr"}) {
    INFO(file);
    try {
      load(file);
      FAIL("it was read");
    } catch (SceneError const& error) {
      CHECK(count_errors(error.diagnostics()) == 1);
      Diagnostic const& problem = error.diagnostics().back();  // after the note that this is a dialect
      CHECK(problem.severity == Severity::error);
      CHECK(problem.location.line == 2);
      CHECK(problem.location.column == 30);
      CHECK(problem.length == file.size());
    }
  }
}

TEST_CASE("ambient light in every form adds up", "[unit][esdf]") {
  for (auto const& [text, expected] : {std::pair<std::string, Rgb>{"ambient .1 .2 .3\n", Rgb(.1, .2, .3)},
                                       {"ambient a .1 .2 .3\n", Rgb(.1, .2, .3)},
                                       {"define ambient .1 .2 .3\n", Rgb(.1, .2, .3)},
                                       {"define ambient a .1 .2 .3\n", Rgb(.1, .2, .3)},
                                       {"define ambient a .5 .25 1 .5\n", Rgb(.25, .125, .5)},
                                       {"define ambient .1\n", Rgb(.1)}}) {
    INFO(text);
    check_near(scene_of(text).ambient(), expected);
    CHECK(shown(text).empty());
  }
  Scene const scene =
      scene_of("ambient 1 0 0\nambient 0 1 0\ndefine ambient 0 0 1\ndefine light sun 0 0 0 1 1 1 0 0 0\n");
  CHECK(scene.lights.size() == 4);
  check_near(scene.ambient(), Rgb(2));
}

TEST_CASE("the tone map is Reinhard's where a light has a brightness", "[unit][esdf]") {
  CHECK(scene_of("define light a 0 0 0 1 1 1 10\n").tone_map == ToneMap::reinhard);
  CHECK(scene_of("define ambient a 1 1 1 10\n").tone_map == ToneMap::reinhard);
  CHECK(scene_of("define light a 0 0 0 1 1 1 1 1 1\nambient 1 1 1\n").tone_map == ToneMap::none);
}

TEST_CASE("cameras", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define camera a 45\n"
      "camera b 60.5\n"
      "define camera c 45 640 480\n"
      "camera d 45 640 480\n"
      "define camera e 45 1 2 3\n"
      "define camera f 45 1 2 3 2 0 0\n"
      "define camera g 45 1 2 3 0 0 -5 1 1 0\n"
      "define camera h 45 320 200 1 2 3 0 0 1\n");
  CHECK(camera(scene, "a").fov_x_degrees() == 45);
  CHECK_FALSE(camera(scene, "a").resolution());
  CHECK(camera(scene, "a").world_from_camera().is_identity());
  CHECK(camera(scene, "b").fov_x_degrees() == 60.5);
  CHECK(camera(scene, "c").resolution() == Resolution{640, 480});
  CHECK(camera(scene, "d").resolution() == Resolution{640, 480});

  auto const check_frame = [&](std::string const& name, Vec3 const& forward, Vec3 const& up) {
    INFO(name);
    Transform const& frame = camera(scene, name).world_from_camera();
    check_near(frame.point(Vec3(0)), Vec3(1, 2, 3));
    check_near(frame.vector(Vec3(0, 0, -1)), forward);
    check_near(frame.vector(Vec3(0, 1, 0)), up);
    check_near(frame.vector(Vec3(1, 0, 0)), glm::cross(forward, up));
  };
  check_frame("e", Vec3(0, 0, -1), Vec3(0, 1, 0));
  check_frame("f", Vec3(1, 0, 0), Vec3(0, 1, 0));
  check_frame("g", Vec3(0, 0, -1), glm::normalize(Vec3(1, 1, 0)));
  check_frame("h", Vec3(0, 0, 1), Vec3(0, 1, 0));
  CHECK(camera(scene, "h").resolution() == Resolution{320, 200});
  CHECK_FALSE(camera(scene, "e").resolution());
}

TEST_CASE("an up vector that does not help is replaced", "[unit][esdf]") {
  Scene const scene = scene_of("define camera a 45 0 0 0 0 -3 0\ndefine camera b 45 0 0 0 1e30 0 0 -1e30 0 0\n");
  check_near(camera(scene, "a").world_from_camera().vector(Vec3(0, 0, -1)), Vec3(0, -1, 0));
  check_near(camera(scene, "a").world_from_camera().vector(Vec3(0, 1, 0)), Vec3(0, 0, 1));
  check_near(camera(scene, "b").world_from_camera().vector(Vec3(0, 1, 0)), Vec3(0, 1, 0));
}

TEST_CASE("render in every form", "[unit][esdf]") {
  struct Case {
    std::string text;
    std::string camera;
    std::string file;
    std::optional<Resolution> resolution;
    std::optional<int> samples;
    std::optional<int> depth;
    std::optional<Integrator> integrator = {};
  };
  std::string const cameras = "define camera eye 45 16 9\n";
  Resolution const size{640, 480};
  for (Case const& c : {Case{"render eye a.png 640 480", "eye", "a.png", size, {}, {}},
                        {"render eye a.png", "eye", "a.png", {}, {}, {}},
                        {"render eye a.png 640.0 480", "eye", "a.png", size, {}, {}},
                        {"render eye 7", "eye", "7", {}, {}, {}},
                        {"render eye 7 640 480", "eye", "7", size, {}, {}},
                        {"render eye a.png 640 480 4", "eye", "a.png", size, 4, {}},
                        {"render eye a.png 640 480 1", "eye", "a.png", size, 1, {}},
                        {"render eye a.png 640 480 4 3", "eye", "a.png", size, 4, 3},
                        {"render eye a.png 640 480 0 3", "eye", "a.png", size, {}, 3},
                        {"render eye a.png 640 480 integrator=path", "eye", "a.png", size, {}, {}, Integrator::path},
                        {"render eye a.png samples=9 depth=0", "eye", "a.png", {}, 9, 0},
                        {"render eye a.png 640 480 4 3 samples=9", "eye", "a.png", size, 9, 3},
                        {"render eye a=b.png", "eye", "a=b.png", {}, {}, {}},
                        {"render eye a=b.png integrator=whitted", "eye", "a=b.png", {}, {}, {}, Integrator::whitted},
                        {"render a.png integrator=path", "eye", "a.png", {}, {}, {}, Integrator::path},
                        {"define filename f.png\nrender eye depth=1", "eye", "f.png", {}, {}, 1},
                        {"render eye image . ppm 640 480", "eye", "image.ppm", size, {}, {}},
                        {"render eye image .ppm", "eye", "image.ppm", {}, {}, {}},
                        {"render eye \"my picture 2.png\" 640 480", "eye", "my picture 2.png", size, {}, {}},
                        {"render eye \"a.png\"", "eye", "a.png", {}, {}, {}},
                        {"render someone a.png 640 480", "eye", "a.png", size, {}, {}},
                        {"render a.png 640 480", "eye", "a.png", size, {}, {}},
                        {"render a.png", "eye", "a.png", {}, {}, {}},
                        {"define render eye a.png 640 480", "eye", "a.png", size, {}, {}},
                        {"define renderer a.png 640 480", "eye", "a.png", size, {}, {}},
                        {"define filename f.png\nrender eye 640 480", "eye", "f.png", size, {}, {}},
                        {"define filename f.png\nrender eye", "eye", "f.png", {}, {}, {}},
                        {"define filename f.png\nrender", "eye", "f.png", {}, {}, {}}}) {
    INFO(c.text);
    Scene const scene = scene_of(cameras + c.text + "\n");
    REQUIRE(scene.renders.size() == 1);
    RenderCommand const& command = scene.renders[0];
    CHECK(command.camera == c.camera);
    CHECK(command.file == c.file);
    CHECK(command.resolution == c.resolution);
    CHECK(command.samples == c.samples);
    CHECK(command.depth == c.depth);
    CHECK(command.integrator == c.integrator);
    CHECK(command.location.file == "s.sdf");
    CHECK(command.location.line == (c.text.find('\n') == std::string::npos ? 2 : 3));
  }
  Scene const by_default = scene_of(eye + "define resolution 320 200\nrender eye a.png\n");
  CHECK(by_default.resolution == Resolution{320, 200});
  CHECK(by_default.renders.size() == 1);
}

TEST_CASE("a number may be the name of a camera", "[unit][esdf]") {
  Scene const scene = scene_of("define camera 1 45\nrender 1 2 640 480\nrender 1 a.png 640 480\n");
  REQUIRE(scene.renders.size() == 2);
  CHECK(scene.renders[0].camera == "1");
  CHECK(scene.renders[0].file == "2");
}

TEST_CASE("background, file name and resolution of a scene", "[unit][esdf]") {
  Scene const scene = scene_of("define background .1 .2 .3\ndefine filename out.png\ndefine resolution 10 20\n");
  CHECK(scene.background == Rgb(.1, .2, .3));
  CHECK(scene.filename == "out.png");
  CHECK(scene.resolution == Resolution{10, 20});
  CHECK(scene_of("define backgroundcolor 1 1 1\n").background == Rgb(1));
  CHECK(scene_of("").background == Rgb(0));
}

TEST_CASE("names may be any token, in separate spaces", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define material define 1 0 0 1 0 0 1 0 0 1\n"
      "define shape sphere define 0 0 0 1 define\n"
      "define light define 0 0 0 1 1 1 1 1 1\n"
      "define camera define 45\n"
      "define shape sphere 7 0 0 0 1 define\n"
      "define shape composite sphere 7 define\n"
      "transform 7 scale 2\n");
  CHECK(scene.shapes.size() == 3);
  CHECK(scene.shapes.contains("7"));
  CHECK(shape<Composite>(scene, "sphere").children().size() == 2);
}

TEST_CASE("blanks, comments and line ends", "[unit][esdf]") {
  std::string const expected = "define camera eye 45\ndefine camera eve 60\n";
  for (std::string const& text :
       {expected, std::string("define camera eye 45\r\ndefine camera eve 60\r\n"),
        std::string("define camera eye 45\rdefine camera eve 60\r"),
        std::string("define camera eye 45\ndefine camera eve 60"),
        std::string("define camera eye 45\rdefine camera eve 60"), std::string("\xEF\xBB\xBF") + expected,
        std::string("\n\n\tdefine\t camera \veye\f45  \n   \n define   camera eve 60 \t"),
        std::string(
            "# a\ndefine camera eye 45# b\n  # c\n  //define camera x\n// y\n//\ndefine camera eve 60 # // \n#"),
        std::string("define camera eye 45 #\r\n# comment\r\n\r\ndefine camera eve 60")}) {
    INFO(text);
    CHECK(findings(text).empty());
    Scene const scene = scene_of(text);
    CHECK(scene.cameras.size() == 2);
    CHECK(camera(scene, "eye").fov_x_degrees() == 45);
    CHECK(camera(scene, "eve").fov_x_degrees() == 60);
  }
  // Columns and lines are those of the file, whatever ends its lines.
  for (std::string const end : {"\n", "\r\n", "\r"}) {
    auto const found = findings("# a" + end + end + "\t nonsense" + end);
    REQUIRE(found.size() == 1);
    CHECK(found[0].location.line == 3);
    CHECK(found[0].location.column == 3);
    CHECK(found[0].source_line == "\t nonsense");
  }
  CHECK(findings("").empty());
  CHECK(findings("\n").empty());
  CHECK(findings("\xEF\xBB\xBF").empty());
}

TEST_CASE("directions, ends and axes may be as short as numbers are", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                               "define shape plane p 0 -1 0 0 1e-200 0 red\n"
                               "define shape cylinder c 0 0 0 0 1e-200 0 1 red\n"
                               "define shape cone t 0 0 0 0 0 1e-320 1 red\n"
                               "define shape sphere s 0 0 0 1 red\n"
                               "transform s rotate 90 1e-200 0 0\n"
                               "transform s translate 0 5 0\n"
                               "define camera a 60 0 0 0 0 0 -1e-200\n"
                               "define camera b 60 0 0 0 0 0 -1 0 1e-300 0\n");
  Hit hit;
  CHECK(shape<Plane>(scene, "p").closest_hit({{0, 0, 0}, {0, -1, 0}}, 0, hit));
  CHECK(hit.t == Approx(1));
  check_near(shape<Sphere>(scene, "s").world_from_object().vector({0, 1, 0}), {0, 0, 1});
  for (char const* const name : {"a", "b"}) {
    check_near(camera(scene, name).world_from_camera().vector({0, 0, -1}), {0, 0, -1});
    check_near(camera(scene, name).world_from_camera().vector({0, 1, 0}), {0, 1, 0});
  }
  // About the sine that is least: a warning, or a camera.
  for (std::string const sine : {"1e-7", "1e-8", "0.99999999999e-9", "1.00000000001e-9", "1e-9", "1e-10"}) {
    CHECK(loads("define camera c 60 0 0 0 0 0 -1 " + sine + " 0 -1\n"));
  }
}
