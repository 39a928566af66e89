#include <signal.h>
#include <sys/stat.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"

using Json = nlohmann::json;

namespace {

/// Two balls that move apart, in six pictures of 64 x 48.
std::string moving_balls() {
  std::string scene =
      "define material red 0.3 0 0 0.6 0.1 0.1 0 0 0 1\ndefine material blue 0 0 0.3 0.1 0.1 0.6 0 0 0 1\n"
      "define shape sphere a -0.5 0 -4 0.8 red\ndefine shape sphere b 0.5 0 -4 0.8 blue\n"
      "define light ambient sky 1 1 1\ndefine light diffuse sun 5 5 5 1 1 1\ndefine background 0.2 0.5 0.3\n"
      "define camera eye 60 64 48\n";
  for (int i = 0; i < 6; ++i) {
    scene += "render eye x.png\ntransform a translate -0.2 0.1 0\ntransform b translate 0.2 0 0\n";
  }
  return scene;
}

/// The film's pictures as ffmpeg reads them.
std::vector<DecodedImage> decode_film(Lichtraum const& lichtraum, std::string const& name, int width, int height) {
  Process process;
  process.folder = lichtraum.folder.path();
  process.arguments = {"ffmpeg", "-v",       "error",    "-i",    name, "-vf", "scale=in_color_matrix=bt709",
                       "-f",     "rawvideo", "-pix_fmt", "rgb24", "-"};
  auto const result = run_process(process);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  std::size_t const bytes = std::size_t(width) * std::size_t(height) * 3;
  REQUIRE(result.out.size() % bytes == 0);
  std::vector<DecodedImage> frames;
  for (std::size_t at = 0; at < result.out.size(); at += bytes) {
    DecodedImage frame{width, height, 255, {}};
    for (std::size_t i = 0; i < bytes; ++i)
      frame.values.push_back(float(static_cast<unsigned char>(result.out[at + i])));
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// Root mean square of the differences, of 255, between blocks of 2 x 2 pixels: that is how coarsely films store
/// colour.
double difference(DecodedImage const& a, DecodedImage const& b) {
  double sum = 0;
  for (int y = 0; y + 1 < a.height; y += 2) {
    for (int x = 0; x + 1 < a.width; x += 2) {
      for (int channel = 0; channel < 3; ++channel) {
        double block = 0;
        for (auto const& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
          block += double(a.at(x + dx, y + dy, channel) - b.at(x + dx, y + dy, channel)) / 4;
        }
        sum += block * block;
      }
    }
  }
  return std::sqrt(sum / (0.75 * a.width * a.height));
}

/// A program called ffmpeg, first on the path.
Process with_ffmpeg(Lichtraum const& lichtraum, std::string const& words, std::string const& script) {
  std::filesystem::create_directory(lichtraum.folder / "bin");
  auto const file = lichtraum.folder.write("bin/ffmpeg", script);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  Process process = lichtraum.process("render --device reference " + words);
  process.environment = {{"PATH", (lichtraum.folder / "bin").string() + ":" + std::getenv("PATH")}};
  return process;
}

}  // namespace

TEST_CASE("a film shows the pictures", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  REQUIRE(lichtraum.render("balls.sdf -q -o %d.png").exit_code == 0);
  struct Film {
    char const* name;
    double tolerance;  // of 255: what the encoder loses
  };
  for (Film const film : {Film{"film.mp4", 5}, Film{"film.webm", 5}, Film{"film.gif", 3}}) {
    INFO(film.name);
    auto const result = lichtraum.render(std::string("balls.sdf --json --fps 10 -o ") + film.name);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, contains_text(std::string(film.name) + ": 6 pictures, 64x48, 0.60 s at 10 a second"));
    CHECK(Json::parse(result.out)["film"] == film.name);
    auto const frames = decode_film(lichtraum, film.name, 64, 48);
    REQUIRE(frames.size() == 6);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      auto const right = decode(lichtraum.folder.read(std::to_string(i + 1) + ".png"));
      auto const wrong = decode(lichtraum.folder.read(std::to_string(i < 3 ? i + 4 : i - 2) + ".png"));
      CHECK(difference(frames[i], right) < film.tolerance);
      CHECK(difference(frames[i], wrong) > 2 * film.tolerance);
      // The background, (0.2, 0.5, 0.3): another matrix of colours would show.
      for (int channel : {0, 1, 2}) CHECK(std::abs(frames[i].at(60, 4, channel) - right.at(60, 4, channel)) <= 3);
    }
  }
  for (std::string const& name : lichtraum.folder.names()) CHECK(name.find("tmp") == std::string::npos);
}

TEST_CASE("a film stores the numbers that are nearest to BT.709's", "[app][film]") {
  Lichtraum const lichtraum;
  struct Color {
    double r, g, b;  // of 255
  };
  for (Color const& color : {Color{51, 26, 230}, Color{204, 51, 26}, Color{77, 33, 99}, Color{3, 250, 140}}) {
    lichtraum.folder.write("a.sdf", "define camera eye 40\ndefine background " + std::to_string(color.r / 255) + " " +
                                        std::to_string(color.g / 255) + " " + std::to_string(color.b / 255) +
                                        "\nrender eye a.png 64 64\nrender eye a.png 64 64\n");
    // ITU-R BT.709-6, sections 3.2, 3.3 and 4.6, for numbers of 8 bits
    double const y = (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b) / 255;
    int const right[] = {int(std::lround(16 + 219 * y)), int(std::lround(128 + 224 * (color.b / 255 - y) / 1.8556)),
                         int(std::lround(128 + 224 * (color.r / 255 - y) / 1.5748))};
    for (std::string const film : {"a.mp4", "a.webm"}) {
      REQUIRE(lichtraum.render("a.sdf -q -o " + film).exit_code == 0);
      Process process;
      process.folder = lichtraum.folder.path();
      process.arguments = {"ffmpeg", "-v", "error", "-i", film, "-f", "rawvideo", "-pix_fmt", "yuv420p", "-"};
      std::string const planes = run_process(process).out;
      REQUIRE(planes.size() == 2 * 64 * 64 * 3 / 2);
      INFO(film << ": " << color.r << ' ' << color.g << ' ' << color.b);
      auto const stored = [&](std::size_t at) { return int(static_cast<unsigned char>(planes[at])); };
      for (std::size_t at = 0; at < 64 * 64; ++at) REQUIRE(stored(at) == right[0]);
      for (std::size_t at = 0; at < 32 * 32; ++at) {
        REQUIRE(stored(64 * 64 + at) == right[1]);
        REQUIRE(stored(64 * 64 + 32 * 32 + at) == right[2]);
      }
    }
  }
}

TEST_CASE("a model's film is its whole animation, or a turntable", "[app][film][gltf]") {
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0});
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const places = writer.add_vec3({0, 0, 0, 2, 0, 0});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  lichtraum.folder.write("model.glb", writer.glb());
  auto const frames = [&](std::string const& words) {
    auto const result = lichtraum.render("model.glb -q --json --size 16x16 -o film.gif " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return Json::parse(result.out)["scenes"][0]["pictures"].size();
  };
  CHECK(frames("--fps 4") == 8);
  CHECK(frames("") == 50);
  CHECK(frames("--frames 3..4") == 2);
  CHECK(frames("--turntable 5") == 5);
  CHECK(frames("--time 1") == 1);
}

TEST_CASE("a film of one picture is warned about, and check tells of a film in one line", "[app][film][check]") {
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0});
  lichtraum.folder.write("a.glb", writer.glb());
  lichtraum.folder.write("b.glb", writer.glb());
  auto const check = [&](std::string const& words) {
    auto const result = lichtraum("check --device reference --size 16x16 -o film.gif " + words);
    CHECK(result.exit_code == 0);
    return result;
  };
  auto const still = check("a.glb");
  CHECK_THAT(still.err, contains_text("W0821") && contains_text("shown for 0.04 s: the model has no animation") &&
                            contains_text("--turntable 90"));
  CHECK_THAT(still.out, contains_text(": 1 picture, 0.04 s at 25 a second\n"));
  CHECK(check("a.glb b.glb").err.find("W0821") == std::string::npos);
  auto const turning = check("a.glb --turntable 90 --fps 30");
  CHECK(turning.err.find("W0821") == std::string::npos);
  CHECK_THAT(turning.out,
             contains_text("\n  would write film.gif, 16x16, camera 'default': 90 pictures, 3.00 s at 30 a "
                           "second\n") &&
                 !contains_text("more picture"));
}

TEST_CASE("what cannot become a film is refused before anything is drawn", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  lichtraum.folder.write("other.sdf", "define camera eye 60 32 24\n");
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  auto const code = [&](std::string const& words, std::string const& message) {
    auto const result = lichtraum.render(words);
    INFO(words);
    CHECK_THAT(result.err, contains_text(message));
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"bad.sdf", "balls.sdf", "other.sdf"});
    return result.exit_code;
  };
  CHECK(code("balls.sdf --size 33x24 -o film.mp4", "even") == 64);
  CHECK(code("balls.sdf -o film%d.mp4", "a film is one file") == 64);
  CHECK(code("balls.sdf -o film.mp4 --format png", "contradicts") == 64);
  CHECK(code("balls.sdf -o film.mp4 --resume", "cannot be resumed") == 64);
  CHECK(code("balls.sdf -o film.gif --fps 51", "at most 50 pictures a second") == 64);
  CHECK(code("balls.sdf -o nowhere/film.mp4", "nowhere") == 73);
  CHECK(code("balls.sdf other.sdf -o film.gif", "one size") == 65);
  CHECK(code("balls.sdf bad.sdf -o film.gif", "nonsense") == 65);

  Process process = lichtraum.process("render --device reference balls.sdf -o film.mp4");
  process.environment = {{"PATH", lichtraum.folder.path()}};
  auto const without = run_process(process);
  CHECK(without.exit_code == 69);
  CHECK_THAT(without.err, contains_text("apt install ffmpeg"));
  CHECK(!std::filesystem::exists(lichtraum.folder / "film.mp4"));
}

TEST_CASE("what ffmpeg says when it fails is told, and the old film stays", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  lichtraum.folder.write("film.mp4", "old");
  for (std::string const script : {"#!/bin/sh\necho first >&2\necho 'no such encoder' >&2\nexit 3\n",
                                   "#!/bin/sh\ncat > /dev/null\necho 'no such encoder' >&2\nexit 3\n"}) {
    auto const result = run_process(with_ffmpeg(lichtraum, "balls.sdf -o film.mp4", script));
    CHECK(result.exit_code == 74);
    CHECK_THAT(result.err, contains_text("no such encoder"));
    CHECK(lichtraum.folder.read("film.mp4") == "old");
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"balls.sdf", "bin", "film.mp4"});
  }
}

TEST_CASE("an unfinished film is a new file, of a name that nobody can foresee", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  auto const result = run_process(with_ffmpeg(lichtraum, "balls.sdf -o film.mp4",
                                              "#!/bin/sh\n"
                                              "for last; do :; done\n"
                                              "file=${last#file:}\n"
                                              "[ -f \"$file\" ] && [ ! -s \"$file\" ] && echo \"$file\" > name\n"
                                              "exit 3\n"));
  CHECK(result.exit_code == 74);
  CHECK(lichtraum.folder.read("name").size() >= std::string(".lichtraum-0123456789abcdef.tmp.mp4\n").size());
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"balls.sdf", "bin", "name"});
}

TEST_CASE("a film that is interrupted twice leaves nothing behind", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  // Interrupts lichtraum at the first picture, with a part of the film written, and again at the film's end, for which
  // it takes long.
  auto const result = run_process(with_ffmpeg(lichtraum, "balls.sdf --turntable 500 --samples 8x8 -o film.mp4",
                                              "#!/bin/sh\n"
                                              "for last; do :; done\n"
                                              "echo part > \"${last#file:}\"\n"
                                              "head -c 1 > /dev/null\n"
                                              "kill -INT $PPID\n"
                                              "cat > /dev/null\n"
                                              "echo end > at_its_end\n"
                                              "sleep 1\n"  // what follows at once is the same request
                                              "kill -INT $PPID\n"
                                              "exec sleep 20\n"));
  CHECK(result.exit_code == 130);
  CHECK(result.seconds < 15);
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"at_its_end", "balls.sdf", "bin"});
}

TEST_CASE("an interrupted film is what was done, under another name", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  Process process = lichtraum.process("render --device reference balls.sdf --turntable 500 --samples 8x8 -o film.mp4");
  process.signals = {{.number = SIGINT, .after_cpu_seconds = 4}};  // of minutes; a picture takes a tenth of a second
  auto const result = run_process(process);
  CHECK(result.exit_code == 130);
  CHECK_THAT(result.err, contains_text("interrupted") && contains_text("film.partial.mp4: "));
  REQUIRE(lichtraum.folder.names() == std::vector<std::string>{"balls.sdf", "film.partial.mp4"});
  auto const frames = decode_film(lichtraum, "film.partial.mp4", 64, 48);
  CHECK(!frames.empty());
  CHECK(frames.size() < 3000);
}

TEST_CASE("a film goes where a link leads, and keeps the permissions that the old one had", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  namespace fs = std::filesystem;
  fs::create_directory(lichtraum.folder / "disk");
  lichtraum.folder.write("disk/film.mp4", "old");
  fs::permissions(lichtraum.folder / "disk/film.mp4", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("disk/film.mp4", lichtraum.folder / "film.mp4");
  auto const result = lichtraum.render("-q --device reference balls.sdf --turntable 2 -o film.mp4");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(fs::is_symlink(lichtraum.folder / "film.mp4"));
  CHECK(fs::file_size(lichtraum.folder / "disk/film.mp4") > 100);
  CHECK(fs::status(lichtraum.folder / "disk/film.mp4").permissions() ==
        (fs::perms::owner_read | fs::perms::owner_write));
  std::size_t const files = std::size_t(std::distance(fs::directory_iterator(lichtraum.folder / "disk"), {}));
  CHECK(files == 1);
}

TEST_CASE("what no film can be is refused before anything is drawn", "[app][film]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("balls.sdf", moving_balls());
  SECTION("an odd size") {
    for (char const* const command : {"check", "render"}) {
      auto const result = lichtraum(std::string(command) + " balls.sdf -o film.mp4 --size 33x32");
      CHECK(result.exit_code == 64);
      CHECK_THAT(result.err + result.out, contains_text("an .mp4 needs an even width and height, not 33x32"));
    }
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"balls.sdf"});
  }
  SECTION("something that is no file") {
    REQUIRE(::mkfifo((lichtraum.folder / "film.gif").c_str(), 0600) == 0);
    auto const result = lichtraum.render("balls.sdf -o film.gif");
    CHECK(result.exit_code == 73);
    CHECK_THAT(result.err, contains_text("films are written to files only"));
    CHECK(std::filesystem::is_fifo(lichtraum.folder / "film.gif"));
  }
}
