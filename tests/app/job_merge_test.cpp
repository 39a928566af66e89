/// What `job merge` puts together of units that are there.

#include <signal.h>

#include "farm.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/skip.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("all planes are put together", "[app][job]") {
  Farm const farm;
  std::string const options =
      "ball.sdf -q --samples 20 --planes radiance,alpha,depth,normal,albedo,position,object,instance,material";
  REQUIRE(farm.render(options + " -o one.exr").exit_code == 0);
  REQUIRE(farm.plan(options + " --tile 13x24 --samples-per-unit 16").exit_code == 0);
  REQUIRE(farm.work("-q").exit_code == 0);
  REQUIRE(farm.merge("-q -o many.exr").exit_code == 0);
  CHECK(farm.folder.read("many.exr") == farm.folder.read("one.exr"));
  auto const refused = farm.merge("-o many.png");
  CHECK(refused.exit_code == 64);
  CHECK_THAT(refused.err, contains_text("has room for one"));
  auto const no_film = farm.merge("-o many.exr --fps 30");
  CHECK(no_film.exit_code == 64);
  CHECK_THAT(no_film.err, contains_text("--fps is for films"));
  CHECK_THAT(farm.merge("-o many.gif --fps 60").err, contains_text("at most 50 pictures a second"));
  CHECK(farm.merge("-o many.exr").err == "many.exr: 32x24\n");  // it was traced elsewhere
}

TEST_CASE("a device puts together what it draws as one", "[app][job]") {
  Farm const farm;
  std::string const options = "lamp.sdf -q --samples 24";
  auto const one = farm("render " + options + " -o one.png");
  REQUIRE(one.exit_code == 0);
  REQUIRE(farm("job plan -o shared " + options + " --tile 16x16 --samples-per-unit 16").exit_code == 0);
  REQUIRE(farm("job work shared -q").exit_code == 0);
  REQUIRE(farm.merge("-q -o many.png").exit_code == 0);
  CHECK(farm.folder.read("many.png") == farm.folder.read("one.png"));
}

TEST_CASE("a sequence is planned, drawn and put together", "[app][job]") {
  Farm const farm;
  farm.folder.write("moving.sdf",
                    std::string(ball_scene) + "transform ball translate 0.5 0 0\nrender eye b.ppm 32 24\n");
  std::string const scenes = "ball.sdf moving.sdf -q --turntable 2 --size 20x10";
  REQUIRE(farm.render(scenes + " -o one-%d.png").exit_code == 0);
  REQUIRE(farm.plan(scenes + " --tile 16x16").exit_code == 0);
  CHECK(farm.status()["pictures"] == 6);
  CHECK(farm.work("--units 3..8 -q").exit_code == 0);
  CHECK(farm.status()["missing"] == Json::parse("[[0, 2], [9, 11]]"));
  CHECK(farm.merge("-o many-%d.png").exit_code == 75);
  CHECK(farm.work("-q").exit_code == 0);
  REQUIRE(farm.merge("-q -o many-%d.png").exit_code == 0);
  for (int i = 1; i <= 6; ++i) {
    CHECK(farm.folder.read("many-" + std::to_string(i) + ".png") ==
          farm.folder.read("one-" + std::to_string(i) + ".png"));
  }
  CHECK(farm.folder.read("many-1.png") != farm.folder.read("many-2.png"));

  // All units are looked at before any picture is written.
  fs::path const fifth = farm.unit(5);
  for (fs::path const& unit : {fifth, farm.unit(10)}) fs::resize_file(unit, 100);
  auto const spoilt = farm.merge("-q -o again-%d.png");
  CHECK(spoilt.exit_code == 75);
  CHECK_THAT(spoilt.err, contains_text("unit 5 has 100 bytes") && contains_text("unit 10 has 100 bytes"));
  CHECK(!fs::exists(farm.folder / "again-1.png"));
  fs::create_directory(fifth);  // in the way of what is drawn again
  CHECK(farm.work("-q").exit_code == 0);
  CHECK(farm.merge("-q -o again-%d.png").exit_code == 0);
  CHECK(farm.folder.read("again-6.png") == farm.folder.read("one-6.png"));
  CHECK(farm.folder.read("many-3.png") != farm.folder.read("many-5.png"));
}

TEST_CASE("frames of a model's animation are put together, and become the film that render makes", "[app][job][film]") {
  Farm const farm;
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0});
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const places = writer.add_vec3({0, 0, 0, 2, 0, 0});
  writer.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 6}}});
  writer.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  writer.json["scenes"] = {{{"nodes", {0, 1}}}};
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  farm.folder.write("model.glb", writer.glb());
  std::string const options = "model.glb -q --frames 3..6 --fps 4 --size 32x24 --samples 4 --denoise builtin";
  REQUIRE(farm.render(options + " -o one-%d.png").exit_code == 0);
  REQUIRE(farm.plan(options + " --tile 16x16").exit_code == 0);
  CHECK(farm.status()["pictures"] == 4);
  REQUIRE(farm.work("-q").exit_code == 0);
  REQUIRE(farm.merge("-q -o many-%d.png").exit_code == 0);
  for (int frame = 3; frame <= 6; ++frame) {
    std::string const number = std::to_string(frame);
    CHECK(farm.folder.read("many-" + number + ".png") == farm.folder.read("one-" + number + ".png"));
  }
  CHECK(farm.folder.read("many-3.png") != farm.folder.read("many-4.png"));
  if (!is_installed("ffmpeg")) SKIP_TEST("ffmpeg is not installed");
  for (std::string const extension : {"gif", "mp4"}) {
    REQUIRE(farm.render(options + " -o one." + extension).exit_code == 0);
    REQUIRE(farm.merge("-q -o many." + extension).exit_code == 0);
    CHECK(farm.folder.read("many." + extension) == farm.folder.read("one." + extension));
  }
}

TEST_CASE("a picture in which nothing is seen is put together, too", "[app][job]") {
  Farm const farm;
  farm.folder.write("empty.sdf",
                    "define material red 1 0 0 1 0 0 0 0 0 1\n"
                    "define shape sphere lone 0 0 9 1 red\n"
                    "define camera eye 60\n");
  REQUIRE(farm.plan("empty.sdf --size 20x20 --planes depth --turntable 3 --eye 0,0,-50 --look-at 0,0,-60").exit_code ==
          0);
  REQUIRE(farm.work("-q").exit_code == 0);
  REQUIRE(
      farm.render("empty.sdf -q --size 20x20 --planes depth --turntable 3 --eye 0,0,-50 --look-at 0,0,-60 -o one%d.exr")
          .exit_code == 0);
  auto const merged = farm.merge("-o many%d.exr");
  INFO(merged.err);
  REQUIRE(merged.exit_code == 0);
  CHECK_THAT(merged.err, contains_text("sees nothing"));
  for (std::string const n : {"1", "2", "3"})
    CHECK(farm.folder.read("many" + n + ".exr") == farm.folder.read("one" + n + ".exr"));
}

TEST_CASE("large pictures are drawn and put together in bands, to the same bytes", "[app][job][long]") {
  Farm const farm;
  // More than 2^24 pixels, and an odd number of rows. Nobody can go back in a pipe, so what goes there is drawn at
  // once.
  std::string const what = "ball.sdf --size 4999x3361 --samples 1 ";
  for (std::string const format : {"png", "exr"}) {
    INFO(format);
    REQUIRE(farm.render(what + "-q -o bands." + format).exit_code == 0);
    auto const whole = farm.render(what + "-q -o - --format " + format);
    REQUIRE(whole.exit_code == 0);
    CHECK((farm.folder.read("bands." + format) == whole.out));  // in brackets: nobody wants to see them
  }
  REQUIRE(farm.plan(what).exit_code == 0);
  REQUIRE(farm.work("-q").exit_code == 0);
  for (std::string const format : {"png", "exr"}) {
    INFO(format);
    REQUIRE(farm.merge("-q -o merged." + format).exit_code == 0);
    CHECK((farm.folder.read("merged." + format) == farm.folder.read("bands." + format)));
  }
  fs::resize_file(farm.unit(7), 100);
  auto const spoilt = farm.merge("-q -o spoilt.png");
  CHECK(spoilt.exit_code == 75);
  CHECK(spoilt.err.find("unit 7 has 100 bytes instead of") != std::string::npos);
  CHECK(!fs::exists(farm.folder / "spoilt.png"));
}

TEST_CASE("a large picture that is interrupted leaves nothing", "[app][job]") {
  Farm const farm;
  auto const before = farm.folder.names();
  Process drawing = farm.process("render ball.sdf -o large.png --size 60000x60000 --device reference");
  drawing.signals = {{.number = SIGINT, .after_cpu_seconds = 1.5}};
  auto const end = run_process(drawing);
  CHECK(end.exit_code == 130);
  CHECK(end.err.find("nothing was written") != std::string::npos);
  CHECK(farm.folder.names() == before);
}

TEST_CASE("units that are missing are told as ranges, the first five", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf --tile 8x8").exit_code == 0);  // 12
  auto const missing = [&] { return farm("job status shared").out; };
  for (char const* const unit : {"1..1", "3..3", "5..5", "7..7"}) {
    REQUIRE(farm.work(std::string("-q --units ") + unit).exit_code == 0);
  }
  CHECK_THAT(missing(), contains_text("missing: 0, 2, 4, 6, 8..11\n"));
  REQUIRE(farm.work("-q --units 9..9").exit_code == 0);
  CHECK_THAT(missing(), contains_text("missing: 0, 2, 4, 6, 8, ...\n"));
}

TEST_CASE("a plan is put together by the version that made it", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf").exit_code == 0);
  std::string const name = "shared/plan.json";
  std::string plan = farm.folder.read(name);
  std::string const version = Json::parse(plan)["lichtraum"];
  plan.replace(plan.find(version), version.size(), "0.0.1");
  put(farm.folder / name, plan);
  REQUIRE(farm.work("-q").exit_code == 0);
  auto const refused = farm.merge("-o a.png");
  CHECK(refused.exit_code == 65);
  CHECK_THAT(refused.err, contains_text("made by lichtraum 0.0.1, and this is " + version));
  CHECK(farm.merge("-q -o a.png --allow-mixed").exit_code == 0);
}
