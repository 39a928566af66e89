#include "lichtraum.hpp"
#include "support/catch.hpp"

namespace {

std::string const ball =
    "define material m 1 1 1 1 1 1 0 0 0 1\ndefine shape sphere s 0 0 -5 1 m\ndefine light ambient sky 2 2 2\n";
std::string const view = "define camera eye 40\nrender eye a.png 64 48\n";
std::string const bright_sky = "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x83\x80\x80\x80\x83";  // radiance 4

}  // namespace

TEST_CASE("a picture that is mostly white is told, with what darkens it", "[app][white]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball + view);
  auto const said = [&](std::string const& words) {
    auto const result = lichtraum.render("a.sdf " + words);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(said(""), contains_text("a.sdf:5:12: warning: the picture is too bright: 100 % of what it shows is pure "
                                     "white [W0823]\n") &&
                           contains_text("hint: --exposure -2 darkens it, and --tonemap neutral shows what is"));
  CHECK_THAT(said("--exposure 1"), contains_text("hint: --exposure -1 darkens it"));
  CHECK_THAT(said("--exposure 12 --tonemap reinhard"),
             contains_text("W0823") && contains_text("--exposure 10 darkens it\n"));
  for (std::string const darker :
       {"--exposure -1", "--tonemap neutral", "-o a.exr", "-o a.pfm", "--region 30,20,9,9"}) {
    INFO(darker);
    CHECK_THAT(said(darker), !contains_text("W0823"));
  }
  CHECK_THAT(said("--planes depth -o a.exr"), !contains_text("W0823"));
  CHECK_THAT(lichtraum("check a.sdf --device reference").err, contains_text("100 % of what it shows is pure white"));
  CHECK_THAT(lichtraum("check a.sdf --device reference -o a.pfm").err, !contains_text("W0823"));
}

TEST_CASE("a model that is next to black is told, with what brightens it", "[app][white]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("m.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  auto const said = [&](std::string const& words) {
    auto const result = lichtraum.render("m.obj --size 32x24 " + words);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(said("--exposure -12"), contains_text("next to no light reaches 100 % of what the camera") &&
                                         contains_text("[W0815]") && contains_text("--exposure -8 brightens it"));
  for (std::string const lighter : {"", "--exposure -4", "--background none", "--background 0,0,0 --ground",
                                    "--exposure -12 -o a.exr", "--exposure -12 --region 1,1,9,9"}) {
    INFO(lighter);
    CHECK_THAT(said(lighter), !contains_text("W0815"));
  }
}

TEST_CASE("white that is meant is not told", "[app][white]") {
  Lichtraum const lichtraum;
  auto const said = [&](std::string const& text, std::string const& words = "") {
    lichtraum.folder.write("a.sdf", text);
    auto const result = lichtraum.render("a.sdf " + words);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  std::string const grey = "define material m 0.2 0.2 0.2 1 1 1 0 0 0 1\ndefine shape sphere s 0 0 -5 1 m\n";
  CHECK_THAT(said(grey + "define light ambient sky 2 2 2\ndefine background 3 3 3\n" + view), !contains_text("W0823"));
  CHECK_THAT(said(ball + "define background 3 3 3\n" + view), contains_text("100 % of what it shows"));
  CHECK_THAT(said(ball + view, "--background 5,5,5"), contains_text("100 % of what it shows"));
  CHECK_THAT(said(ball + view, "--background none"), contains_text("100 % of what it shows"));
  // As bright as white is, and no brighter.
  CHECK_THAT(said(grey + "define light ambient sky 5 5 5\n" + view), !contains_text("W0823"));
  // A point of light.
  CHECK_THAT(said("define material m 1 1 1 0 0 0 0 0 0 1\ndefine shape sphere s 0 0 -5 0.05 m\n"
                  "define light ambient sky 9 9 9\n" +
                  view),
             !contains_text("W0823"));
}

TEST_CASE("an environment that is white is told", "[app][white]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf",
                         "define material m 0 0 0 0.2 0.2 0.2 0 0 0 1\ndefine shape sphere s 0 0 -5 1 m\n" + view);
  lichtraum.folder.write("sky.hdr", bright_sky);
  std::string const words = "a.sdf --environment sky.hdr --tonemap none --samples 16 --denoise off";
  auto const result = lichtraum.render(words);
  CHECK_THAT(result.err, contains_text(" % of what it shows is pure white [W0823]"));
  CHECK_THAT(lichtraum("check --device reference " + words).err, contains_text("[W0823]"));
  CHECK_THAT(lichtraum.render(words + " --background 0,0,0").err, !contains_text("W0823"));
}
