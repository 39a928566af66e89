#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "lichtraum/exr_layers.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

namespace {

/// A ball before a wall; sky above. The shadows' edges are noisy.
constexpr char const* scene =
    "define material grey 0 0 0  0.5 0.5 0.5  0 0 0  1\n"
    "define shape box wall -9 -9 -9 9 2 -8 grey\n"
    "define shape sphere ball -1 0 -6  1 grey\n"
    "define shape composite both wall ball\n"
    "define light diffuse sun 4 6 9 0.9 0.9 0.8\n"
    "define background 0.5 0.25 0\n"
    "define camera eye 60 64 48\n";

struct Run {
  Lichtraum const& lichtraum;
  std::map<std::string, std::string> environment = {{"LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN}};

  ProcessResult operator()(std::string const& words, std::string const& input = {}) const {
    Process process = lichtraum.process(words);
    process.input = input;
    process.environment = environment;
    return run_process(process);
  }
};

std::size_t count_of(std::string const& text, std::string const& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("Whitted's pictures are denoised only where that is asked for", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  auto const draw = [&](std::string const& options, std::string const& file) {
    auto const result = run("render - -q --device reference --samples 4 " + options + " -o " + file, scene);
    INFO(options);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    return lichtraum.folder.read(file);
  };
  std::string const plain = draw("", "plain.ppm");
  CHECK(draw("--denoise auto", "auto.ppm") == plain);
  CHECK(draw("--denoise off", "off.ppm") == plain);
  CHECK(draw("--denoise builtin", "builtin.ppm") != plain);
  // The library that is found halves what it is given.
  CHECK(decode(draw("--denoise on", "on.ppm")).at(32, 2, 0) == 64);
  CHECK(decode(plain).at(32, 2, 0) == 128);
  // So it works on radiance, before exposure and transfer.
  CHECK(decode(draw("--denoise on --exposure 1", "bright.ppm")).at(32, 2, 0) == 128);
  auto const transparent = decode(draw("--denoise on --background none", "cut.png"));
  CHECK(transparent.alpha == decode(draw("--background none", "raw_cut.png")).alpha);
  // A film's planes stay as they are, and other planes have no noise.
  std::string const planes = draw("--planes radiance,normal", "planes.exr");
  CHECK(draw("--planes radiance,normal --denoise on", "same.exr") == planes);
  CHECK(draw("--planes depth --denoise on", "depth.png").size() == draw("--planes depth", "same_depth.png").size());
}

TEST_CASE("--denoise says what it cannot do", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run run{lichtraum};
  std::string const render = "render - --device reference ";
  auto const film = run(render + "--denoise on -o film.exr", scene);
  CHECK(film.exit_code == 0);
  CHECK_THAT(film.err, contains_text("--denoise has no effect on 'film.exr': planes are stored as traced (lichtraum "
                                     "denoise)"));
  CHECK_THAT(run(render + "--planes depth --denoise builtin -o depth.png", scene).err,
             contains_text("--denoise has no effect on 'depth.png'"));
  auto const unknown = run(render + "--denoise maybe -o a.png", scene);
  CHECK(unknown.exit_code == 64);
  CHECK_THAT(unknown.err, contains_text("--denoise: expected auto, on, off or builtin, not 'maybe'"));
}

TEST_CASE("without Open Image Denoise the built-in filter is used, which is said once", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run run{lichtraum};
  lichtraum.folder.write("a.sdf", scene);
  lichtraum.folder.write("b.sdf", scene);
  REQUIRE(run("render a.sdf -q --device reference --samples 4 --denoise builtin -o builtin.ppm").exit_code == 0);
  auto const check = [&](std::string const& why) {
    auto const result = run("render a.sdf b.sdf --device reference --samples 4 --denoise on -o %d.ppm");
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK(count_of(result.err, "Open Image Denoise cannot be used") == 1);
    CHECK_THAT(result.err, contains_text("warning: noise is filtered by lichtraum's own filter") && contains_text(why));
    CHECK(lichtraum.folder.read("1.ppm") == lichtraum.folder.read("builtin.ppm"));
    CHECK(lichtraum.folder.read("2.ppm") == lichtraum.folder.read("builtin.ppm"));
  };
  run.environment = {{"LICHTRAUM_OIDN", "/nowhere"}};
  check("/nowhere: cannot open shared object file");
  run.environment = {{"LICHTRAUM_OIDN", LICHTRAUM_LACKING_OIDN}};
  check("it lacks the function oidnExecuteFilter, so it is not version 2");
  run.environment = {{"LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN}, {"FAKE_OIDN", "version"}};
  check("it is Open Image Denoise 3.7.9, and version 2 is needed");
  run.environment["FAKE_OIDN"] = "memory";
  check("out of memory");
}

TEST_CASE("a picture that was denoised otherwise is drawn again", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run run{lichtraum};
  auto const is_skipped = [&](std::string const& options) {
    auto const result = run("render - --device reference --resume -o picture.png " + options, scene);
    REQUIRE(result.exit_code == 0);
    return result.err.find("already there") != std::string::npos;
  };
  CHECK_FALSE(is_skipped(""));
  CHECK(is_skipped("--denoise auto"));
  CHECK_FALSE(is_skipped("--denoise builtin"));
  CHECK(is_skipped("--denoise builtin"));
  CHECK_FALSE(is_skipped("--denoise on"));
  CHECK(is_skipped("--denoise on"));
  run.environment = {{"LICHTRAUM_OIDN", "/nowhere"}};
  CHECK_FALSE(is_skipped("--denoise on"));
  CHECK(is_skipped("--denoise builtin"));
  // What only failed on the way is drawn again when it may not fail.
  run.environment = {{"LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN}, {"FAKE_OIDN", "memory"}};
  CHECK_FALSE(is_skipped("--denoise on"));
  run.environment.erase("FAKE_OIDN");
  CHECK_FALSE(is_skipped("--denoise on"));
}

TEST_CASE("statistics name what took the noise out", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  auto const picture = [&](std::string const& options) {
    auto const result = run("render - -q --json --device reference -o picture.png " + options, scene);
    return nlohmann::json::parse(result.out).at("scenes").at(0).at("pictures").at(0);
  };
  CHECK(picture("").at("denoiser").is_null());
  CHECK(picture("").at("denoise_ms") == 0);
  CHECK(picture("--denoise builtin").at("denoiser") == "the built-in filter");
  CHECK(picture("--denoise on").at("denoiser") == "Open Image Denoise 2.7.9");
  CHECK(picture("--denoise on").at("denoise_ms") > 0);
}

TEST_CASE("the noise is taken out of a stored film, and its other layers stay", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  std::string const render = "render - -q --device reference --samples 4 ";
  REQUIRE(run(render + "--planes radiance,alpha,albedo,normal,object -o film.exr", scene).exit_code == 0);
  auto const result = run("denoise film.exr");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, contains_text("film-denoised.exr: 64x48, denoised in") &&
                             contains_text("by Open Image Denoise 2.7.9") && !contains_text("warning"));
  std::string const film = lichtraum.folder.read("film.exr"), denoised = lichtraum.folder.read("film-denoised.exr");
  auto expected = decode_exr_floats(film, "G");
  for (float& value : expected) value *= 0.5f;
  CHECK(decode_exr_floats(denoised, "G") == expected);
  for (char const* const channel : {"A", "albedo.R", "albedo.B", "N.X", "N.Z"}) {
    CHECK(decode_exr_floats(denoised, channel) == decode_exr_floats(film, channel));
  }
  CHECK(decode_exr_numbers(denoised, "object") == decode_exr_numbers(film, "object"));
  CHECK_THAT(film, contains_text("lichtraumFingerprint"));
  CHECK(denoised.find("lichtraumFingerprint") == std::string::npos);  // it would be taken for the other
}

TEST_CASE("a stored film gives the picture that is drawn at once", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  std::string const render = "render - -q --device reference --samples 4 ";
  REQUIRE(run(render + "--planes radiance,albedo,normal -o film.exr", scene).exit_code == 0);
  REQUIRE(run(render + "--denoise builtin --exposure 0.5 --transfer srgb -o direct.png", scene).exit_code == 0);
  auto const result = run("denoise film.exr -q --device reference --denoise builtin --exposure 0.5 -o stored.png");
  CHECK(result.exit_code == 0);
  CHECK(decode(lichtraum.folder.read("stored.png")).values == decode(lichtraum.folder.read("direct.png")).values);
  CHECK(run("denoise film.exr -q -o stored.pfm").exit_code == 0);
  CHECK(run("denoise film.exr -q -o stored.jpg").exit_code == 0);
}

TEST_CASE("what is not finite or beyond all measure in a stored film is no light, and is told", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  REQUIRE(run("render - -q --device reference --planes radiance,albedo,normal -o film.exr", scene).exit_code == 0);
  lichtraum::ExrLayers layers(lichtraum.folder.read("film.exr"), "film.exr");
  auto values = layers.values({"R", "G", "B"});
  values[3000] = INFINITY;
  values[3001] = NAN;
  values[6000] = 1e38f;
  layers.set_values({"R", "G", "B"}, values);
  lichtraum.folder.write("faulty.exr", layers.encode());
  values[3000] = values[3001] = values[6000] = 0;
  layers.set_values({"R", "G", "B"}, values);
  lichtraum.folder.write("repaired.exr", layers.encode());
  auto const result = run("denoise faulty.exr --device reference --denoise builtin -o faulty.pfm");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, contains_text("warning: 'faulty.exr' has radiance that is not finite or beyond 1e+18 (3 "
                                       "numbers): it is taken for 0"));
  CHECK(run("denoise repaired.exr -q --device reference --denoise builtin -o repaired.pfm").exit_code == 0);
  CHECK(lichtraum.folder.read("faulty.pfm") == lichtraum.folder.read("repaired.pfm"));
}

TEST_CASE("options of denoise without effect are told", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  REQUIRE(run("render - -q --device reference --planes radiance,albedo,normal -o film.exr", scene).exit_code == 0);
  auto const said = [&](std::string const& words) {
    auto const result = run("denoise film.exr --device reference " + words);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  for (char const* const option : {"--exposure 1", "--tonemap agx", "--transfer linear"}) {
    std::string const name = std::string(option).substr(0, std::string(option).find(' '));
    CHECK_THAT(said(option), contains_text("warning: " + name + " has no effect on 'film-denoised.exr'"));
    CHECK_THAT(said(std::string(option) + " -o picture.pfm"), contains_text("has no effect on 'picture.pfm'"));
    CHECK_THAT(said(std::string(option) + " -o picture.png"), !contains_text("no effect"));
  }
  CHECK_THAT(said("--denoise builtin --prefilter"),
             contains_text("--prefilter has no effect") && contains_text("[W0101]"));
  CHECK_THAT(said("--prefilter"), !contains_text("no effect"));
}

TEST_CASE("what cannot be denoised is said", "[app][denoise]") {
  Lichtraum const lichtraum;
  Run const run{lichtraum};
  auto const fails = [&](std::string const& words, int code, std::string const& message) {
    auto const result = run("denoise " + words);
    INFO(words << "\n" << result.err);
    CHECK(result.exit_code == code);
    CHECK_THAT(result.err, contains_text(message));
  };
  std::string const render = "render - -q --device reference ";
  REQUIRE(run(render + "--planes depth,normal -o depth.exr", scene).exit_code == 0);
  REQUIRE(run(render + "-o colors.exr", scene).exit_code == 0);
  REQUIRE(run(render + "-o picture.png", scene).exit_code == 0);
  fails("missing.exr", 66, "missing.exr");
  fails("depth.exr", 65,
        "'depth.exr' has no radiance, which is in the channels R, G and B; it has: N.X, N.Y, N.Z, Z. lichtraum render "
        "--planes radiance,albedo,normal -o film.exr stores what is needed");
  fails("picture.png", 65, "'picture.png' is a PNG picture, not an OpenEXR file");
  lichtraum.folder.write("garden.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n");
  fails("garden.hdr", 65, "'garden.hdr' is a Radiance picture (.hdr), not an OpenEXR file");
  lichtraum.folder.write("noise.exr", "anything but an OpenEXR file");
  fails("noise.exr", 65, "'noise.exr' cannot be read as an OpenEXR file: it does not begin as OpenEXR files do");
  REQUIRE(run(render + "--background none --planes radiance,albedo,normal -o cut_out.exr", scene).exit_code == 0);
  fails("cut_out.exr -o cut_out.jpg", 64, "'cut_out.jpg' cannot be transparent, as 'cut_out.exr' is: .png and .exr");
  fails("cut_out.exr -o cut_out.png", 0, "");
  fails("colors.exr -o smooth.gif", 64, "no picture format has the extension '.gif'");
  fails("colors.exr -o nowhere/smooth.png", 73, "nowhere");
  fails("colors.exr --denoise off", 64, "--denoise: expected on or builtin, not 'off'");
  fails("colors.exr", 0,
        "warning: 'colors.exr' has no albedo and no normal: edges and textures are harder to tell "
        "from noise");
  std::string const whole = lichtraum.folder.read("colors.exr");
  for (std::size_t const size : {std::size_t(0), std::size_t(3), std::size_t(40), whole.size() / 2, whole.size() - 1}) {
    lichtraum.folder.write("cut.exr", whole.substr(0, size));
    fails("cut.exr", 65, "'cut.exr' cannot be read as an OpenEXR file");
  }
}
