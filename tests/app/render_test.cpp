#include <signal.h>

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "lichtraum/device.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

using Json = nlohmann::json;

TEST_CASE("formats are chosen by extension, for scene and command line", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  DecodedImage const expected = draw(lichtraum, "");
  REQUIRE(expected.width == 32);
  REQUIRE(expected.height == 24);
  REQUIRE(red_in_the_middle(expected) > 128);
  for (char const* const name : {"a.png", "a.ppm", "a.PNG", "a.exr", "a.pfm", "a.jpg", "a.jpeg"}) {
    REQUIRE(lichtraum.render(std::string("a.sdf -o ") + name).exit_code == 0);
    DecodedImage const image = decode(lichtraum.folder.read(name));
    CHECK(image.width == 32);
    CHECK(image.height == 24);
    float const scale = image.max == 0 ? 255.0f : 1.0f;
    float const tolerance = name[2] == 'j' ? 6.0f : 0.51f;  // JPEG loses some
    CHECK(std::abs(image.at(16, 12, 0) * scale - expected.at(16, 12, 0)) <= tolerance);
    CHECK(std::abs(image.at(0, 0, 0) * scale - expected.at(0, 0, 0)) <= tolerance);
  }
  CHECK(draw(lichtraum, "--format png").values == expected.values);
}

TEST_CASE("bits, ascii and quality change the file", "[app][render]") {
  Lichtraum const lichtraum;
  auto const words = [&](std::string const& text) { return lichtraum.render("- -o - --format " + text, ball_scene); };
  DecodedImage const wide = draw(lichtraum, "--bits 16");
  CHECK(wide.max == 65535);
  CHECK(draw(lichtraum, "--bits 16 --format png").values == wide.values);
  auto const ascii = words("ppm --ppm-ascii").out;
  CHECK(ascii.substr(0, 3) == "P3\n");
  CHECK(decode(ascii).values == draw(lichtraum, "").values);
  CHECK(words("jpg --size 200x150 --quality 5").out.size() < words("jpg --size 200x150").out.size());
  CHECK_THAT(words("png --quality 5").err, contains_text("--quality has no effect"));
  CHECK_THAT(words("exr --transfer srgb").err, contains_text("warning: --transfer has no effect"));
  CHECK_THAT(words("exr --exposure 3").err, contains_text("warning: --exposure has no effect"));
}

TEST_CASE("size: command line over render statement over camera over default", "[app][render]") {
  Lichtraum const lichtraum;
  auto const size = [&](std::string const& words, std::string const& scene) {
    DecodedImage const image = draw(lichtraum, words, scene);
    return std::pair(image.width, image.height);
  };
  std::string const camera = "define camera eye 60\n";
  std::string const sized_camera = "define camera eye 60 20 10\n";
  std::string const render = "render eye a.ppm 30 15\n";
  CHECK(size("--size 7x5", sized_camera + render) == std::pair(7, 5));
  CHECK(size("", sized_camera + render) == std::pair(30, 15));
  CHECK(size("", sized_camera + "render eye a.ppm\n") == std::pair(20, 10));
  CHECK(size("", sized_camera) == std::pair(20, 10));
  CHECK(size("", camera + "define resolution 12 8\n") == std::pair(12, 8));
  CHECK(size("", camera) == std::pair(640, 480));
  CHECK(size("--size 7x5", camera + "render eye a.ppm\n") == std::pair(7, 5));
  auto const nowhere = lichtraum.render("-", camera + "render eye a.ppm\n");
  CHECK(nowhere.exit_code == 65);
  CHECK_THAT(nowhere.err, contains_text("[E0808]") && contains_text("--size chooses one"));
}

TEST_CASE("samples and depth: command line over render statement over default", "[app][render]") {
  Lichtraum const lichtraum;
  auto const figures = [&](std::string const& words, std::string const& render) {
    auto const result = lichtraum.render("- --json -q " + words, "define camera eye 60\n" + render);
    REQUIRE(result.exit_code == 0);
    Json const picture = Json::parse(result.out)["scenes"][0]["pictures"][0];
    CHECK(picture["rays"]["camera"] == 12 * int(picture["samples"]));
    return std::pair(int(picture["samples"]), int(picture["depth"]));
  };
  CHECK(figures("", "render eye a.ppm 4 3\n") == std::pair(1, 5));
  CHECK(figures("", "render eye a.ppm 4 3 9 2\n") == std::pair(9, 2));
  CHECK(figures("--samples 3x3 --depth 0", "render eye a.ppm 4 3 6 2\n") == std::pair(9, 0));
  CHECK(figures("--samples 7", "render eye a.ppm 4 3 6 2\n") == std::pair(7, 2));
}

TEST_CASE("paths are traced when asked for, with samples and a depth of their own", "[app][render]") {
  Lichtraum const lichtraum;
  auto const by_reference = [&](std::string const& words) {
    auto const result = lichtraum.render("- -q -o - --format ppm --samples 4 " + words, ball_scene);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return decode(result.out).values;
  };
  CHECK(by_reference("--integrator path") != by_reference(""));
  if (lichtraum("devices --json").out.find("\"cpu\"") == std::string::npos) {
    SKIP_TEST("no OpenCL device");
  }
  auto const picture = [&](std::string const& words) {
    auto const result = lichtraum("render - -q -o - --format ppm --denoise builtin " + words, ball_scene);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return decode(result.out).values;
  };
  auto const paths = picture("--integrator path");
  CHECK(picture("--integrator whitted") == picture(""));
  CHECK(paths != picture(""));
  CHECK(picture("--integrator path --samples 64 --depth 64") == paths);
  CHECK(picture("--integrator path --samples 63") != paths);

  auto const asked_by_scene = [&](std::string const& words) {
    std::string scene = ball_scene;
    scene.insert(scene.size() - 1, " integrator=path samples=8 depth=3");
    auto const result = lichtraum("render - -q -o ball.png --json --denoise off " + words, scene);
    REQUIRE(result.exit_code == 0);
    Json const drawn = Json::parse(result.out)["scenes"][0]["pictures"][0];
    return std::tuple(drawn["integrator"].get<std::string>(), int(drawn["samples"]), int(drawn["depth"]));
  };
  CHECK(asked_by_scene("") == std::tuple("path", 8, 3));
  CHECK(asked_by_scene("--samples 2 --depth 4") == std::tuple("path", 2, 4));
  CHECK(asked_by_scene("--integrator whitted") == std::tuple("whitted", 8, 3));
  CHECK(asked_by_scene("--device reference") == std::tuple("path", 8, 3));
}

TEST_CASE("--ground stands a scene on one, matt unless it says otherwise", "[app][render]") {
  Lichtraum const lichtraum;
  auto const picture = [&](std::string const& words) {
    auto const result =
        lichtraum("render " + words + " - -o ball.png --json --samples 16 --device reference", ball_scene);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    Json const drawn = Json::parse(result.out)["scenes"][0]["pictures"][0];
    return std::pair(drawn["integrator"].get<std::string>(), lichtraum.folder.read("ball.png"));
  };
  auto const without = picture("--integrator path --ground=none"), matt = picture("--ground");
  CHECK(without.second == picture("--integrator path").second);
  CHECK(matt.first == "path");
  CHECK(matt.second != without.second);
  CHECK(picture("--ground=matt").second == matt.second);
  CHECK(picture("--ground=glossy").second != matt.second);
  CHECK(picture("--ground=glossy --ground").second == matt.second);
  auto const refusal = [&](std::string const& words) {
    auto const result = lichtraum("render - -o no.png --device reference " + words, ball_scene);
    CHECK(result.exit_code == 64);
    CHECK(!std::filesystem::exists(lichtraum.folder.path() / "no.png"));
    return result.err;
  };
  CHECK_THAT(refusal("--ground=blue"), contains_text("--ground: expected none, matt or glossy, not 'blue'"));
  CHECK_THAT(refusal("--ground --integrator whitted"), contains_text("error: --ground: whitted draws none"));
  CHECK_THAT(refusal("--ground=glossy --background none"), contains_text("--ground alone keeps shadows"));
  CHECK_THAT(refusal("--ground --depth 0"), contains_text("it takes 1 or more"));
}

TEST_CASE("--noise takes samples until the picture is quiet", "[app][render]") {
  Lichtraum const lichtraum;
  auto const picture = [&](std::string const& words) {
    auto const result =
        lichtraum("render - -o ball.pfm --json --device reference --integrator path " + words, ball_scene);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return std::pair(Json::parse(result.out)["scenes"][0]["pictures"][0], result.err);
  };
  auto const [quiet, nothing_said] = picture("--noise 0.2");
  CHECK(quiet["noise"] <= 0.2);
  CHECK(quiet["samples"] >= 32);
  CHECK(quiet["samples"] < 1024);
  std::string const bytes = lichtraum.folder.read("ball.pfm");
  CHECK(picture(fmt::format("--samples {}", int(quiet["samples"]))).first["noise"].is_null());
  CHECK(lichtraum.folder.read("ball.pfm") == bytes);
  auto const [noisy, warning] = picture("--noise 0.0001 --samples 48");
  CHECK(noisy["samples"] == 48);
  CHECK(warning.find("after 48 samples the noise is") != std::string::npos);
  CHECK(picture("--clamp 0.5").first["complete"] == true);
  CHECK(lichtraum("render - --clamp 0", ball_scene).exit_code == 64);
  CHECK(lichtraum("render - --clamp inf", ball_scene).exit_code == 64);
  auto const no_effect = lichtraum("render - --integrator whitted --clamp 1 --device reference -o b.png", ball_scene);
  CHECK(no_effect.err.find("--clamp has no effect on 'b.png'") != std::string::npos);
  CHECK(lichtraum("render - --noise 0", ball_scene).exit_code == 64);
  CHECK(lichtraum("render - --noise 1.5", ball_scene).exit_code == 64);
  CHECK(lichtraum("render - --noise 0.1 --samples 4x4 --device reference", ball_scene).exit_code == 64);
}

TEST_CASE("samples are seeded or a grid; one is the pixel's centre", "[app][render]") {
  Lichtraum const lichtraum;
  auto const one = draw(lichtraum, "").values;
  CHECK(draw(lichtraum, "--samples 1").values == one);
  CHECK(draw(lichtraum, "--samples 1x1").values == one);
  CHECK(draw(lichtraum, "--samples 1 --seed 9").values == one);
  auto const grid = draw(lichtraum, "--samples 4x4").values;
  CHECK(grid != one);
  CHECK(draw(lichtraum, "--samples 4x4 --seed 9").values == grid);
  auto const seeded = draw(lichtraum, "--samples 16").values;
  CHECK(seeded != grid);
  CHECK(draw(lichtraum, "--samples 16 --seed 0").values == seeded);
  CHECK(draw(lichtraum, "--samples 16 --seed 9").values != seeded);
}

TEST_CASE("a region is that part of the whole picture", "[app][render]") {
  Lichtraum const lichtraum;
  DecodedImage const whole = draw(lichtraum, "--samples 4");
  DecodedImage const part = draw(lichtraum, "--samples 4 --region 10,5,9,7");
  REQUIRE(part.width == 9);
  REQUIRE(part.height == 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) CHECK(part.at(x, y, 0) == whole.at(x + 10, y + 5, 0));
  }
}

TEST_CASE("camera, root, depth, tone map and transfer have their effect", "[app][render]") {
  Lichtraum const lichtraum;
  std::string const scene =
      "define material red 0.5 0 0 0 0 0 0 0 0 1\n"
      "define material mirror 0 0 0 0 0 0 0 0 0 1 reflect=1\n"
      "define shape sphere ball 0 0 -3 1 red\n"
      "define shape box wall -9 -9 -9 9 9 -8 mirror\n"
      "define light ambient sky 1 1 1\n"
      "define background 0 0.2 0\n"
      "define camera eye 60 31 31\n"
      "define camera back 60 31 31\n"
      "transform back rotate 180 0 1 0\n";
  std::string const render = "render eye a.ppm\n";
  DecodedImage const plain = draw(lichtraum, "", scene + render);
  CHECK(red_in_the_middle(plain) == 128);
  CHECK(red_in_the_middle(draw(lichtraum, "--camera back", scene + render)) == 0);
  CHECK(red_in_the_middle(draw(lichtraum, "--look-at 0,0,5", scene + render)) == 0);
  CHECK(red_in_the_middle(draw(lichtraum, "--camera back --orbit 0,0", scene + render)) == 128);
  CHECK(red_in_the_middle(draw(lichtraum, "--root wall", scene + render)) == 0);
  // Beside the ball the mirror shows the background; without a mirror ray it is black.
  CHECK(plain.at(0, 15, 1) == 51);
  CHECK(draw(lichtraum, "--depth 0", scene + render).at(0, 15, 1) == 0);
  // 0.5 / (0.5 + 1), and the transfer function of IEC 61966-2-1 at 0.5.
  CHECK(red_in_the_middle(draw(lichtraum, "--tonemap reinhard", scene + render)) == 85);
  CHECK(red_in_the_middle(draw(lichtraum, "--transfer srgb", scene + render)) == 188);
  CHECK(red_in_the_middle(draw(lichtraum, "--tonemap none --transfer linear", scene + render)) == 128);
  // A light as colour x brightness makes `auto` mean reinhard.
  std::string const bright = scene + "define light lamp 0 50 0 1 1 1 10\n" + render;
  CHECK(red_in_the_middle(draw(lichtraum, "", bright)) == 85);
  CHECK(red_in_the_middle(draw(lichtraum, "--tonemap none", bright)) == 128);
}

TEST_CASE("a background may be a colour of sRGB", "[app][render]") {
  Lichtraum const lichtraum;
  auto const corners = [&](std::string const& words) {  // of a picture with the ball in the middle
    DecodedImage const image = draw(lichtraum, "--transfer srgb --tonemap none " + words);
    std::vector<float> values;
    for (int const y : {0, 23}) {
      for (int channel = 0; channel < 3; ++channel) values.push_back(image.at(0, y, channel));
    }
    return values;
  };
  CHECK(corners("--background #336699") == std::vector<float>{0x33, 0x66, 0x99, 0x33, 0x66, 0x99});
  auto const gradient = corners("--background #FFeedd,0,0,0");  // its edges are half a pixel away
  CHECK((gradient[0] > 250 && gradient[1] < gradient[0] && gradient[2] < gradient[1] && gradient[3] < 60));
  CHECK(corners("--background 0,0,0,#ff0000")[3] > 250);
  // A stop is a factor of two, with or without its sign.
  CHECK(corners("--background 0.25,0.25,0.25 --exposure +1") == corners("--background 0.5,0.5,0.5"));
}

TEST_CASE("language options change how a scene is read", "[app][render]") {
  Lichtraum const lichtraum;
  std::string const start =
      "define material m 1 1 1 0 0 0 0 0 0 1\ndefine light ambient sky 1 1 1\ndefine camera eye 60 31 31\n";
  std::string const ball = "define shape sphere s 0 0 -5 1 m\n";
  // Turned by 90 degrees about z, then moved up: in its own frame that is sideways.
  std::string const moved = start + ball + "transform s rotate 90 0 0 1\ntransform s translate 0 2 0\n";
  DecodedImage const above = draw(lichtraum, "", moved);
  DecodedImage const beside = draw(lichtraum, "--transform-order local", moved);
  CHECK((above.at(15, 4, 0) == 255 && above.at(4, 15, 0) == 0));
  CHECK((beside.at(15, 4, 0) == 0 && beside.at(4, 15, 0) == 255));
  std::string const turned = start + ball + "transform s rotate 20 0 1 0\n";
  DecodedImage const left = draw(lichtraum, "", turned);
  DecodedImage const right = draw(lichtraum, "--rotation left", turned);
  CHECK((left.at(5, 15, 0) == 255 && left.at(25, 15, 0) == 0));
  CHECK((right.at(5, 15, 0) == 0 && right.at(25, 15, 0) == 255));
  CHECK(draw(lichtraum, "--rotation right --transform-order parent", turned).values == left.values);

  std::string const dialect = start + ball + "transform s scale 1 2 1\n";
  CHECK(lichtraum.render("- -o a.png", dialect).exit_code == 0);
  CHECK(lichtraum.render("- -o a.png --strict", dialect).exit_code == 65);
  auto const kept = lichtraum.render("- -o a.png --keep-going", start + "define shape sphere s 0 0 -5 1 gold\n");
  CHECK(kept.exit_code == 0);
  CHECK_THAT(kept.err, contains_text("<stdin>:4:") && contains_text("warning"));
  std::string const extras = start + "define material g 1 1 1 0 0 0 0 0 0 1 0.9\ndefine shape sphere s 0 0 -5 1 g\n";
  CHECK(red_in_the_middle(draw(lichtraum, "", extras)) == 255);
  CHECK(red_in_the_middle(draw(lichtraum, "--material-extras reflectance", extras)) < 50);
}

TEST_CASE("--json tells what was measured", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  Json const json = Json::parse(lichtraum.render("a.sdf bad.sdf --json").out);
  CHECK(json["device"]["kind"] == "reference");
  CHECK(json["total_ms"] > 0);
  REQUIRE(json["scenes"].size() == 2);
  CHECK(json["scenes"][0]["file"] == "a.sdf");
  CHECK(json["scenes"][0]["error"].is_null());
  CHECK(json["scenes"][0]["load_ms"] > 0);
  CHECK_THAT(std::string(json["scenes"][1]["error"]), contains_text("bad.sdf:1:"));
  Json const picture = json["scenes"][0]["pictures"].at(0);
  CHECK(picture["output"] == "ball.ppm");
  CHECK(picture["complete"] == true);
  CHECK(picture["width"] == 32);
  CHECK(picture["height"] == 24);
  CHECK(picture["program_ms"] == 0);  // the reference tracer has none
  CHECK(picture["trace_ms"] > 0);
  CHECK(picture["build_ms"] >= 0);
  Json const rays = picture["rays"];
  CHECK(rays["camera"] == 32 * 24);
  CHECK(rays["camera_hits"] > 0);
  CHECK(rays["camera_hits"] < 32 * 24);
  CHECK(rays["total"] == int(rays["camera"]) + int(rays["shadow"]) + int(rays["secondary"]));
  CHECK(picture["mrays_per_second"] > 0);
  // A picture on standard output leaves standard error for it.
  auto const piped = lichtraum.render("a.sdf -o - --json");
  CHECK(decode(piped.out).width == 32);
  CHECK(Json::parse(piped.err)["scenes"][0]["pictures"][0]["output"] == "standard output");
  Json const faulty = Json::parse(lichtraum.render("bad.sdf -o - --json").err);
  CHECK(faulty["scenes"][0]["exit_status"] == 65);
  CHECK(faulty["scenes"][0]["diagnostics"].size() > 0);
  Json const warned = Json::parse(lichtraum.render("a.sdf -o - --json --both-sides").err);
  CHECK(warned["scenes"][0]["diagnostics"].size() == 1);
  CHECK_THAT(lichtraum.render("a.sdf -o - --json -v").err, contains_text("standard output"));
  CHECK_THAT(lichtraum.render("a.sdf --json").err, contains_text("ball.ppm"));
}

TEST_CASE("quiet says nothing, verbose says more", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene + std::string("transform ball scale 1 1 1\n"));
  CHECK(lichtraum.render("a.sdf -q").err.empty());
  CHECK_THAT(lichtraum.render("a.sdf").err, !contains_text("note:"));
  CHECK_THAT(lichtraum.render("a.sdf -v").err, contains_text("note:") && contains_text("rays: 768 camera"));
  CHECK_THAT(lichtraum.render("a.sdf -v").err, contains_text(" mirror and glass\n"));
  CHECK_THAT(lichtraum.render("a.sdf -v --integrator path --samples 1").err, contains_text(" scattered\n"));
}

TEST_CASE("colours and a progress bar are for terminals only", "[app][render]") {
  if (!has_pseudo_terminals()) SKIP_TEST("there are no pseudo-terminals here");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  auto const on_terminal = [&](std::string const& words, bool no_color) {
    Process process = lichtraum.process("render --device reference " + words);
    process.has_terminal = true;
    process.environment = {{"TERM", "xterm"}, {"NO_COLOR", no_color ? "1" : ""}};
    return run_process(process).err;
  };
  CHECK_THAT(on_terminal("bad.sdf", false), contains_text("\x1b[1;31merror:\x1b[0m"));
  CHECK_THAT(on_terminal("bad.sdf", true), !contains_text("\x1b["));

  // A minute of work on two cores, interrupted when a bar must have been seen.
  auto const interrupted = [&](std::string const& words, bool has_terminal) {
    Process process = lichtraum.process("render --device reference a.sdf --size 600x450 --samples 60x60 " + words);
    process.has_terminal = has_terminal;
    process.signals = {{.number = SIGINT, .after_cpu_seconds = 3}};
    return run_process(process).err;
  };
  CHECK_THAT(interrupted("", true), contains_text("Mrays/s  ") && contains_text(" left") && contains_text("%"));
  CHECK_THAT(interrupted("-q", true), !contains_text("Mrays/s"));
  CHECK_THAT(interrupted("", false), !contains_text(" left"));
}

TEST_CASE("a terminal is told that the device's compiler is at work", "[app][render]") {
  if (!has_pseudo_terminals()) SKIP_TEST("there are no pseudo-terminals here");
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const told = [&](std::string const& words, bool has_terminal) {
    Process process = lichtraum.process("render a.sdf --size 16x16 " + words);
    process.has_terminal = has_terminal;
    process.environment = {{"LICHTRAUM_KERNEL_DIR", project_path("kernels")}};
    auto const result = run_process(process);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(told("", true), contains_text("ball.ppm  compiling for the device\x1b[K\r"));
  CHECK_THAT(told("-q", true), !contains_text("compiling"));
  CHECK_THAT(told("", false), !contains_text("compiling"));
  CHECK_THAT(told("--device reference", true), !contains_text("compiling"));
}

TEST_CASE("what only models have is said to have no effect on scenes", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  for (char const* const words : {"--time 3", "--animation walk"}) {
    auto const result = lichtraum.render(std::string("a.sdf ") + words);
    CHECK(result.exit_code == 0);
    std::string const name = std::string(words).substr(0, std::string(words).find(' '));
    CHECK_THAT(result.err, contains_text("warning: " + name + " has no effect on 'ball.ppm'"));
  }
  for (std::string const option : {"--variant x", "--scene 3", "--both-sides", "--max-texture 8", "--point-size 4"}) {
    std::string const name = option.substr(0, option.find(' '));
    CHECK_THAT(lichtraum.render("a.sdf " + option).err, contains_text(name + " has no effect on 'ball.ppm'"));
  }
  CHECK(lichtraum.render("a.sdf").err.find("no effect") == std::string::npos);
}

TEST_CASE("a ground that is not where up is, is told", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const said = [&](std::string const& words) {
    return lichtraum.render("a.sdf --device reference --size 4x4 --samples 1 --ground " + words).err;
  };
  CHECK_THAT(said("--up 0,0,1"), contains_text("--ground has no effect on 'ball.ppm': under a scene it is level in y"));
  CHECK_THAT(said("--up 0,-1,0"), contains_text("--ground has no effect"));
  CHECK_THAT(said("--up 0,2,0"), !contains_text("no effect"));
  CHECK_THAT(said(""), !contains_text("no effect"));
}

TEST_CASE("a ground that nothing stands on is told", "[app][render]") {
  Lichtraum const lichtraum;
  std::string const floor =
      "define material m 1 1 1 1 1 1 0 0 0 1\ndefine light ambient sky 0.5 0.5 0.5\ndefine camera eye 60\n"
      "define shape plane floor 0 -1 0 0 1 0 m\n";
  auto const said = [&](std::string const& command, std::string const& shapes, std::string const& words) {
    lichtraum.folder.write("a.sdf", floor + shapes + "render eye a.ppm 4 4\n");
    return lichtraum(command + " a.sdf --device reference --samples 1 " + words).err;
  };
  std::string const ball = "define shape sphere s 0 0 -5 1 m\n";
  for (std::string const command : {"render", "check"}) {
    CHECK_THAT(said(command, "", "--ground"), contains_text("warning: --ground has no effect on 'a.ppm': all that is "
                                                            "drawn is infinite, so nothing stands on it [W0101]"));
    CHECK_THAT(said(command, ball, "--ground"), !contains_text("no effect"));
    CHECK_THAT(said(command, ball, "--ground --root floor"), contains_text("--ground has no effect"));
    CHECK_THAT(said(command, "", "--integrator path"), !contains_text("no effect"));
  }
  CHECK_THAT(said("render", "", "--ground --planes depth -o a.exr"),
             contains_text("--ground has no effect on 'a.exr'"));
  CHECK_THAT(said("render", "", "--ground --planes depth -o a.exr"), !contains_text("all that is drawn is infinite"));
}

TEST_CASE("an environment that lights nothing is said to have no effect", "[app][render]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const said = [&](std::string const& words) {
    return lichtraum.render("a.sdf --device reference --size 4x4 --samples 1 " + words).err;
  };
  for (std::string const option : {"--environment studio", "--environment-rotation 9", "--environment-brightness 5"}) {
    std::string const name = option.substr(0, option.find(' '));
    CHECK_THAT(said("--integrator whitted " + option), contains_text(name + " has no effect on 'ball.ppm'"));
  }
  CHECK_THAT(said("--integrator path --environment none --environment-rotation 9"),
             contains_text("--environment-rotation has no effect on 'ball.ppm'"));
  CHECK_THAT(said("--environment studio --environment-rotation 9 --environment-brightness 5"),
             !contains_text("no effect"));
  for (std::string const option : {"--environment-rotation 9", "--environment-brightness 5"}) {
    std::string const name = option.substr(0, option.find(' '));
    CHECK_THAT(said("--integrator path " + option),
               contains_text(name + " has no effect on 'ball.ppm': the scene has no environment [W0101]"));
  }
  CHECK_THAT(said("--integrator whitted --environment none"), !contains_text("no effect"));
}
