#include "lichtraum.hpp"
#include "support/catch.hpp"

namespace {

std::string const start =
    "define material m 1 1 1 0 0 0 0 0 0 1\ndefine light ambient sky 1 1 1\ndefine camera eye 40 20 20\n";

std::string warning(std::string const& rest, std::string const& words = "") {
  Lichtraum const lichtraum;
  auto const result = lichtraum.render("- -o a.png " + words, start + rest);
  CHECK(result.exit_code == 0);
  return result.err;
}

std::string sphere_at(std::string const& center) { return "define shape sphere s " + center + " 1 m\n"; }

}  // namespace

TEST_CASE("a camera that sees nothing: where the scene is", "[app][view]") {
  CHECK_THAT(warning(sphere_at("0 0 -5")), !contains_text("sees nothing"));
  CHECK_THAT(warning(sphere_at("-5 0 -1.722")),
             contains_text("the scene is 71 degrees to the left of where the camera looks [W0816]\n"));
  CHECK_THAT(warning(sphere_at("5 0 0")),
             contains_text("is 90 degrees to the right of where the camera looks [W0816]\n"));
  CHECK_THAT(warning(sphere_at("0 5 -5")), contains_text("is 45 degrees above where the camera looks"));
  CHECK_THAT(warning(sphere_at("0 -5 -5")), contains_text("is 45 degrees below where the camera looks"));
  CHECK_THAT(warning(sphere_at("0 10 0")),
             contains_text("the scene is 90 degrees above where the camera looks [W0816]"));
  CHECK_THAT(warning(sphere_at("-5 5 -5")), contains_text("is 45 degrees to the left of and 35.3 degrees above where"));
  CHECK_THAT(warning(sphere_at("5 0 -0.01") + "transform s scale 0.1\n"), contains_text("right"));
  CHECK_THAT(warning(""), contains_text("draws no shapes"));
  CHECK_THAT(warning(sphere_at("0 0 5")),
             contains_text("the scene is behind the camera, which looks along -z: what lies "
                           "before it has a negative z [W0816]\n"));
  CHECK_THAT(warning(sphere_at("9 0 0") + "transform eye rotate 90 0 1 0\ntransform eye translate 1 2 3\n"),
             contains_text("behind the camera, which is at 1 2 3 and looks along -1 0 "));
  CHECK_THAT(warning("define shape sphere s 0.4 0.4 -5 1e-5 m\n"),
             contains_text("the scene is in view, 5 away and 3.46e-05 wide: its shapes are too small for the pixels"));
  std::string const beside = sphere_at("-6 0 -5") + "define shape sphere t 6 0 -5 1 m\n";
  CHECK_THAT(warning(beside), contains_text("its shapes lie beside what the camera sees"));
  CHECK_THAT(warning(sphere_at("9 0.1 -5") + "define camera flat 40 20 20 orthographic=4\n", "--camera flat"),
             contains_text("the scene is 9 units to the right of where the camera looks [W0816]"));
  CHECK(warning(sphere_at("0 0 5"), "-q").empty());
}

TEST_CASE("a camera that sees nothing: what is invisible", "[app][view]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("m.obj", "mtllib m.mtl\nusemtl clear\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  auto const said = [&](std::string const& dissolve) {
    lichtraum.folder.write("m.mtl", "newmtl clear\nKd 1 0 0\nd " + dissolve + "\n");
    return lichtraum.render("m.obj --size 32x24").err;
  };
  CHECK_THAT(said("0"), contains_text("or are invisible (alpha or d of 0) [W0816]"));
  CHECK_THAT(said("0.5"), !contains_text("sees nothing"));
}

TEST_CASE("a camera that sees nothing: which convention would show the scene", "[app][view]") {
  // The camera of the standard's example, and something that lies where it ought to look.
  std::string const standard =
      "define shape sphere s 0 0 0 20 m\ntransform eye rotate -45 0 1 0\ntransform eye translate 100 0 100\n";
  CHECK_THAT(warning(standard), contains_text("with --rotation left it is in view"));
  CHECK_THAT(warning(standard, "--rotation left"), !contains_text("sees nothing"));
  // Turned by 90 degrees to the left at the origin it sees -x; in its own frame, -10 along z is -x.
  std::string const order =
      "define shape sphere s -20 0 0 2 m\ntransform eye rotate 90 0 1 0\ntransform eye translate 0 0 -10\n";
  CHECK_THAT(warning(order), contains_text("with --transform-order local it is in view"));
  CHECK_THAT(warning(order, "--transform-order local"), !contains_text("sees nothing"));
  std::string const both =
      "define shape sphere s 20 0 0 2 m\ntransform eye rotate 90 0 1 0\ntransform eye translate 0 0 -10\n";
  CHECK_THAT(warning(both), contains_text("with --rotation left --transform-order local it is in view"));
  CHECK_THAT(warning(sphere_at("0 0 5")), !contains_text("it is in view"));
  // The options move it, whatever the file says.
  CHECK_THAT(warning(sphere_at("0 0 -5"), "--eye 0,0,5 --look-at 0,0,10"), !contains_text("it is in view"));
  CHECK_THAT(warning(sphere_at("0 0 -5") + "transform eye rotate 30 0 1 0\n", "--eye 0,0,5 --look-at 0,0,10"),
             !contains_text("it is in view"));
}
