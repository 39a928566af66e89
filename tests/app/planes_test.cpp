#include <algorithm>
#include <cmath>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/subprocess.hpp"

namespace {

/// A ball of radius 1 six units before the camera, left of the middle, before a wall; sky above.
constexpr char const* scene =
    "define material grey 0 0 0  0.5 0.5 0.5  0 0 0  1\n"
    "define shape box wall -9 -9 -9 9 2 -8 grey\n"
    "define shape sphere ball -1 0 -6  1 grey\n"
    "define shape composite both wall ball\n"
    "define background 0.5 0.25 0\n"
    "define camera eye 60 64 48\n";

std::size_t pixel(int x, int y) { return 64 * std::size_t(y) + std::size_t(x); }

ProcessResult run(std::vector<std::string> words) {
  words.insert(words.begin(), "/usr/bin/env");
  return run_process({.arguments = std::move(words)});
}

bool is_there(std::string const& command) { return run({"sh", "-c", "command -v " + command}).exit_code == 0; }

}  // namespace

TEST_CASE("planes are drawn instead of a picture", "[app][planes]") {
  Lichtraum const lichtraum;
  auto const draw = [&](std::string const& planes, std::string const& file) {
    auto const result = lichtraum.render("- --planes " + planes + " -o " + file, scene);
    CHECK(result.exit_code == 0);
    CHECK(result.err.find("warning") == std::string::npos);
    return lichtraum.folder.read(file);
  };
  // The middles of the wall, the ball and the sky; a pixel's middle is half a pixel off them.
  auto const depth = decode_exr_floats(draw("depth", "depth.exr"), "Z");
  CHECK(depth.at(pixel(32, 24)) == Approx(8).epsilon(0.001));
  CHECK(depth.at(pixel(22, 24)) == Approx(std::sqrt(37.0) - 1).epsilon(0.01));
  CHECK(std::isinf(depth.at(pixel(32, 2))));
  auto const object = decode(draw("object", "object.pfm"));
  CHECK(object.at(32, 24, 0) == 1);
  CHECK(object.at(22, 24, 0) == 2);
  CHECK(object.at(32, 2, 0) == 0);
  auto const normal = decode(draw("normal", "normal.png"));
  CHECK(normal.at(32, 24, 2) == 255);
  CHECK((normal.at(16, 24, 0) < 90 && normal.at(16, 24, 2) > 128));
  CHECK(normal.at(32, 2, 2) == 0);
  auto const shown = decode(draw("depth", "depth.png"));
  CHECK(shown.at(22, 24, 0) > shown.at(32, 24, 0) + 50);
  CHECK(shown.at(32, 24, 0) > shown.at(32, 2, 0));
}

TEST_CASE("several planes are layers of one OpenEXR file", "[app][planes]") {
  Lichtraum const lichtraum;
  std::string const all = "radiance,alpha,depth,normal,albedo,position,object,instance,material";
  auto const result = lichtraum.render("- -q --planes " + all + " -o all.exr", scene);
  REQUIRE(result.exit_code == 0);
  std::string const bytes = lichtraum.folder.read("all.exr");
  CHECK(decode_exr_floats(bytes, "A").at(pixel(32, 2)) == 0);
  CHECK(decode_exr_floats(bytes, "R").at(pixel(32, 2)) == 0);  // alpha leaves out the background
  CHECK(decode_exr_floats(bytes, "albedo.G").at(pixel(32, 24)) == 0.5f);
  CHECK(decode_exr_floats(bytes, "P.Z").at(pixel(32, 24)) == Approx(-8).epsilon(1e-6));
  CHECK(decode_exr_numbers(bytes, "object").at(pixel(22, 24)) == 2);
  CHECK(decode_exr_numbers(bytes, "material").at(pixel(22, 24)) == 1);
  CHECK(decode_exr_numbers(bytes, "instance").at(pixel(22, 24)) == 0);
  // Each is what it is alone.
  REQUIRE(lichtraum.render("- -q --planes normal -o normal.exr", scene).exit_code == 0);
  CHECK(decode_exr_floats(bytes, "N.X") == decode_exr_floats(lichtraum.folder.read("normal.exr"), "N.X"));
}

TEST_CASE("other programs read the planes", "[app][planes]") {
  Lichtraum const lichtraum;
  REQUIRE(lichtraum.render("- -q --planes radiance,depth,object -o some.exr", scene).exit_code == 0);
  std::string const file = (lichtraum.folder / "some.exr").string();
  if (!is_there("exrheader")) SKIP_TEST("no exrheader (Debian package openexr)");
  auto const header = run({"exrheader", file});
  CHECK(header.exit_code == 0);
  for (char const* const line : {"R, 32-bit floating-point", "Z, 32-bit floating-point", "object, 32-bit unsigned"}) {
    CHECK_THAT(header.out, contains_text(line));
  }
  if (!is_there("convert")) SKIP_TEST("no convert (Debian package imagemagick)");
  // Without whole numbers, on which ImageMagick 7 (7.1.1-43) aborts, whoever wrote the file.
  REQUIRE(lichtraum.render("- -q --planes radiance,depth -o some.exr", scene).exit_code == 0);
  std::string const converted = (lichtraum.folder / "some.ppm").string();
  auto const convert = run({"convert", file, "-set", "colorspace", "sRGB", "-depth", "8", converted});
  INFO(convert.err);
  REQUIRE(convert.exit_code == 0);
  REQUIRE(lichtraum.render("- -q -o direct.ppm", scene).exit_code == 0);
  auto const expected = decode(lichtraum.folder.read("direct.ppm")), actual = decode(lichtraum.folder.read("some.ppm"));
  REQUIRE(actual.values.size() == expected.values.size());
  for (std::size_t i = 0; i < expected.values.size(); ++i) {
    REQUIRE(std::abs(actual.values[i] - expected.values[i]) <= 1);
  }
}

TEST_CASE("a picture without background is transparent", "[app][planes]") {
  Lichtraum const lichtraum;
  REQUIRE(lichtraum.render("- -q --samples 4x4 --background none -o cut.png", scene).exit_code == 0);
  auto const picture = decode(lichtraum.folder.read("cut.png"));
  REQUIRE(picture.alpha.size() == 64 * 48);
  CHECK(picture.alpha.at(pixel(32, 2)) == 0);
  CHECK(picture.alpha.at(pixel(32, 24)) == 255);
  CHECK(std::ranges::any_of(picture.alpha, [](float a) { return a > 0 && a < 255; }));
  CHECK(picture.at(32, 2, 0) == 0);
  auto const refused = lichtraum.render("- --background none -o cut.jpg", scene);
  CHECK(refused.exit_code == 64);
  CHECK_THAT(refused.err, contains_text("'cut.jpg' cannot be transparent: .png and .exr pictures can"));

  auto const sky = draw(lichtraum, "--background 0,0.5,1", scene);
  CHECK((sky.at(32, 2, 0) == 0 && sky.at(32, 2, 1) == 128 && sky.at(32, 2, 2) == 255));
  auto const dusk = draw(lichtraum, "--background 0,0,1,1,0,0", scene);
  CHECK((dusk.at(0, 0, 0) == 3 && dusk.at(0, 0, 2) == 252));  // half a row of 48
  CHECK((dusk.at(0, 8, 0) == 45 && dusk.at(0, 8, 2) == 210));
  auto const bytes = lichtraum.render("- --background 255,255,255 -o x.png", scene);
  CHECK(bytes.exit_code == 0);
  CHECK_THAT(bytes.err, contains_text("--background: its colours are linear, and 1 is white [W0506]") &&
                            contains_text("write colours from 0 to 255 as '#rrggbb'"));
  CHECK(lichtraum.render("- --background 5,5,5 -o x.png", scene).err.find("W0506") == std::string::npos);
  auto const nowhere = lichtraum.render("- --background environment -o x.png", scene);
  CHECK(nowhere.exit_code == 64);
  CHECK_THAT(nowhere.err, contains_text("error: --background environment: it can be seen only with an environment"));
}

TEST_CASE("a picture of albedo is stored as colours are", "[app][planes]") {
  Lichtraum const lichtraum;
  // 0.5 is 188 of 255 in sRGB (IEC 61966-2-1).
  CHECK(draw(lichtraum, "--planes albedo", scene).at(32, 24, 1) == 128);
  CHECK(draw(lichtraum, "--planes albedo --transfer srgb", scene).at(32, 24, 1) == 188);
  CHECK(draw(lichtraum, "--planes alpha --transfer srgb --samples 4x4", scene).values ==
        draw(lichtraum, "--planes alpha --samples 4x4", scene).values);
  CHECK_THAT(lichtraum.render("- --planes albedo --transfer srgb -o a.png", scene).err, !contains_text("no effect"));
}

TEST_CASE("exposure is in stops", "[app][planes]") {
  Lichtraum const lichtraum;
  CHECK(draw(lichtraum, "--exposure 1", scene).at(32, 2, 1) == 128);
  CHECK(draw(lichtraum, "--exposure -1", scene).at(32, 2, 0) == 64);
}

TEST_CASE("planes that cannot be are refused, and what has no effect on them is said", "[app][planes]") {
  Lichtraum const lichtraum;
  auto const result = lichtraum.render(
      "- --planes object --samples 4x4 --depth 2 --transfer srgb --background none -o object.png", scene);
  CHECK(result.exit_code == 0);
  for (char const* const option : {"--samples", "--depth", "warning: --transfer", "--background"}) {
    CHECK_THAT(result.err, contains_text(std::string(option) + " has no effect on 'object.png'"));
  }
  auto const two = lichtraum.render("- --planes normal,depth -o two.png", scene);
  CHECK(two.exit_code == 64);
  CHECK_THAT(two.err, contains_text("--planes normal,depth: 'two.png' has room for one; .exr has for all"));
  CHECK(!std::filesystem::exists(lichtraum.folder / "two.png"));
  for (char const* const words : {"--planes nonsense", "--planes depth,", "--planes id", "--background red",
                                  "--background 1,2", "--background -1,0,0", "--background 1,2,3,4",
                                  "--background 0,0,0,0,0,nan", "--exposure much", "--exposure 1e9"}) {
    INFO(words);
    CHECK(lichtraum.render(std::string("- -o x.png ") + words, scene).exit_code == 64);
  }
}

TEST_CASE("a region of a picture that no memory could hold is drawn", "[app][planes]") {
  Lichtraum const lichtraum;
  auto const result = lichtraum.render("- -q --size 1000000x1000000 --region 499990,499990,20,20 -o part.png", scene);
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(decode(lichtraum.folder.read("part.png")).width == 20);
  auto const whole = lichtraum.render("- --size 1000000x1000000 -o whole.exr", scene);
  CHECK(whole.exit_code == 64);
  CHECK_THAT(whole.err, contains_text("--region draws a part of it"));
}
