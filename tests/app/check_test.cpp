#include <regex>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"

namespace {

std::string const start =
    "define material m 1 1 1 0 0 0 0 0 0 1\ndefine light ambient sky 1 1 1\ndefine camera eye 40\n";
std::string const ball = "define shape sphere s 0 0 -5 1 m\n";

/// What `render` says beside what it has drawn, and by what means.
std::string findings(std::string const& text) {
  return std::regex_replace(text, std::regex("[^\n]*(Mrays/s|noise is filtered)[^\n]*\n"), "");
}

/// What `check` says that `render` would write.
std::vector<std::string> predicted(std::string const& out) {
  std::vector<std::string> names;
  std::regex const line("\n  would write ([^,]*), 64x48, camera 'eye'");
  for (std::sregex_iterator it(out.begin(), out.end(), line), end; it != end; ++it) names.push_back((*it)[1]);
  return names;
}

}  // namespace

TEST_CASE("check predicts render: what is written, what is said, and the exit status", "[app][check]") {
  struct Case {
    std::string text;
    int exit_code;
    std::string message;
    std::vector<std::string> pictures;
  };
  std::string const two = "render eye one.png 64 48\nrender eye two.exr 64 48\n";
  for (Case const& c : std::vector<Case>{
           {start + ball + "render eye out.png 64 48\n", 0, "", {"out.png"}},
           {start + ball + two, 0, "", {"one.png", "two.exr"}},
           {start + ball + "render eye out.gif 64 48\n", 0, "'out.gif' names no picture format", {"out.gif.png"}},
           {start + ball + "render eye out 64 48\n", 0, "'out' names no picture format", {"out.png"}},
           {start + ball + "render eye a.png 64 48\nrender eye a.png 64 48\n",
            0,
            "several pictures",
            {"a.png", "a.png"}},
           {start + ball + "render eye ../out.png 64 48\n", 65, "it contains '..'", {}},
           {start + ball + "render eye /tmp/out.png 64 48\n", 65, "it is an absolute path", {}},
           {start + ball + two + "render eye ../out.png 64 48\n", 65, "it contains '..'", {}},
           {start + ball + "render eye out.png 100000 100000\n", 65, "needs 240 GB of memory", {}},
           {start + ball + "render eye out.jpg 70000 1\n", 64, "at most 65500 pixels per side", {}},
           {start + ball + "render eye nowhere/out.png 64 48\n", 73, "mkdir -p makes it", {}},
           {start + ball + "render eye folder/ 64 48\n", 0, "", {}},
           {start + ball + "render ey out.png 64 48\n", 0, "", {}},
           {ball, 65, "", {}},
           {"define material m 1 1 1 0 0 0 0 0 0 1\n" + ball, 65, "there is no camera", {}},
           {start + "define shape sphere s 0 0 5 1 m\nrender eye out.png 64 48\n", 0, "behind the camera", {"out.png"}},
           {start + "define shape sphere s 0 0 -5 1 m\ntransform s translate 9 0 0\nrender eye out.png 64 48\n",
            0,
            "to the right of where the camera looks",
            {"out.png"}},
           // In 64 pixels it would fall between their middles.
           {start + "define shape sphere s 0.005 0.005 -5 0.002 m\nrender eye out.png 1201 901\n", 0, "", {}},
           {start + "render eye out.png 64 48\n", 0, "draws no shapes", {"out.png"}},
           {start + "define nonsense\n", 65, "unknown kind", {}},
       }) {
    Lichtraum const lichtraum;
    lichtraum.folder.write("a.sdf", c.text);
    INFO(c.text);
    auto const check = lichtraum("check a.sdf --device reference");
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf"});
    auto const render = lichtraum.render("a.sdf");
    CHECK(check.exit_code == render.exit_code);
    if (c.exit_code != 0) CHECK(check.exit_code == c.exit_code);
    CHECK_THAT(check.err, contains_text(c.message));
    CHECK(check.err == findings(render.err));
    if (!c.pictures.empty()) CHECK(predicted(check.out) == c.pictures);
    for (std::string const& name : predicted(check.out)) {
      auto const names = lichtraum.folder.names();
      CHECK(std::count(names.begin(), names.end(), name) == 1);
    }
  }
}

TEST_CASE("check takes render's options, and says what it would do with them", "[app][check]") {
  struct Case {
    std::string options;
    int exit_code;
    std::vector<std::string> pictures;
  };
  for (Case const& c : std::vector<Case>{
           {"-o left.jpg --size 64x48 --quality 80", 0, {"left.jpg"}},
           {"-o around-%d.ppm --turntable 3 --size 64x48", 0, {"around-1.ppm", "around-2.ppm", "around-3.ppm"}},
           {"-o part.png --size 640x480 --region 0,0,64,48", 0, {"part.png"}},
           {"-o planes.exr --size 64x48 --planes depth,normal", 0, {"planes.exr"}},
           {"-o away.png --size 64x48 --eye 0,0,5 --look-at 0,0,9", 0, {"away.png"}},  // the ball is behind
           {"--output-dir nowhere", 73, {}},
           {"--camera none", 64, {}},
           {"--size 100000x100000", 64, {}},
           {"--size 8x8 --region 0,0,9,9", 64, {}},
           {"--turntable 3 --frames 1..2", 64, {}},
           {"--frames 1..2", 64, {}},
           {"--fps 30", 64, {}},
           {"-o planes.png --planes depth,normal", 64, {}},
           {"a.sdf -o one.png", 64, {}},
       }) {
    Lichtraum const lichtraum;
    lichtraum.folder.write("a.sdf", start + ball + "render eye out.png 64 48\n");
    INFO(c.options);
    auto const check = lichtraum("check a.sdf --device reference --integrator whitted " + c.options);
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf"});
    auto const render = lichtraum.render("a.sdf " + c.options);
    CHECK(check.exit_code == c.exit_code);
    CHECK(render.exit_code == c.exit_code);
    CHECK(std::regex_replace(check.err, std::regex("'check"), "'render") == findings(render.err));
    CHECK(predicted(check.out) == c.pictures);
    CHECK(lichtraum.folder.names().size() == 1 + c.pictures.size());
  }
}

TEST_CASE("check stays short, and goes on after a scene that cannot be drawn", "[app][check]") {
  Lichtraum const lichtraum;
  std::string many = start + ball;
  for (int i = 1; i <= 9; ++i) many += "transform s rotate 1 0 1 0\nrender eye " + std::to_string(i) + ".png 64 48\n";
  lichtraum.folder.write("many.sdf", many);
  lichtraum.folder.write("none.sdf", ball);
  auto const result = lichtraum("check many.sdf none.sdf missing.sdf --device reference");
  CHECK(result.exit_code == 65);
  CHECK(result.out ==
        "many.sdf: good\n"
        "  would write 1.png, 64x48, camera 'eye'\n"
        "  would write 2.png, 64x48, camera 'eye'\n"
        "  would write 3.png, 64x48, camera 'eye'\n"
        "  would write 4.png, 64x48, camera 'eye'\n"
        "  and 5 more pictures, the last is 9.png\n"
        "none.sdf: 1 error, 0 warnings\n"
        "missing.sdf: 1 error, 0 warnings\n");
  CHECK(lichtraum("check missing.sdf none.sdf --device reference").exit_code == 66);
  auto const quiet = lichtraum("check -q many.sdf --device reference");
  CHECK((quiet.exit_code == 0 && quiet.out.empty() && quiet.err.empty()));
  CHECK(lichtraum("check many.sdf --device nonsense").exit_code == 69);
  CHECK(lichtraum("check - - --device reference", many).exit_code == 64);
  CHECK_THAT(lichtraum("check - --device reference", start + ball).out, contains_text("would write stdin.png"));
}

TEST_CASE("check and render say where light is missing", "[app][check]") {
  std::string const camera = "define camera eye 40\nrender eye out.png 64 48\n";
  std::string const white = "define material m 1 1 1 1 1 1 0 0 0 1\n";
  std::string const lamp = "define light diffuse l 0 5 0 1 1 1\n";
  // A material that takes no ambient light, in a room.
  std::string const room = "define material w 0 0 0 1 1 1 0 0 0 1\ndefine shape box room -9 -9 -9 9 9 9 w\n";
  struct Case {
    std::string text;
    std::string words;
    std::string message;
  };
  for (Case const& c : std::vector<Case>{
           {white + ball, "", "nothing gives light: there is no lamp"},
           {white + ball + "define light ambient a 0 0 0\ndefine light diffuse l 0 5 0 0 0 0\n", "", "nothing gives"},
           {white + ball + "define light environment sky 1 1 1\n", "", ""},
           {white + ball + "define light environment sky 1 1 1\n", " --environment-brightness 0",
            "the environment's brightness is 0"},
           {white + ball + "define light ambient a 0 0.01 0\n", "", ""},
           {white + ball + lamp, "", ""},
           {white + ball + "define background 1 1 1\n", "", "nothing gives light"},
           {"define material m 0 0 0 0 0 0 0 0 0 1 emission 1 0 0\n" + ball, "", ""},
           {"define material e 0 0 0 0 0 0 0 0 0 1 emission 1 0 0\n" + white + ball, "", "nothing gives light"},
           {white + ball + "define light diffuse l 0 0 -5 1 1 1\n", "", "no light reaches what the camera 'eye' sees"},
           {room + "define light diffuse l 0 99 0 1 1 1\n", "", "no light reaches"},
           {room + "define light diffuse l 0 0 0 1 1 1\n", "", ""},
           {"define material m 0 0 0 0 0 0 0 0 0 1\n" + ball + lamp, "", "or the materials reflect nothing"},
           {"define material m 0 0 0 0 0 0 0 0 0 1\n" + ball + lamp + "define background 1 1 1\n", "", ""},
       }) {
    Lichtraum const lichtraum;
    lichtraum.folder.write("a.sdf", c.text + camera);
    INFO(c.text);
    auto const check = lichtraum("check a.sdf --device reference" + c.words);
    auto const render = lichtraum.render("a.sdf" + c.words);
    CHECK((check.exit_code == 0 && render.exit_code == 0));
    CHECK(check.err == findings(render.err));
    CHECK(check.err.empty() == c.message.empty());
    CHECK_THAT(check.err, contains_text(c.message));
  }
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", white + ball + camera);
  CHECK_THAT(lichtraum.render("a.sdf --planes depth -o depth.exr").err, !contains_text("light"));
  lichtraum.folder.write("a.sdf", white + ball + "define light environment sky 1 1 1\n" + camera);
  CHECK_THAT(lichtraum.render("a.sdf --integrator whitted").err, contains_text("--integrator path does"));
  lichtraum::testing::GltfWriter model;
  model.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0});
  lichtraum.folder.write("a.glb", model.glb());
  CHECK_THAT(lichtraum.render("a.glb --size 8x8 --integrator path --environment-brightness 0").err,
             contains_text("brightness is 0 [W0814]\n  hint: --environment-brightness 1"));
  model.json["materials"] = {{{"emissiveFactor", {1, 1, 1}}}};  // of no mesh
  lichtraum.folder.write("a.glb", model.glb());
  CHECK_THAT(lichtraum.render("a.glb --size 8x8 --integrator path --environment none").err,
             contains_text("nothing gives light: there is no lamp") && contains_text("hint: --integrator path --envi"));
  // One pixel is lit, which few rays do not find.
  lichtraum.folder.write("a.sdf", room +
                                      "define light diffuse l 0 99 0 1 1 1\ndefine material b 1 1 1 0 0 0 0 0 0 1\n" +
                                      "define shape sphere s 0.0002 0.0002 -5 0.002 b\ndefine light ambient a 1 1 1\n" +
                                      "define camera eye 40\nrender eye out.png 1201 901\n");
  CHECK(lichtraum("check a.sdf --device reference").err.empty());
}

TEST_CASE("a picture that is black behind too much glass is told which depth may show it", "[app][check]") {
  Lichtraum const lichtraum;
  std::string const wall =
      "define material m 0 0 0 0 0 0 0 0 0 1 transmit=1\ndefine material w .8 .8 .8 .8 .8 .8 0 0 0 1\n"
      "define shape box b -9 -9 -9 9 9 -8 w\n";
  std::string const view = "define camera e 20 64 48\nrender e o.png\n";
  lichtraum.folder.write("panes.sdf", wall +
                                          "define shape box p0 -9 -9 -3.0 9 9 -2.9 m\n"
                                          "define shape box p1 -9 -9 -3.5 9 9 -3.4 m\n"
                                          "define shape box p2 -9 -9 -4.0 9 9 -3.9 m\n"
                                          "define shape box p3 -9 -9 -4.5 9 9 -4.4 m\n"
                                          "define light diffuse l 0 3 -6 1 1 1\n" +
                                          view);
  auto const check = [&](std::string const& words) { return lichtraum("check --device reference " + words).err; };
  std::string const said = check("panes.sdf");
  CHECK_THAT(said, contains_text("no light reaches what the camera 'e' sees [W0815]") &&
                       contains_text("or light is behind more glass or mirrors than rays were followed through, 5: "
                                     "try --depth 20\n"));
  CHECK(findings(lichtraum.render("panes.sdf").err) == said);
  CHECK_THAT(check("panes.sdf --depth 7"), contains_text("followed through, 7: try --depth 28\n"));
  CHECK_THAT(check("panes.sdf --depth 0"), contains_text("followed through, 0: try --depth 20\n"));
  CHECK(check("panes.sdf --depth 20").empty());
  // The lamp is inside the wall, and no ray is mirrored or refracted: no depth would help.
  lichtraum.folder.write("wall.sdf", wall + "define light diffuse l 0 0 -8.5 1 1 1\n" + view);
  CHECK_THAT(check("wall.sdf"), contains_text("[W0815]") && !contains_text("--depth"));
}

TEST_CASE("a camera without a name is called none", "[app][check]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", "define material m 0 0 0 0 0 0 0 0 0 1\ndefine light diffuse l 9 9 9 1 1 1\n" + ball);
  auto const result = lichtraum("check a.sdf --device reference --size 64x48 --orbit 35,20");
  CHECK_THAT(result.err, contains_text("no light reaches what the camera sees [W0815]"));
  CHECK_THAT(result.out, contains_text("would write a.png, 64x48\n"));
}

TEST_CASE("a picture lacks what is defined below its render", "[app][check]") {
  Lichtraum const lichtraum;
  std::string const white = "define material m 1 1 1 1 1 1 0 0 0 1\n";
  std::string const lamp = "define light diffuse lamp 0 5 0 1 1 1\n";
  std::string const render = "define camera eye 40\nrender eye out.png 64 48\n";
  auto const check = [&](std::string const& text) {
    lichtraum.folder.write("a.sdf", text);
    return lichtraum("check a.sdf --device reference").err;
  };
  CHECK_THAT(check(white + lamp + render + ball),
             contains_text("a.sdf:4:") && contains_text("sees nothing") &&
                 contains_text("hint: the shape 's' is defined below this render: statements run in order"));
  CHECK_THAT(check(white + ball + render + lamp),
             contains_text("a.sdf:4:") && contains_text("nothing gives light") &&
                 contains_text("hint: the light 'lamp' is defined below this render: statements run in order"));
  CHECK_THAT(check(white + ball + render + "define light environment sky 1 1 1\n"),
             contains_text("hint: the light 'sky' is defined below this render"));
  CHECK_THAT(check(white + ball + "define light diffuse dark 0 0 -5 1 1 1\n" + render + lamp),
             contains_text("a.sdf:5:") && contains_text("the picture is black") &&
                 contains_text("hint: the light 'lamp' is defined below this render"));
}

TEST_CASE("a shape that is too large for the device is called so", "[app][check]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", start + "define shape sphere s 0 0 -1e37 1e36 m\nrender eye out.png 64 48\n");
  for (char const* const command : {"check", "render"}) {
    auto const result = lichtraum(std::string(command) + " a.sdf");
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, contains_text("a.sdf: warning: 1 shape is left out: too large for the device"));
    CHECK_THAT(result.err, !contains_text("too small to be"));
  }
}
