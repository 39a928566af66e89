#include "lichtraum/scene.hpp"

#include <sstream>
#include <stdexcept>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

template <class T>
std::string printed(T const& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::shared_ptr<Sphere> ball(std::string name) {
  return std::make_shared<Sphere>(std::move(name), Vec3(0), 1, nullptr);
}

}  // namespace

TEST_CASE("a registry keeps order, names and addresses", "[unit][registry]") {
  Registry<Light> lights;
  CHECK(lights.empty());
  CHECK(lights.insert(Light::ambient("b", Rgb(1))));
  Light const* const first = lights.find("b");
  for (int i = 0; i < 1000; ++i) CHECK(lights.insert(Light::ambient("light " + std::to_string(i), Rgb(i))));
  CHECK(lights.find("b") == first);
  CHECK(lights.size() == 1001);
  CHECK(lights.front().name() == "b");
  CHECK(lights.find("light 999")->la().r == 999);
  CHECK(lights.find("light 1000") == nullptr);
  CHECK(lights.contains("light 0"));

  CHECK(!lights.insert(Light::ambient("b", Rgb(2))));  // taken: nothing changes
  CHECK(lights.size() == 1001);
  CHECK(first->la().r == 1);

  lights.insert_or_replace(Light::ambient("b", Rgb(3)));
  CHECK(lights.size() == 1001);
  CHECK(lights.find("b") == first);
  CHECK(first->la().r == 3);
  lights.insert_or_replace(Light::ambient("new", Rgb(4)));
  CHECK(lights.size() == 1002);
  int index = 0;
  for (Light const& light : lights) {
    std::string const expected = index == 0 ? "b" : index == 1001 ? "new" : "light " + std::to_string(index - 1);
    REQUIRE(light.name() == expected);
    ++index;
  }

  Registry<Light> const moved = std::move(lights);
  CHECK(moved.find("b") == first);
}

TEST_CASE("a registry refuses null pointers and stays as it was", "[unit][registry]") {
  Registry<std::shared_ptr<Shape>> shapes;
  shapes.insert(ball("a"));
  CHECK_THROWS_AS(shapes.insert(nullptr), std::invalid_argument);
  CHECK_THROWS_AS(shapes.insert_or_replace(nullptr), std::invalid_argument);
  CHECK(shapes.size() == 1);
}

TEST_CASE("the roots are what no composite names, in order of definition", "[unit][scene]") {
  Scene scene;
  auto const a = ball("a"), b = ball("b"), c = ball("c");
  auto const hidden = std::make_shared<Composite>("hidden", Composite::Children{c});  // not in the registry itself
  auto const group = std::make_shared<Composite>("group", Composite::Children{b, hidden, b});
  auto const outer = std::make_shared<Composite>("outer", Composite::Children{group});
  for (std::shared_ptr<Shape> const& shape : std::initializer_list<std::shared_ptr<Shape>>{c, group, a, outer, b}) {
    REQUIRE(scene.shapes.insert(shape));
  }
  auto const roots = scene.roots();
  REQUIRE(roots.size() == 2);
  CHECK(roots[0] == a);
  CHECK(roots[1] == outer);
}

TEST_CASE("the ambient term is the sum of all La", "[unit][scene]") {
  Scene scene;
  CHECK(scene.ambient() == Rgb(0));
  scene.lights.insert(Light::ambient("one", {0.25, 0, 0.5}));
  scene.lights.insert(Light::point("two", Vec3(1), Rgb(9), {0.25, 0.5, 0}));
  scene.lights.insert(Light::point("three", Vec3(1), Rgb(9)));
  CHECK(scene.ambient() == Rgb(0.5, 0.5, 0.5));
}

TEST_CASE("values print themselves in one line", "[unit][scene]") {
  Material material("red", {1, 0, 0}, {1, 0.5, 0}, Rgb(0.1), 20);
  CHECK(printed(material) == "material 'red': ka 1 0 0, kd 1 0.5 0, ks 0.1 0.1 0.1, m 20");
  PhongModel glass = material.phong();
  glass.reflect = 0.25, glass.transmit = 0.5, glass.ior = 1.5;
  material = Material("red", glass);
  CHECK(printed(material) ==
        "material 'red': ka 1 0 0, kd 1 0.5 0, ks 0.1 0.1 0.1, m 20, reflect 0.25, transmit 0.5, ior 1.5");
  CHECK(printed(Light::ambient("sky", {0, 0, 1})) == "ambient light 'sky': la 0 0 1");
  CHECK(printed(Light::point("sun", {1, 2, 3}, Rgb(1), Rgb(0.5))) ==
        "point light 'sun': ld 1 1 1, la 0.5 0.5 0.5, position 1 2 3");
  CHECK(printed(Camera("eye", 60, Transform::translation({0, 0, 5}), Resolution{640, 480})) ==
        "camera 'eye': fov 60 degrees, at 0 0 5, looking along 0 0 -1, 640 x 480");
  auto const shared = std::make_shared<Material>(material);
  CHECK(printed(Sphere("s", {1, 2, 3}, 4, shared)) == "sphere 's': center 1 2 3, radius 4, material 'red'");
  CHECK(printed(Box("b", {1, 5, 3}, {2, 0, 4}, shared)) == "box 'b': min 1 0 3, max 2 5 4, material 'red'");
  CHECK(printed(Triangle("t", {0, 0, 0}, {1, 0, 0}, {0, 1e-7, 0}, nullptr)) == "triangle 't': 0 0 0, 1 0 0, 0 1e-07 0");
  CHECK(printed(Composite("g", {ball("x"), ball("y")})) == "composite 'g': 2 children");
}

TEST_CASE("materials refuse shares beyond 0..1", "[unit][scene]") {
  CHECK(Material().is_opaque());
  auto const refuses = [](double reflect, double transmit, double ior) {
    PhongModel const model{.reflect = reflect, .transmit = transmit, .ior = ior};
    CHECK_THROWS_AS(Material("", model), std::invalid_argument);
  };
  refuses(0.6, 0.6, 1);
  refuses(-0.1, 0.6, 1);
  refuses(0, 1.1, 1);
  refuses(std::nan(""), 0, 1);
  refuses(0, 1, 0);
  for (int percent = 0; percent <= 100; ++percent) {
    Material const material("",
                            PhongModel{.reflect = percent / 100.0, .transmit = (100 - percent) / 100.0, .ior = 1.5});
    CHECK(material.is_opaque() == (material.transmit() == 0));
  }
}

TEST_CASE("a material is Phong's or glTF's, and tells Phong's coefficients of either", "[unit][scene]") {
  Material const phong("a", Rgb(0.1), Rgb(0.2), Rgb(0.3), 4);
  CHECK(!phong.pbr());
  CHECK(phong.phong().kd == Rgb(0.2));
  Material const metal("b", PbrModel{.base_color = {1, 0.5, 0}, .metallic = 1, .roughness = 0.5, .transmission = 0.25});
  REQUIRE(metal.pbr());
  CHECK(metal.pbr()->base_color == Rgb(1, 0.5, 0));
  CHECK(metal.kd().r == Approx(0.4));  // docs/GLTF.md
  CHECK(metal.phong().reflect == Approx(0.6 * 0.25));
  CHECK(printed(metal) == "material 'b': metallic-roughness, base_color 1 0.5 0, roughness 0.5, transmission 0.25");
}

TEST_CASE("camera rays pass through the image points", "[unit][camera]") {
  Camera const camera("c", 90);
  Ray const middle = camera.generate_ray(50, 25, {100, 50});
  CHECK(middle.origin == Vec3(0));
  CHECK(glm::length(middle.direction - Vec3(0, 0, -1)) < 1e-15);
  // 90 degrees wide: the left edge is at x = -z, and pixels are square.
  Ray const corner = camera.generate_ray(0, 0, {100, 50});
  CHECK(glm::length(corner.direction - glm::normalize(Vec3(-1, 0.5, -1))) < 1e-15);
  CHECK(glm::length(corner.direction) == Approx(1));

  Camera const placed("c", 60, Transform::look_along({1, 2, 3}, {1, 0, 0}, {0, 1, 0}));
  Ray const right = placed.generate_ray(64, 24, {64, 48});
  CHECK(glm::length(right.origin - Vec3(1, 2, 3)) < 1e-15);
  CHECK(glm::length(right.direction - glm::normalize(Vec3(1, 0, std::tan(M_PI / 6)))) < 1e-15);

  for (double const fov : {0.0, 180.0, -30.0, std::nan("")}) CHECK_THROWS_AS(Camera("c", fov), std::invalid_argument);
}
