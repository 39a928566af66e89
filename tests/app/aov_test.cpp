#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"

namespace {

/// A ball of radius 1 six units before the camera, left of the middle, before a wall; sky above.
constexpr char const* scene =
    "define material grey 0 0 0  0.5 0.5 0.5  0 0 0  1\n"
    "define shape box wall -9 -9 -9 9 2 -8 grey\n"
    "define shape sphere ball -1 0 -6  1 grey\n"
    "define shape composite both wall ball\n"
    "define camera eye 60 64 48\n";

}  // namespace

TEST_CASE("depth, normals and object numbers are drawn instead of a picture", "[app][aov]") {
  Lichtraum const lichtraum;
  auto const draw = [&](std::string const& aov, std::string const& file) {
    auto const result = lichtraum.render("- --aov " + aov + " -o " + file, scene);
    CHECK(result.exit_code == 0);
    CHECK(result.err.find("warning") == std::string::npos);
    return decode(lichtraum.folder.read(file));
  };
  // The middles of the wall, the ball and the sky; a pixel's middle is half a pixel off them.
  auto const depth = draw("depth", "depth.exr");
  CHECK(depth.at(32, 24, 0) == Approx(8).epsilon(0.001));
  CHECK(depth.at(22, 24, 1) == Approx(std::sqrt(37.0) - 1).epsilon(0.01));
  CHECK(std::isinf(depth.at(32, 2, 2)));
  auto const id = draw("id", "id.pfm");
  CHECK(id.at(32, 24, 0) == 1);
  CHECK(id.at(22, 24, 0) == 2);
  CHECK(id.at(32, 2, 0) == 0);
  auto const normal = draw("normal", "normal.png");
  CHECK(normal.at(32, 24, 2) == 255);
  CHECK((normal.at(16, 24, 0) < 90 && normal.at(16, 24, 2) > 128));
  CHECK(normal.at(32, 2, 2) == 0);
  auto const shown = draw("depth", "depth.png");
  CHECK(shown.at(22, 24, 0) > shown.at(32, 24, 0) + 50);
  CHECK(shown.at(32, 24, 0) > shown.at(32, 2, 0));
}

TEST_CASE("what has no effect on depth, normals and object numbers is said", "[app][aov]") {
  Lichtraum const lichtraum;
  auto const result = lichtraum.render("- --aov id --samples 4x4 --depth 2 --transfer srgb -o id.png", scene);
  CHECK(result.exit_code == 0);
  for (char const* const option : {"--samples", "--depth", "--tonemap and --transfer"}) {
    CHECK_THAT(result.err, contains_text(std::string(option) + " has no effect on 'id.png'"));
  }
  CHECK(lichtraum("render x.sdf --aov nonsense").exit_code == 64);
}
