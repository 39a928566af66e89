#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Composite const& composite(Scene const& scene, std::string const& name) {
  return dynamic_cast<Composite const&>(**scene.shapes.find(name));
}

}  // namespace

TEST_CASE("keep going: faulty statements are left out, the rest stays", "[unit][esdf]") {
  std::string const text = red + "nonsense\ndefine shape sphere s 0 0 0 1 red\ndefine shape sphere bad 0 0 red\n" +
                           "transform s scale 0\n" + eye + "render eye a.png 1 1\n";
  CHECK_FALSE(loads(text));
  Scene const scene = scene_of(text, keep_going);
  CHECK(scene.shapes.size() == 1);
  CHECK((*scene.shapes.find("s"))->world_from_object().is_identity());
  CHECK(scene.renders.size() == 1);
  auto const found = findings(text, keep_going);
  CHECK(found.size() == 3);
  for (Diagnostic const& diagnostic : found) CHECK(diagnostic.severity == Severity::warning);
}

TEST_CASE("keep going: an undefined material is magenta", "[unit][esdf]") {
  Scene const scene = scene_of(
      "define material m 1\ndefine shape sphere s 0 0 0 1 nowhere\ndefine shape sphere r 0 0 0 1 m\n", keep_going);
  for (auto const& shape : scene.shapes) {
    REQUIRE(shape->material());
    CHECK(shape->material()->ka() == Rgb(1, 0, 1));
    CHECK(shape->material()->kd() == Rgb(1, 0, 1));
    CHECK(shape->material()->ks() == Rgb(0));
  }
  CHECK(scene.materials.empty());
}

TEST_CASE("keep going: an undefined child is left out of its group", "[unit][esdf]") {
  Scene const scene = scene_of(red + "define shape sphere s 0 0 0 1 red\ndefine shape composite c nobody s c\n" +
                                   "define shape composite empty nobody\ntransform empty scale 2\n",
                               keep_going);
  REQUIRE(composite(scene, "c").children().size() == 1);
  CHECK(composite(scene, "c").children()[0]->name() == "s");
  CHECK(composite(scene, "empty").children().empty());
}

TEST_CASE("keep going: of two things with one name the later one wins", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                                   "define shape sphere s 0 0 0 1 red\n"
                                   "define shape sphere s 0 0 0 2 red\n"
                                   "define material red 0 1 0 0 1 0 0 1 0 1\n"
                                   "define shape sphere t 0 0 0 1 red\n"
                                   "define light a 0 0 0 1 1 1 1 1 1\n"
                                   "define light a 0 0 0 1 1 1 2 2 2\n"
                                   "define camera eye 45\n"
                                   "define camera eye 60\n",
                               keep_going);
  CHECK(scene.shapes.size() == 2);
  CHECK(dynamic_cast<Sphere const&>(**scene.shapes.find("s")).radius() == 2);
  CHECK((*scene.shapes.find("t"))->material()->kd() == Rgb(0, 1, 0));
  CHECK(scene.lights.size() == 1);
  CHECK(scene.lights.find("a")->brightness() == Rgb(2));
  CHECK(scene.cameras.size() == 1);
  CHECK(scene.cameras.find("eye")->fov_x_degrees() == 60);
}

TEST_CASE("keep going: redefinitions cannot close a cycle", "[unit][esdf]") {
  Scene const scene = scene_of(red +
                                   "define shape sphere a 0 0 0 1 red\n"
                                   "define shape composite b a\n"
                                   "define shape composite a b\n"
                                   "define shape composite b a\n",
                               keep_going);
  // b -> a -> the first b -> the first a
  Composite const* at = &composite(scene, "b");
  int depth = 0;
  while (at && depth < 100) {
    ++depth;
    REQUIRE(at->children().size() == 1);
    at = dynamic_cast<Composite const*>(at->children()[0].get());
  }
  CHECK(depth == 3);
  CHECK(scene.roots().size() == 1);
}

TEST_CASE("keep going: a render without its camera is left out", "[unit][esdf]") {
  CHECK(scene_of("camera a 45\ncamera b 45\nrender c x.png 1 1\nrender b x.png 1 1\n", keep_going).renders.size() == 1);
  CHECK(scene_of("camera a 450\nrender a x.png 1 1\n", keep_going).renders.empty());
}

TEST_CASE("keep going goes on after any number of problems", "[unit][esdf]") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "nonsense\n";
  CHECK(scene_of(text + eye, keep_going).cameras.size() == 1);
}
