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

TEST_CASE("every picture of a scene that moves has the environment", "[app][environment]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", std::string(ball_scene) + "transform ball translate 1 0 0\nrender eye b.png 32 24\n");
  std::string const draw = "a.sdf --format png -o %d.png --resume ";
  CHECK(lichtraum.render(draw).exit_code == 0);
  CHECK_THAT(lichtraum.render(draw).err, contains_text("2 pictures were already there"));
  CHECK(lichtraum.render(draw + "--environment studio").err.find("already there") == std::string::npos);
  CHECK_THAT(lichtraum.render(draw + "--environment studio").err, contains_text("2 pictures were already there"));
}
