#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct Frame {
  std::string file;
  std::size_t shapes;
  Vec3 place;            // of shape "s"
  Shape const* address;  // of it
};

std::vector<Frame> play(EsdfScript const& script, std::size_t stop_after = 1000) {
  std::vector<Frame> frames;
  script.play([&](Scene const& scene, RenderCommand const& command) {
    auto const* const s = scene.shapes.find("s");
    frames.push_back({command.file, scene.shapes.size(), s ? (*s)->world_from_object().point(Vec3(0)) : Vec3(0),
                      s ? s->get() : nullptr});
    return frames.size() < stop_after;
  });
  return frames;
}

std::string const animation = red + eye +
                              "define shape sphere s 0 0 0 1 red\n"
                              "render eye 1.png 8 8\n"
                              "transform s translate 1 0 0\n"
                              "render eye 2.png 8 8\n"
                              "define shape sphere late 0 0 0 1 red\n"
                              "transform s translate 1 0 0\n"
                              "render eye 3.png 8 8\n"
                              "transform s translate 100 0 0\n";

}  // namespace

TEST_CASE("render draws the scene as defined up to its line", "[unit][esdf]") {
  EsdfScript const script = EsdfScript::from_text(animation, "s.sdf");
  auto const frames = play(script);
  REQUIRE(frames.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(frames[i].file == std::to_string(i + 1) + ".png");
    CHECK(frames[i].place == Vec3(double(i), 0, 0));
    CHECK(frames[i].shapes == (i == 2 ? 2 : 1));
    CHECK(frames[i].address == frames[0].address);
  }
  CHECK((*script.scene().shapes.find("s"))->world_from_object().point(Vec3(0)) == Vec3(102, 0, 0));
  CHECK(script.scene().renders.size() == 3);
  // It can be played again, and stopped.
  CHECK(play(script).size() == 3);
  CHECK(play(script, 2).size() == 2);
}

TEST_CASE("a script that is rewound has the scene of its first picture, and all cameras", "[unit][esdf]") {
  EsdfScript script = EsdfScript::from_text(
      animation + "define material late_red 1 1 1  1 1 1  1 1 1  1\ndefine camera late_eye 45\n", "s.sdf");
  script.rewind();
  Scene const& scene = script.scene();
  CHECK((*scene.shapes.find("s"))->world_from_object().point(Vec3(0)) == Vec3(0));
  CHECK(scene.shapes.size() == 1);
  CHECK(scene.renders.size() == 3);
  CHECK(scene.cameras.contains("late_eye"));
  CHECK(scene.materials.contains("late_red"));
  CHECK(play(script).size() == 3);

  EsdfScript still = EsdfScript::from_text(red + eye + "define shape sphere s 0 0 0 1 red\n", "s.sdf");
  still.rewind();
  CHECK(still.scene().shapes.size() == 1);
}

TEST_CASE("renders at the end of a file draw its finished scene", "[unit][esdf]") {
  EsdfScript const script = EsdfScript::from_text(
      red + eye + "define shape sphere s 0 0 0 1 red\nrender eye 1.png 8 8\nrender eye 2.png 8 8\n# end\n", "s.sdf");
  auto const frames = play(script);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].address == script.scene().shapes.find("s")->get());  // nothing was built a second time
  CHECK(play(script, 1).size() == 1);
}

TEST_CASE("a file without render gets no call", "[unit][esdf]") {
  CHECK(play(EsdfScript::from_text(red + eye, "s.sdf")).empty());
}

TEST_CASE("what is played obeys the options", "[unit][esdf]") {
  EsdfOptions options;
  options.keep_going = true;
  options.rotation = RotationSense::left;
  EsdfScript const script = EsdfScript::from_text(red + eye +
                                                      "define shape sphere s 0 0 0 1 red\nnonsense\n"
                                                      "transform s translate 1 0 0\n"
                                                      "render eye 1.png 8 8\n"
                                                      "transform s rotate 90 z\n"
                                                      "render eye 2.png 8 8\n",
                                                  "s.sdf", options);
  auto const frames = play(script);
  REQUIRE(frames.size() == 2);
  CHECK(glm::length(frames[1].place - Vec3(0, -1, 0)) < 1e-12);
  CHECK(script.diagnostics().size() == 2);  // the nonsense and the note on 'z', each once
}

TEST_CASE("a script may be moved before it is played", "[unit][esdf]") {
  EsdfScript first = EsdfScript::from_text(animation, "s.sdf");
  EsdfScript second = std::move(first);
  CHECK(play(second).size() == 3);
  Scene const scene = std::move(second).take_scene();
  CHECK(scene.shapes.size() == 2);
}
