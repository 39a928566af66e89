#include <algorithm>
#include <cstring>
#include <vector>

#include "lichtraum.hpp"
#include "support/catch.hpp"

// What an environment does to pictures is for the tests of integrators; here, that it gets to the scene.

TEST_CASE("a picture with another environment is another picture for --resume", "[app][environment]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("sky.hdr", "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x40\x40\x40\x80");
  std::string const draw = "a.sdf -o a.png --resume ";
  auto const is_there_already = [&](std::string const& options) {
    auto const result = lichtraum.render(draw + options);
    CHECK(result.exit_code == 0);
    return result.err.find("already there") != std::string::npos;
  };
  CHECK(!is_there_already(""));
  CHECK(is_there_already(""));
  CHECK(is_there_already("--environment none"));
  CHECK(is_there_already("--environment-rotation 90"));  // there is nothing to turn
  CHECK(!is_there_already("--environment studio"));
  CHECK(is_there_already("--environment studio"));
  CHECK(!is_there_already("--environment studio --environment-rotation 90"));
  CHECK(!is_there_already("--environment studio --environment-brightness 0.5"));
  CHECK(!is_there_already("--environment sky.hdr"));
  CHECK(is_there_already("--environment ./sky.hdr"));  // the light counts, not its name
}

TEST_CASE("without an environment a model is lit by what shines in it, or by lamps that are made up",
          "[app][environment]") {
  Lichtraum const lichtraum;
  auto const brightest = [&](std::string const& emission) {
    lichtraum.folder.write("lit.obj",
                           "mtllib lit.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 9 9.001 9\nv 9 9 9.001\n"
                           "usemtl wall\nf 1 2 3\nusemtl lamp\nf 4 5 6\n");
    lichtraum.folder.write("lit.mtl", "newmtl wall\nKd 0.8 0.8 0.8\nnewmtl lamp\nKd 0 0 0\nKe " + emission + "\n");
    auto const result = lichtraum(
        "render lit.obj --environment none --background 0,0,0 --denoise off --samples 16 "
        "--size 32x24 --eye 0.3,0.3,2 --look-at 0.3,0.3,0 -o lit.pfm");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    std::string const bytes = lichtraum.folder.read("lit.pfm");
    std::vector<float> values(32 * 24 * 3);
    std::memcpy(values.data(), bytes.data() + bytes.size() - 4 * values.size(), 4 * values.size());
    return *std::max_element(values.begin(), values.end());
  };
  CHECK(brightest("0 0 0") > 0.1f);
  CHECK(brightest("0.1 0.1 0.1") < 0.01f);
  CHECK(brightest("1e9 1e9 1e9") > 0.1f);
}

TEST_CASE("every picture of a scene that moves has the environment", "[app][environment]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", std::string(ball_scene) + "transform ball translate 1 0 0\nrender eye b.png 32 24\n");
  std::string const draw = "a.sdf --format png -o %d.png --resume ";
  CHECK(lichtraum.render(draw).exit_code == 0);
  CHECK_THAT(lichtraum.render(draw).err, contains_text("2 pictures were already there"));
  CHECK(lichtraum.render(draw + "--environment studio").err.find("already there") == std::string::npos);
  CHECK_THAT(lichtraum.render(draw + "--environment studio").err, contains_text("2 pictures were already there"));
}

TEST_CASE("an environment with a few values that are no light is drawn, and they are told", "[app][environment]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  std::vector<float> values(3 * 20 * 10, 1);
  values[100] = -0.25f;
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  lichtraum.folder.write("sky.pfm", "PF\n20 10\n-1.0\n" + bytes);
  std::string const words = "a.sdf --size 16x12 --samples 1 --integrator path --environment sky.pfm ";
  for (std::string const command : {"check ", "render -o a.png --device reference "}) {
    auto const result = lichtraum(command + words);
    INFO(result.out + result.err);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out + result.err,
               contains_text("sky.pfm: 1 of its 600 values cannot be light") && contains_text("[W0825]"));
  }
}
