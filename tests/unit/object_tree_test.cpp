#include "view/object_tree.hpp"

#include <chrono>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "view/marking.hpp"
#include "view/scene_values.hpp"

using namespace lichtraum;
using namespace lichtraum::view;

namespace {

/// a and b in a pair, that in two groups.
std::string const graph = test::red +
                          "define shape sphere a 0 0 0 1 red\ndefine shape box b 0 0 0 1 1 1 red\n"
                          "define shape composite pair a b\ndefine shape sphere alone 0 0 0 1 red\n"
                          "define shape composite left pair\ndefine shape composite right pair a\n"
                          "define shape composite all left alone right\n";

ObjectTree tree_of(Scene const& scene) { return ObjectTree(std::make_shared<DrawnObjects const>(scene)); }

std::string shown(ObjectTree const& tree) {
  std::string text;
  for (ObjectTree::Row const& row : tree.rows()) {
    text += std::string(row.depth, ' ') + row.shape->name() + " " + std::to_string(row.first_object) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("a tree of objects opens, closes and keeps its selection", "[unit][view]") {
  Scene const scene = test::scene_of(graph);
  ObjectTree tree = tree_of(scene);
  CHECK(shown(tree) == "all 1\n");
  tree.toggle(0);
  CHECK(shown(tree) == "all 1\n left 1\n alone 3\n right 4\n");
  tree.select(3);
  tree.toggle(1);
  tree.toggle(2);
  CHECK(shown(tree) == "all 1\n left 1\n  pair 1\n   a 1\n   b 2\n alone 3\n right 4\n");
  CHECK(tree.selected_path() == "/all/right");
  CHECK(tree.selected_objects() == ObjectTree::Objects{4, 3});
  tree.select(4);
  CHECK(tree.selected_path() == "/all/left/pair/b");
  tree.toggle(1);
  CHECK(shown(tree) == "all 1\n left 1\n alone 3\n right 4\n");
  CHECK(tree.selected_path() == "/all/left");
  tree.toggle(2);  // a sphere: nothing happens
  CHECK(tree.rows().size() == 4);
}

TEST_CASE("an object is revealed where its number says", "[unit][view]") {
  Scene const scene = test::scene_of(graph);
  char const* const paths[] = {"/all/left/pair/a",  "/all/left/pair/b",  "/all/alone",
                               "/all/right/pair/a", "/all/right/pair/b", "/all/right/a"};
  for (std::uint64_t number = 1; number <= 6; ++number) {
    ObjectTree tree = tree_of(scene);
    tree.reveal(number);
    CHECK(tree.selected_path() == paths[number - 1]);
    CHECK(tree.selected_objects() == ObjectTree::Objects{number, 1});
  }
  ObjectTree tree = tree_of(scene);
  for (std::uint64_t const number : {5, 1, 6, 3}) {  // in a tree that is open already
    tree.reveal(number);
    CHECK(tree.selected_path() == paths[number - 1]);
  }
  tree.reveal(7);
  CHECK(!tree.selected());
  tree.reveal(0);
  CHECK(!tree.selected());
}

TEST_CASE("a tree copes with many objects and with deep graphs", "[unit][view]") {
  auto const start = std::chrono::steady_clock::now();
  Scene wide;
  auto parent = std::make_shared<Composite>("parent");
  for (int i = 0; i < 10'000; ++i) {
    parent->add(std::make_shared<Sphere>("s" + std::to_string(i), Vec3(0), 1, nullptr));
  }
  wide.shapes.insert(parent);
  ObjectTree tree = tree_of(wide);
  tree.reveal(9'000);
  CHECK(tree.selected_path() == "/parent/s8999");
  CHECK(tree.rows().size() == 10'001);

  Scene deep;
  std::shared_ptr<Shape> shape = std::make_shared<Sphere>("ball", Vec3(0), 1, nullptr);
  for (int i = 0; i < 100'000; ++i) {
    shape = std::make_shared<Composite>("c" + std::to_string(i), Composite::Children{shape});
  }
  deep.shapes.insert(shape);
  ObjectTree nested = tree_of(deep);
  nested.reveal(1);
  CHECK(nested.rows().size() == 100'001);
  CHECK(nested.rows().back().depth == 100'000);
  CHECK_THAT(nested.selected_path(), Catch::Matchers::EndsWith("/c1/c0/ball"));
  CHECK(nested.selected_path().size() < 200);
  nested.toggle(0);
  CHECK(nested.rows().size() == 1);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("objects are outlined where they end", "[unit][view]") {
  Film ids({0, 0, 5, 5}, {FilmPlane::object});
  for (std::size_t y = 1; y < 4; ++y) {
    for (std::size_t x = 1; x < 4; ++x) ids.numbers(FilmPlane::object)[5 * y + x] = x == 3 ? 8 : 7;
  }
  auto const alpha = [](std::vector<unsigned char> const& pixels, int x, int y) {
    return int(pixels[std::size_t(4 * (5 * y + x) + 3)]);
  };
  auto const both = outline_pixels(ids, {7, 2});
  CHECK((alpha(both, 1, 1) == 255 && alpha(both, 2, 1) == 255 && alpha(both, 3, 2) == 255));
  CHECK(alpha(both, 2, 2) == 0);
  CHECK((alpha(both, 0, 2) > 0 && alpha(both, 0, 2) < 255));
  CHECK(alpha(both, 0, 0) == 0);
  CHECK(alpha(outline_pixels(ids, {7, 1}), 2, 2) == 255);
  CHECK(alpha(outline_pixels(ids, {9, 5}), 2, 2) == 0);
}

TEST_CASE("values of a scene are changed beside it, and set back", "[unit][view]") {
  Scene const scene = test::scene_of(graph +
                                     "define material unused 0 0 0 0 0 0 0 0 0 1\n"
                                     "define light diffuse sun 1 2 3  1 1 1\n");
  SceneValues values(scene, DrawnObjects(scene));
  REQUIRE(values.materials.size() == 1);
  REQUIRE(values.lights.size() == 1);
  CHECK(values.edits().materials.empty());
  CHECK(!values.edits().lights);
  Material const* const red = scene.materials.find("red")->get();
  REQUIRE(values.find(red));
  CHECK(!values.find(nullptr));
  values.materials[0].value = Material("red", Rgb(0), Rgb(0.5), Rgb(0), 3);
  values.materials[0].is_edited = true;
  values.lights[0] = Light::point("sun", Vec3(9), Rgb(2));
  CHECK(values.edits().materials.at(red).kd() == Rgb(0.5));
  REQUIRE(values.edits().lights);
  CHECK(*values.edits().lights->at(0).position() == Vec3(9));
  CHECK(red->kd() == Rgb(1, 0, 0));
  values.reset();
  CHECK(values.edits().materials.empty());
  CHECK(!values.edits().lights);
  CHECK(*values.lights[0].position() == Vec3(1, 2, 3));
}
