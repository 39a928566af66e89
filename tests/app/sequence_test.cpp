#include <signal.h>

#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/project_files.hpp"

using Json = nlohmann::json;

namespace {

/// The ball somewhere else.
std::string scene_with_ball_at(double x) {
  return "define material red 0.5 0 0 0.5 0 0 0 0 0 1\n"
         "define shape sphere ball " +
         std::to_string(x) +
         " 0 -3 1 red\n"
         "define light ambient sky 1 1 1\n"
         "define light diffuse sun 5 5 0 1 1 1\n"
         "define camera eye 60 32 24\n";
}

/// A white square that moves along x, from 0 to 2 in two seconds.
lichtraum::testing::GltfWriter moving_square() {
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0});
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const places = writer.add_vec3({0, 0, 0, 2, 0, 0});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"aspectRatio", 1}, {"znear", 1}}}}};
  writer.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 6}}});
  return writer;
}

std::vector<float> values(Lichtraum const& lichtraum, std::string const& name) {
  return decode(lichtraum.folder.read(name)).values;
}

int drawn(Json const& report) {
  int count = 0;
  for (Json const& scene : report["scenes"]) {
    for (Json const& picture : scene["pictures"]) count += picture["skipped"] ? 0 : 1;
  }
  return count;
}

}  // namespace

TEST_CASE("the camera that a model is given stands still from frame to frame", "[app][sequence][gltf]") {
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer = moving_square();
  writer.json["nodes"].erase(1);
  writer.json.erase("cameras");
  // A second square, which stays where it is.
  writer.json["nodes"].push_back({{"mesh", 0}, {"translation", {-4, 0, 0}}});
  writer.json["scenes"] = {{{"nodes", {0, 1}}}};
  lichtraum.folder.write("model.glb", writer.glb());
  std::string const options = "model.glb -q --integrator whitted --size 48x32 --orbit 0,0 ";
  using Columns = std::pair<int, int>;
  auto const columns = [&](std::string const& name) {  // the first and the last one that are not black
    auto const image = decode(lichtraum.folder.read(name));
    Columns found{-1, -1};
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, image.height / 2, 0) <= 20) continue;
      if (found.first < 0) found.first = x;
      found.second = x;
    }
    return found;
  };
  REQUIRE(lichtraum.render(options + "--fps 1 --frames 0..2 -o %d.png").exit_code == 0);
  CHECK(columns("0.png").first > 0);
  CHECK(columns("1.png").first == columns("0.png").first);
  CHECK(columns("2.png").first == columns("0.png").first);
  CHECK(columns("2.png").second > columns("1.png").second);
  CHECK(columns("1.png").second > columns("0.png").second);
  // Whichever frames are asked for.
  REQUIRE(lichtraum.render(options + "--fps 1 --frames 1..1 -o alone%d.png").exit_code == 0);
  CHECK(lichtraum.folder.read("alone1.png") == lichtraum.folder.read("1.png"));
  // One pose by itself fills the picture.
  REQUIRE(lichtraum.render(options + "--time 0 -o pose.png").exit_code == 0);
  CHECK(columns("pose.png").second > columns("0.png").second);
}

TEST_CASE("times outside of an animation are warned about", "[app][sequence][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("model.glb", moving_square().glb());
  auto const warning = [&](std::string const& words) {
    auto const result = lichtraum("check model.glb --device reference --size 16x16 -o %d.png " + words);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(warning("--time 99"), contains_text("the animation is 2 s long: at 99 s it stands still [W0822]"));
  CHECK_THAT(warning("--time -5"), contains_text("at -5 s it stands still"));
  CHECK_THAT(warning("--frames 1000..1001"), contains_text("in 2 of the 2 frames it stands still"));
  CHECK_THAT(warning("--frames 45..52"),
             contains_text("in 2 of the 8 frames") && contains_text("--frames 0..50 shows"));
  for (char const* const inside : {"--time 0", "--time 2", "--frames 0..50", "--animation 0 --time 1", ""}) {
    INFO(inside);
    CHECK(warning(inside).find("warning") == std::string::npos);
  }
}

TEST_CASE("an animation that no time shows is said to have no effect", "[app][sequence][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("model.glb", moving_square().glb());
  auto const said = [&](std::string const& words) {
    return lichtraum("check model.glb --device reference --size 16x16 -o %d.png --animation 0 " + words).err;
  };
  CHECK_THAT(said(""), contains_text("--animation has no effect on '1.png': without --time, --frames"));
  CHECK_THAT(said("--turntable 2"), contains_text("--animation has no effect"));
  CHECK(said("--time 1").find("no effect") == std::string::npos);
  CHECK(said("--frames 0..1").find("no effect") == std::string::npos);
}

TEST_CASE("a pattern is the files that it matches, in the order of their numbers", "[app][sequence]") {
  Lichtraum const lichtraum;
  std::filesystem::create_directory(lichtraum.folder / "frames");
  for (int i : {1, 2, 10}) {
    lichtraum.folder.write("frames/ball" + std::to_string(i) + ".sdf", scene_with_ball_at(0.1 * i));
  }
  auto const result = lichtraum.render("frames/*.sdf -o %04d.png");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  REQUIRE(lichtraum.folder.names() == std::vector<std::string>{"0001.png", "0002.png", "0003.png", "frames"});
  for (int i : {1, 2, 3}) {
    std::string const file = "frames/ball" + std::to_string(i == 3 ? 10 : i) + ".sdf";
    REQUIRE(lichtraum.render(file + " -o alone.png").exit_code == 0);
    CHECK(lichtraum.folder.read("000" + std::to_string(i) + ".png") == lichtraum.folder.read("alone.png"));
  }
  CHECK(values(lichtraum, "0001.png") != values(lichtraum, "0003.png"));

  auto const none = lichtraum.render("nothing/*.sdf");
  CHECK(none.exit_code == 66);
  CHECK_THAT(none.err, contains_text("no file matches 'nothing/*.sdf' ["));
  auto const deep = lichtraum.render("nothing/**/*.sdf");
  CHECK(deep.exit_code == 66);
  CHECK_THAT(deep.err, contains_text("no file matches 'nothing/**/*.sdf': * stays within one folder"));
  auto const folder = lichtraum.render("frames");
  CHECK(folder.exit_code == 66);
  CHECK_THAT(folder.err, contains_text("cannot open 'frames': it is a folder; the scenes in it are 'frames/*.sdf'"));
  // A file whose name looks like a pattern is not one.
  lichtraum.folder.write("ball[1].sdf", scene_with_ball_at(0));
  CHECK(lichtraum.render("ball[1].sdf").exit_code == 0);
  CHECK(std::filesystem::exists(lichtraum.folder / "ball[1].png"));
}

TEST_CASE("a faulty input of a sequence is left out, in order", "[app][sequence]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("1.sdf", scene_with_ball_at(0));
  lichtraum.folder.write("2.sdf", "define nonsense\n");
  lichtraum.folder.write("3.sdf", scene_with_ball_at(1));
  auto const result = lichtraum.render("?.sdf --json");
  CHECK(result.exit_code == 65);
  CHECK(result.err.find("1.png") < result.err.find("nonsense"));
  CHECK(result.err.find("nonsense") < result.err.find("3.png"));
  CHECK_THAT(result.err, contains_text("1 of 3 scenes could not be drawn"));
  CHECK(drawn(Json::parse(result.out)) == 2);
}

TEST_CASE("a faulty input of a sequence leaves the numbers of the next pictures as they are", "[app][sequence]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("1.sdf", scene_with_ball_at(0));
  lichtraum.folder.write("2.sdf", "define nonsense\n");
  lichtraum.folder.write("3.sdf", "define material red 1 0 0 1 0 0 0 0 0 1\n");  // without a camera
  lichtraum.folder.write("4.sdf", scene_with_ball_at(1));
  auto const pictures = [&](std::string const& words) {
    CHECK(lichtraum.render("?.sdf -q -o %d.png " + words).exit_code == 65);
    std::vector<std::string> found;
    for (std::string const& name : lichtraum.folder.names()) {
      if (!name.ends_with(".png")) continue;
      found.push_back(name);
      std::filesystem::remove(lichtraum.folder / name);
    }
    return found;
  };
  CHECK(pictures("") == std::vector<std::string>{"1.png", "4.png"});
  // What cannot be read counts as one picture.
  CHECK(pictures("--turntable 2") == std::vector<std::string>{"1.png", "2.png", "6.png", "7.png"});
}

TEST_CASE("more pictures than a plan may have are refused before any is planned", "[app][sequence]") {
  Lichtraum const lichtraum;
  std::string scene = "define camera eye 60 32 24\n";
  for (int i = 0; i < 11; ++i) scene += "render eye x.png\n";
  lichtraum.folder.write("a.sdf", scene);
  for (std::string const command : {"render --device reference ", "check --device reference "}) {
    INFO(command);
    auto const result = lichtraum(command + "a.sdf -o %d.png --turntable 100000");
    CHECK(result.exit_code == 64);
    CHECK_THAT(result.err, contains_text("at most 1000000 pictures"));
  }
}

TEST_CASE("what is moved between the renders of a file moves, also about shared parts", "[app][sequence]") {
  Lichtraum const lichtraum;
  std::string const start =
      "define material m 1 1 1 0 0 0 0 0 0 1\ndefine light ambient sky 1 1 1\ndefine camera eye 60 32 24\n"
      "define shape sphere a 0 0 -6 0.5 m\ndefine shape box b 0 1 -7 1 2 -6 m\n"
      "define shape composite pair a b\ndefine shape composite left pair\ndefine shape composite right pair\n"
      "transform left translate -1 0 0\n";
  std::vector<std::string> const moves{"", "transform right translate 1 0 0\n", "transform a translate 0 -0.5 0\n",
                                       "transform eye translate 0 0 1\n"};
  std::string all = start;
  for (std::string const& move : moves) all += move + "render eye x.png\n";
  lichtraum.folder.write("all.sdf", all);
  for (std::string const words : {"render --device reference ", "render "}) {
    INFO(words);
    auto const result = lichtraum(words + "all.sdf -o %d.png");
    REQUIRE(result.exit_code == 0);
    std::string alone = start;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      alone += moves[i];
      lichtraum.folder.write("alone.sdf", alone);
      REQUIRE(lichtraum(words + "alone.sdf -o alone.png").exit_code == 0);
      CHECK(lichtraum.folder.read(std::to_string(i + 1) + ".png") == lichtraum.folder.read("alone.png"));
      if (i > 0)
        CHECK(values(lichtraum, std::to_string(i + 1) + ".png") != values(lichtraum, std::to_string(i) + ".png"));
    }
  }
}

TEST_CASE("frames of a model's animation are its poses", "[app][sequence][gltf]") {
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer = moving_square();
  // A light of its own: those that a model is given stand around the whole animation.
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
  writer.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  lichtraum.folder.write("model.glb", writer.glb());
  auto const result = lichtraum.render("model.glb --frames 2..4 --fps 4 --size 16x16 --json -q");
  REQUIRE(result.exit_code == 0);
  REQUIRE(lichtraum.folder.names() ==
          std::vector<std::string>{"model.glb", "model_0002.png", "model_0003.png", "model_0004.png"});
  Json const pictures = Json::parse(result.out)["scenes"][0]["pictures"];
  REQUIRE(pictures.size() == 3);
  for (int frame : {2, 3, 4}) {
    CHECK(pictures[std::size_t(frame - 2)]["time_seconds"] == frame / 4.0);
    CHECK(pictures[std::size_t(frame - 2)]["trace_ms"] > 0);
    REQUIRE(lichtraum.render("model.glb --size 16x16 -o alone.png --time " + std::to_string(frame / 4.0)).exit_code ==
            0);
    CHECK(lichtraum.folder.read("model_000" + std::to_string(frame) + ".png") == lichtraum.folder.read("alone.png"));
  }
  CHECK(values(lichtraum, "model_0002.png") != values(lichtraum, "model_0004.png"));

  lichtraum.folder.write("a.sdf", ball_scene);
  for (std::string const words :
       {"a.sdf --frames 0..3", "model.glb model.glb --frames 0..3", "model.glb --frames 0..3 --time 1",
        "model.glb --frames 3..0", "model.glb --frames x", "model.glb --fps 0 --frames 1..2", "model.glb --fps 12",
        "model.glb --frames 0..3 --turntable 3", "model.glb --frames 0..3 -o one.png", "model.glb --turntable 0"}) {
    INFO(words);
    CHECK(lichtraum.render(words).exit_code == 64);
  }
}

TEST_CASE("a turntable goes around what is seen", "[app][sequence]") {
  Lichtraum const lichtraum;
  // A ball on a large floor, red as seen from the front, green from behind; a quarter on it is between the lights.
  lichtraum.folder.write("ball.sdf",
                         "define material white 0 0 0 1 1 1 0 0 0 1\n"
                         "define shape sphere ball 3 0 -5 1 white\n"
                         "define shape box floor -100 -9 -100 100 -8 100 white\n"
                         "define light diffuse front 3 0 95 1 0 0\n"
                         "define light diffuse back 3 0 -105 0 1 0\n"
                         "define camera eye 30 33 33\ntransform eye translate 3 0 5\n");
  REQUIRE(lichtraum.render("ball.sdf --turntable 4").exit_code == 0);
  REQUIRE(lichtraum.folder.names().size() == 5);
  REQUIRE(lichtraum.render("ball.sdf -o front.png").exit_code == 0);
  CHECK(values(lichtraum, "ball_0001.png") == values(lichtraum, "front.png"));
  auto const color = [&](std::string const& name, int x) {
    auto const image = decode(lichtraum.folder.read(name));
    return std::pair(image.at(x, 16, 0) > 100, image.at(x, 16, 1) > 100);
  };
  CHECK(color("ball_0001.png", 16) == std::pair(true, false));
  CHECK(color("ball_0003.png", 16) == std::pair(false, true));
  // Counterclockwise from above: after a quarter the camera is at +x, and the front is to the left.
  CHECK(color("ball_0002.png", 12) == std::pair(true, false));
  CHECK(color("ball_0002.png", 20) == std::pair(false, true));
  CHECK(color("ball_0004.png", 12) == std::pair(false, true));
}

TEST_CASE("resume leaves what is there and draws what has changed", "[app][sequence][resume]") {
  Lichtraum const lichtraum;
  auto writer = moving_square();
  lichtraum.folder.write("square.glb", writer.glb());
  auto const scene = [](std::string const& more) {
    return "define light ambient all 1 1 1\ndefine camera eye 60 24 16\ndefine shape mesh model square.glb\n"
           "transform model translate 0 0 -6\n" +
           more;
  };
  lichtraum.folder.write("a.sdf", scene("render eye x.png\ntransform model translate 1 0 0\nrender eye y.png\n"));
  lichtraum.folder.write("b.sdf", scene("render eye x.png\n"));
  auto const resume = [&](std::string const& words) {
    auto const result = lichtraum.render("a.sdf b.sdf --resume --json -q -o %d.png " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return drawn(Json::parse(result.out));
  };
  CHECK(resume("") == 3);
  CHECK(resume("") == 0);
  std::filesystem::remove(lichtraum.folder / "2.png");
  CHECK(resume("") == 1);
  // A picture that was cut off, and one that is not what its name says.
  std::string const whole = lichtraum.folder.read("1.png");
  lichtraum.folder.write("1.png", whole.substr(0, whole.size() - 1));
  lichtraum.folder.write("3.png", lichtraum.folder.read("2.png"));
  CHECK(resume("") == 2);
  CHECK(lichtraum.folder.read("1.png") == whole);
  // One with a pixel that is not as it was written: before the last chunk's twelve bytes and a checksum.
  std::string damaged = whole;
  damaged[damaged.size() - 20] ^= 1;
  lichtraum.folder.write("1.png", damaged);
  CHECK(resume("") == 1);
  CHECK(lichtraum.folder.read("1.png") == whole);
  // Settings.
  for (std::string const words :
       {"--size 23x16", "--samples 2x2", "--depth 2", "--bits 16", "--transfer srgb", "--integrator path",
        "--integrator path --ground", "--integrator path --ground=glossy"}) {
    INFO(words);
    CHECK(resume(words) == 3);
    CHECK(resume(words) == 0);
  }
  CHECK(resume("") == 3);
  // The scene: a comment changes nothing, a light does.
  lichtraum.folder.write("b.sdf", scene("render eye x.png\n# a comment\n"));
  CHECK(resume("") == 0);
  lichtraum.folder.write("b.sdf", scene("define light diffuse sun 0 9 0 1 0 0\nrender eye x.png\n"));
  CHECK(resume("") == 1);
  // The model that both scenes include.
  writer.json["nodes"][0]["scale"] = {1, 0.5, 1};
  lichtraum.folder.write("square.glb", writer.glb());
  CHECK(resume("") == 3);
  // OpenEXR too; formats without room for it are drawn, and that is said.
  lichtraum.render("b.sdf -o e.exr -q");
  CHECK_THAT(lichtraum.render("b.sdf --resume -o e.exr").err, contains_text("1 picture was already there"));
  std::string const exr = lichtraum.folder.read("e.exr");
  lichtraum.folder.write("e.exr", exr.substr(0, exr.size() - 8));
  CHECK_THAT(lichtraum.render("b.sdf --resume -o e.exr").err, !contains_text("already there"));
  CHECK_THAT(lichtraum.render("b.sdf --resume -o e.ppm").err, contains_text("--resume has no effect on 'e.ppm'"));
}

TEST_CASE("an interrupted sequence is resumed", "[app][sequence][resume]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.sdf", scene_with_ball_at(0));
  std::string const words = "render --device reference ball.sdf --turntable 400 --samples 12x12 --json -q";
  Process process = lichtraum.process(words);
  process.signals = {{.number = SIGINT, .after_cpu_seconds = 2}};
  auto const first = run_process(process);
  REQUIRE(first.exit_code == 130);
  std::size_t whole = 0;
  for (std::string const& name : lichtraum.folder.names()) {
    if (name.find(".png") != std::string::npos && name.find("partial") == std::string::npos) ++whole;
    CHECK(name.find(".tmp") == std::string::npos);
  }
  // What is left of an interrupted picture goes when it is whole, and nothing else of such a name.
  lichtraum.folder.write("ball_0399.partial.png", "the beginning of a picture");
  REQUIRE(lichtraum.render("ball.sdf -o ball_0398.partial.png").exit_code == 0);
  REQUIRE(whole > 0);
  REQUIRE(whole < 400);
  int const before = drawn(Json::parse(first.out));
  auto const second = lichtraum(words + " --resume --turntable 400");
  REQUIRE(second.exit_code == 0);
  CHECK(drawn(Json::parse(second.out)) == 400 - int(whole));
  CHECK((before == int(whole) || before == int(whole) + 1));  // the one interrupted is in the report
  CHECK(values(lichtraum, "ball_0400.png").size() == 32 * 24 * 3);
  std::vector<std::string> beside;
  for (std::string const& name : lichtraum.folder.names()) {
    if (name.find("partial") != std::string::npos) beside.push_back(name);
  }
  CHECK(beside == std::vector<std::string>{"ball_0398.partial.png", "ball_0399.partial.png"});
}

TEST_CASE("a picture that cannot be written keeps no other scene from being drawn", "[app][sequence]") {
  Lichtraum const lichtraum;
  std::string const scene = scene_with_ball_at(0);
  lichtraum.folder.write("a.sdf",
                         scene + "render eye a1.png 16 12\nrender eye a2.png 16 12\nrender eye a3.png 16 12\n");
  lichtraum.folder.write("b.sdf", scene + "render eye b.png 17 12\n");
  lichtraum.folder.write("c.sdf", scene + "render eye c.png 18 12\n");
  std::filesystem::create_symlink("/dev/full", lichtraum.folder / "a1.png");
  auto const result = lichtraum.render("a.sdf b.sdf c.sdf --allow-path /dev --json");
  CHECK(result.exit_code == 74);
  CHECK_THAT(result.err, contains_text("1 of 3 scenes could not be drawn"));
  Json const scenes = Json::parse(result.out)["scenes"];
  CHECK(scenes[0]["exit_status"] == 74);
  for (auto const& [number, name, width] : {std::tuple(1, "b.png", 17), std::tuple(2, "c.png", 18)}) {
    CHECK(scenes[std::size_t(number)]["exit_status"] == 0);
    REQUIRE(scenes[std::size_t(number)]["pictures"].size() == 1);
    CHECK(scenes[std::size_t(number)]["pictures"][0]["output"] == name);
    CHECK(values(lichtraum, name).size() == std::size_t(width) * 12 * 3);
  }
}

TEST_CASE("the two programs that write an animation write the same good scene", "[app][sequence][docs]") {
  Lichtraum const lichtraum;
  Process process;
  process.arguments = {LICHTRAUM_MAKE_ANIMATION, "5"};
  std::string const text = run_process(process).out;
  process.arguments = {"python3", project_path("tools/make_animation.py"), "5"};
  CHECK(run_process(process).out == text);
  CHECK(lichtraum("check --strict -", text).out.rfind("-: good\n", 0) == 0);
  auto const result = lichtraum.render("- --size 32x18 -o %d.png", text);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(values(lichtraum, "1.png") != values(lichtraum, "2.png"));
  CHECK(values(lichtraum, "4.png") != values(lichtraum, "5.png"));
}

TEST_CASE("frames that are drawn one by one are numbered as those drawn together", "[app][sequence][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("m.gltf", moving_square().text());
  std::string const options = "m.gltf -q --device reference --integrator whitted --size 16x16 --samples 1 ";
  REQUIRE(lichtraum.render(options + "--fps 1 --frames 1..1").exit_code == 0);
  std::filesystem::create_directory(lichtraum.folder / "turned");
  REQUIRE(lichtraum.render(options + "--turntable 1 --output-dir turned").exit_code == 0);
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"m.gltf", "m_0001.png", "turned"});
  CHECK(std::filesystem::exists(lichtraum.folder / "turned/m_0001.png"));
}
