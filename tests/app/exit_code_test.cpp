#include <signal.h>

#include <filesystem>
#include <map>

#include "lichtraum.hpp"
#include "support/catch.hpp"

namespace {

bool is_one_line(std::string const& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

}  // namespace

TEST_CASE("0: all went well", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const result = lichtraum.render("a.sdf");
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, contains_text("ball.ppm: 32x24"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "ball.ppm"});
}

TEST_CASE("64: what makes no sense is refused in one line that says what to do", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("two.sdf", std::string(ball_scene) + "render eye two.ppm 32 24\n");
  auto const refused = [&](std::string const& words, std::string const& message) {
    INFO(words);
    auto const result = lichtraum(words);
    CHECK(result.exit_code == 64);
    CHECK(result.out.empty());
    CHECK(is_one_line(result.err));
    CHECK_THAT(result.err, contains_text(message));
  };
  refused("", "lichtraum --help");
  refused("a.sdf", "lichtraum render a.sdf");
  refused("rendr a.sdf", "did you mean 'lichtraum render'?");
  refused("frobnicate", "lichtraum --help");
  refused("--samples 4", "lichtraum render --help");
  refused("render", "no file is given");
  refused("render a.sdf --sample 4", "did you mean --samples?");
  refused("render a.sdf --xyzzy", "no option '--xyzzy'");
  refused("render a.sdf --size", "--size needs a value");
  refused("render a.sdf --output-dir= --size=32x18", "--output-dir: expected a value, not ''");
  refused("render --allow-path= a.sdf", "--allow-path: expected a value, not ''");
  for (char const* const size : {"0x0", "640", "640x", "x480", "640x480x2", "-1x5", "1e3x5", "99999999999x1", "4,3"}) {
    refused(std::string("render a.sdf --size ") + size, "--size: ");
  }
  refused("render a.sdf --size 1000000x1000000", "needs 24 TB of memory");
  refused("render a.sdf --size 2147483647x2147483647", "memory");
  for (char const* const region : {"0,0,0,5", "1,2,3", "1,2,3,4,5", "-1,0,5,5", "a,0,5,5"}) {
    refused(std::string("render a.sdf --region ") + region, "--region: ");
  }
  refused("render a.sdf --region 30,0,3,5 --device reference", "does not lie in the picture of 32x24");
  refused("render a.sdf --region 2147483647,0,2147483647,5 --device reference", "does not lie in the picture");
  for (char const* const samples : {"0", "4x3", "-4", "1.5", "2000x2000", "many"}) {
    refused(std::string("render a.sdf --samples ") + samples, "--samples: expected a number of samples");
  }
  refused("render a.sdf --depth -1", "from 0 to 1000");
  refused("render a.sdf --seed -1", "--seed: ");
  refused("render a.sdf --transfer sRGB", "expected linear or srgb, not 'sRGB'");
  refused("render a.sdf --environment-rotation north", "expected degrees");
  refused("render a.sdf --environment-brightness -1", "from 0 to 1000000");
  refused("render a.sdf --eye 1,2", "--eye: expected three numbers, X,Y,Z");
  refused("render a.sdf --up 0,nan,0", "--up: expected three numbers");
  refused("render a.sdf --fov-x 180", "--fov-x: expected degrees between 0 and 180");
  refused("render a.sdf --fov-y nan", "--fov-y: expected degrees between 0 and 180");
  refused("render a.sdf --orbit 35", "--orbit: expected azimuth and elevation");
  refused("render a.sdf --orbit 0,91", "--orbit: expected azimuth and elevation");
  refused("render a.sdf --eye -1,2,3 --look-at -1,2,3 --device reference",
          "--look-at -1,2,3 is where the camera stands");
  refused("render a.sdf --eye 0,9,0 --look-at 0,0,0 --device reference", "--up 0,1,0 is parallel");
  refused("render a.sdf --eye 1,2,3 --orbit 0,0 --device reference", "--eye and --orbit cannot be combined");
  refused("render a.sdf --tonemap filmic", "expected auto, neutral, agx, aces, reinhard or none");
  refused("render a.sdf --integrator photons", "expected whitted or path");
  refused("render a.sdf --bits 12", "expected 8 or 16");
  refused("render a.sdf --quality 0", "from 1 to 100");
  refused("render a.sdf --rotation up", "expected right or left");
  refused("render a.sdf --transform-order world", "expected parent or local");
  refused("render a.sdf --material-extras opacity,shine", "not 'opacity,shine'");
  refused("render a.sdf --format gif", "png, ppm, jpg, exr, pfm");
  refused("render a.sdf -o a.bmp", ".png, .ppm, .jpg");
  refused("render a.sdf -o a", "no extension");
  refused("render a.sdf -o .", "--output-dir . writes there");
  refused("render a.sdf -o a.mov", "known ones: .png, .ppm, .jpg, .jpeg, .exr, .pfm; of films: .mp4, .webm, .gif");
  refused("render a.sdf -o a.png --format exr", "contradicts");
  refused("render a.sdf -o a.jpg --bits 16 --device reference", ".png and .ppm have 16");
  refused("render a.sdf -o a.jpg --size 70000x1 --device reference", "at most 65500");
  for (char const* const pattern : {"%s.png", "%4d.png", "%d-%d.png", "%", "100%.png", "%0d", "%012d.png"}) {
    refused(std::string("render a.sdf -o ") + pattern, "%04d");
  }
  refused("render two.sdf -o a.png --device reference", "-o picture-%04d.png");
  refused("render a.sdf two.sdf -o a.png", "-o picture-%04d.png");
  refused("render - - -o -", "more than once");
  refused("render a.sdf --camera nose --device reference", "there are: 0 eye");
  refused("render a.sdf --width 64", "there is no option '--width': did you mean --size?");
  refused("render a.sdf --height=64", "did you mean --size?");
  refused("render a.sdf --spp 4", "did you mean --samples?");
  refused("render a.sdf --out b.png", "did you mean --output?");
  refused("render a.sdf --output-file b.png", "did you mean --output?");
  for (char const* const color :
       {"#12345", "#1234567", "#12345g", "123456", "#123456,1", "1,2,3,#123456,1", "-1,0,0"}) {
    refused(std::string("render a.sdf --background ") + color, "or as '#336699'");
  }
  for (char const* const stops : {"+", "++1", "+-1", "-+1"}) {
    refused(std::string("render a.sdf --exposure ") + stops, "--exposure: ");
  }
  refused("render a.sdf --root nose --device reference",
          "a.sdf: --root: the scene has no shape called 'nose'; there is ball");
  refused("render a.sdf --root bal --device reference", "did you mean 'ball'?");
  refused("render a.sdf --ground glossy", "there is no scene 'glossy': a ground is chosen by --ground=glossy");
  refused("info a.sdf two.sdf", "unexpected argument");
  Process nowhere = lichtraum.process("render a.sdf --allow-path");
  nowhere.arguments.push_back("");
  ProcessResult const result = run_process(nowhere);
  CHECK(result.exit_code == 64);
  CHECK_THAT(result.err, contains_text("--allow-path: expected a name, not ''"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "two.sdf"});
}

TEST_CASE("65: faulty scenes", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("typo.sdf",
                         "define shape sphere s 0 0 -3 1 gold\ndefine camera eye 60\nrender eye a.ppm 4 3\n");
  for (char const* const words : {"render typo.sdf --device reference", "check typo.sdf", "info typo.sdf"}) {
    auto const result = lichtraum(words);
    CHECK(result.exit_code == 65);
    CHECK_THAT(result.err, contains_text("typo.sdf:1:32: error: "));
  }
  lichtraum.folder.write("blind.sdf", "define material m 1 1 1 1 1 1 0 0 0 1\ndefine shape sphere s 0 0 -3 1 m\n");
  auto const blind = lichtraum.render("blind.sdf");
  CHECK(blind.exit_code == 65);
  CHECK_THAT(blind.err, contains_text("define camera eye 45"));
  for (char const* const name : {"/tmp/x.ppm", "../x.ppm", "sub/../../x.ppm"}) {
    auto const result = lichtraum.render("-", std::string("define camera eye 60\nrender eye ") + name + " 4 3\n");
    CHECK(result.exit_code == 65);
    CHECK_THAT(result.err, contains_text(":2:12: error: cannot write '") &&
                               contains_text("hint: pictures go to the folder of --output-dir"));
  }
  auto const huge = lichtraum.render("-", "define camera eye 60\nrender eye a.ppm 1000000 1000000\n");
  CHECK(huge.exit_code == 65);
  CHECK_THAT(huge.err, contains_text("24 TB"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"blind.sdf", "typo.sdf"});
}

TEST_CASE("65: faulty environments", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("cut.hdr", "#?RADIANCE\n\n-Y 2 +X 2\n123");
  lichtraum.folder.write("sky.png", "\x89PNG");
  for (char const* const name : {"cut.hdr", "sky.png"}) {
    auto const result = lichtraum.render(std::string("a.sdf --environment ") + name);
    CHECK(result.exit_code == 65);
    CHECK(is_one_line(result.err));
    CHECK_THAT(result.err, contains_text(std::string(name) + ": "));
  }
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "cut.hdr", "sky.png"});
}

TEST_CASE("66: inputs that do not exist", "[app][exit]") {
  Lichtraum const lichtraum;
  for (char const* const words : {"render nope.sdf --device reference", "check nope.sdf", "info nope.sdf"}) {
    auto const result = lichtraum(words);
    CHECK(result.exit_code == 66);
    CHECK(is_one_line(result.err));
    CHECK_THAT(result.err, contains_text("nope.sdf"));
  }
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const result = lichtraum.render("a.sdf --environment nope.hdr");
  CHECK(result.exit_code == 66);
  CHECK_THAT(result.err, contains_text("nope.hdr"));
}

TEST_CASE("66: an empty name, and any name in a folder that was deleted", "[app][exit]") {
  Lichtraum const lichtraum;
  auto const check = [&](std::string const& command) {
    CAPTURE(command);
    Process process = lichtraum.process("");
    process.arguments = {"sh", "-c", "mkdir gone && cd gone && rmdir ../gone && exec \"$0\" " + command,
                         process.arguments.front(), lichtraum.folder / "plan"};
    auto const result = run_process(process);
    CHECK(result.exit_code == 66);
    CHECK_THAT(result.err, contains_text("cannot open '"));
    CHECK_THAT(result.err, contains_text("No such file or directory [E0206]"));
  };
  for (char const* const name : {"''", "a.sdf", "'' a.sdf ''"}) {
    for (char const* const command : {"render --device reference ", "check ", "job plan -o \"$1\" "}) {
      check(std::string(command) + name);
    }
  }
}

TEST_CASE("69: no such device", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const result = lichtraum("render a.sdf --device abacus");
  CHECK(result.exit_code == 69);
  CHECK_THAT(result.err, contains_text("'abacus'") && contains_text("reference"));
}

TEST_CASE("73: outputs that cannot be written are found before rendering", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  // Drawing this would take minutes.
  std::string const slow = " --size 4000x4000 --samples 100";
  for (char const* const where : {"-o missing/a.png", "--output-dir missing", "-o a.sdf/x.png", "-o /proc/x.png"}) {
    auto const result = lichtraum.render("a.sdf " + (where + slow));
    INFO(where);
    CHECK(result.exit_code == 73);
    CHECK(is_one_line(result.err));
    CHECK(result.seconds < 5);
  }
  // The second picture of a scene counts too.
  lichtraum.folder.write("two.sdf", std::string(ball_scene) + "render eye missing/two.ppm 32 24\n");
  CHECK(lichtraum.render("two.sdf").exit_code == 73);
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "two.sdf"});
}

TEST_CASE("73: no picture takes the place of a file that it is drawn from", "[app][exit]") {
  Lichtraum const lichtraum;
  auto const& folder = lichtraum.folder;
  folder.write("a.sdf", ball_scene);
  REQUIRE(lichtraum.render("a.sdf -o duck.png --size 8x8 --device reference").exit_code == 0);
  REQUIRE(lichtraum.render("a.sdf -o sky.exr --size 8x8 --device reference").exit_code == 0);
  folder.write("duck.obj",
               "mtllib duck.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  folder.write("duck.mtl", "newmtl m\nmap_Kd duck.png\n");
  std::filesystem::create_symlink("duck.obj", folder.path() / "link.png");
  std::vector<std::string> const names{"a.sdf", "duck.mtl", "duck.obj", "duck.png", "link.png", "sky.exr"};
  std::map<std::string, std::string> before;
  for (std::string const& name : names) before[name] = folder.read(name);
  for (char const* const words :
       {"render duck.obj", "check duck.obj", "render duck.obj -o link.png", "render a.sdf -o a.sdf --format png",
        "render a.sdf --environment sky.exr -o sky.exr", "render a.sdf --environment sky.exr -o ./sky.exr",
        "thumbnail a.sdf a.sdf", "denoise sky.exr -o sky.exr"}) {
    INFO(words);
    auto const result = run_process(lichtraum.process(words));
    CHECK(result.exit_code == 73);
    CHECK_THAT(result.err + result.out, contains_text("is read for this picture"));
    CHECK(folder.names() == names);
    for (std::string const& name : names) CHECK(folder.read(name) == before[name]);
  }
  CHECK(lichtraum.render("duck.obj --size 8x8 --device reference -o other.png").exit_code == 0);
  CHECK(lichtraum.render("duck.obj --size 8x8 --device reference -o other.png").exit_code == 0);  // again
}

TEST_CASE("74: a full disk, a size limit and a reader that has gone; the old picture stays", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  for (char const* const words : {"-o /dev/full", "-o /dev/full --format ppm"}) {
    auto const result = lichtraum.render(std::string("a.sdf ") + words);
    CHECK(result.exit_code == 74);
    CHECK_THAT(result.err, contains_text("the disk is full"));
  }

  lichtraum.folder.write("ball.ppm", "old");
  Process limited = lichtraum.process("render a.sdf --device reference");
  limited.max_file_bytes = 1000;
  auto const result = run_process(limited);
  CHECK(result.exit_code == 74);
  CHECK(result.signal == 0);
  CHECK_THAT(result.err, contains_text("ball.ppm") && contains_text("ulimit -f"));
  CHECK(lichtraum.folder.read("ball.ppm") == "old");
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "ball.ppm"});

  for (char const* const words : {"render a.sdf --device reference -o -", "render --help", "--help", "--version",
                                  "check a.sdf", "info a.sdf", "render a.sdf --device reference --json"}) {
    INFO(words);
    Process full = lichtraum.process(words);
    full.output_file = "/dev/full";
    CHECK(run_process(full).exit_code == 74);
    Process unread = lichtraum.process(words);
    unread.stops_reading = true;
    auto const broken_pipe = run_process(unread);
    CHECK(broken_pipe.exit_code == 74);
    CHECK(broken_pipe.signal == 0);
  }
}

TEST_CASE("73 or 74: a standard output that is closed takes no results", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const code = [&](std::string const& words) {
    INFO(words);
    Process closed = lichtraum.process(words);
    closed.closes_output = true;
    auto const result = run_process(closed);
    CHECK_THAT(result.err, contains_text("cannot write to standard output: it is closed"));
    return result.exit_code;
  };
  CHECK(code("render a.sdf --device reference -o -") == 73);  // before anything is drawn
  CHECK(code("render a.sdf --device reference --json") == 74);
  CHECK(code("info a.sdf") == 74);
}

TEST_CASE("a closed standard output never becomes part of a picture", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  REQUIRE(lichtraum.render("a.sdf -o good.ppm").exit_code == 0);
  Process closed = lichtraum.process("render a.sdf --device reference --json");
  closed.closes_output = true;
  run_process(closed);
  CHECK(lichtraum.folder.read("ball.ppm") == lichtraum.folder.read("good.ppm"));
}

TEST_CASE("with several scenes the others are drawn, and the first failure counts", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  auto const result = lichtraum.render("nope.sdf bad.sdf a.sdf");
  CHECK(result.exit_code == 66);
  CHECK_THAT(result.err, contains_text("2 of 3 scenes could not be drawn"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "bad.sdf", "ball.ppm"});
  CHECK(lichtraum.render("bad.sdf nope.sdf a.sdf").exit_code == 65);
  // It is said which one is meant.
  CHECK_THAT(lichtraum.render("bad.sdf a.sdf --region 0,0,999,1").err,
             contains_text("error: a.sdf: the region 0,0,999,1 does not lie in"));
  auto const checked = lichtraum("check a.sdf bad.sdf nope.sdf");
  CHECK(checked.exit_code == 65);
  CHECK_THAT(checked.out, contains_text("a.sdf: good") && contains_text("bad.sdf: 1 error"));
}

TEST_CASE("130: an interrupted picture is kept beside its target", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("out.png", "old");
  // timeout sends its signal twice: to the process, and to its group.
  for (auto const& [number, times] : {std::pair(SIGINT, 1), std::pair(SIGTERM, 2), std::pair(SIGHUP, 1)}) {
    Process process = lichtraum.process("render a.sdf -o out.png --device reference --size 800x600 --samples 1000");
    process.signals.assign(std::size_t(times), {.number = number, .after_cpu_seconds = 0.7});
    auto const result = run_process(process);
    CHECK(result.exit_code == 130);
    CHECK(result.seconds_after_signal < 1);  // on an idle machine it stops within 0.1 s
    CHECK_THAT(result.err, contains_text("out.partial.png"));
    CHECK(lichtraum.folder.read("out.png") == "old");
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf", "out.partial.png", "out.png"});
    std::filesystem::remove(lichtraum.folder / "out.partial.png");
  }
}

TEST_CASE("an interrupted picture for standard output is not written at all", "[app][exit]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  Process process = lichtraum.process("render a.sdf b.sdf -o - --device reference --size 800x600 --samples 1000");
  process.signals = {{.number = SIGINT, .after_cpu_seconds = 0.7}};
  auto const result = run_process(process);
  CHECK(result.exit_code == 130);
  CHECK(result.out.empty());
}
