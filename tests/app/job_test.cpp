#include <signal.h>
#include <sys/mount.h>

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/skip.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Noisy by path, with a lamp that has a size.
constexpr char const* lamp_scene =
    "define material red 0.1 0 0 0.7 0.2 0.2 0 0 0 1\n"
    "define shape sphere ball 0 0 -3 1 red\n"
    "define shape box floor -4 -2 -8 4 -1 0 red\n"
    "define light diffuse sun 3 4 0 30 30 30 radius=0.5\n"
    "define camera eye 60\n"
    "render eye lamp.png 50 37\n";

/// Commands under `lichtraum job`, on the reference tracer.
struct Farm : Lichtraum {
  Farm() {
    folder.write("ball.sdf", ball_scene);
    folder.write("lamp.sdf", lamp_scene);
  }
  ProcessResult plan(std::string const& words) const {
    return (*this)("job plan --device reference -o shared -q " + words);
  }
  ProcessResult work(std::string const& words = "") const {
    return (*this)("job work shared " + words);  // by the plan's device
  }
  ProcessResult merge(std::string const& words) const { return (*this)("job merge shared " + words); }
  Json status() const { return Json::parse((*this)("job status shared --json").out); }

  std::vector<fs::path> files(std::string const& extension) const {
    std::vector<fs::path> found;
    for (auto const& entry : fs::recursive_directory_iterator(folder / "shared")) {
      if (entry.is_regular_file() && entry.path().extension() == extension) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  fs::path unit(int number) const {
    for (fs::path const& path : files(".unit")) {
      if (path.stem() == std::to_string(number)) return path;
    }
    throw std::runtime_error("there is no unit " + std::to_string(number));
  }
};

std::string bytes_of(fs::path const& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void put(fs::path const& path, std::string const& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

}  // namespace

TEST_CASE("what machines draw together has the bytes of what one draws", "[app][job]") {
  struct Case {
    char const* name;
    std::string scene, options, cut;
    int units;
  };
  for (Case const& c :
       {Case{"one sample", "ball.sdf", "--size 61x33", "--tile 16x16", 12},
        Case{"a region", "ball.sdf", "--size 61x33 --region 5,3,40,20 --bits 16", "--tile 16x16", 6},
        Case{"many samples", "ball.sdf", "--samples 40", "--tile 20x20 --samples-per-unit 16", 12},
        Case{"without noise", "lamp.sdf", "--samples 20 --denoise builtin", "--tile 32x32 --samples-per-unit 16", 8},
        Case{"paths", "lamp.sdf", "--samples 4 --denoise off --seed 7 --exposure 1", "--tile 32x32", 4},
        Case{"transparent", "ball.sdf", "--background none --samples 4", "--tile 16x16", 4}}) {
    INFO(c.name);
    Farm const farm;
    for (std::string const extension : {"png", "exr"}) {
      REQUIRE(farm.render(c.scene + " -q " + c.options + " -o one." + extension).exit_code == 0);
    }
    auto const planned = farm.plan(c.scene + " " + c.options + " " + c.cut);
    INFO(planned.err);
    REQUIRE(planned.exit_code == 0);
    CHECK(farm.status()["units"] == c.units);
    CHECK(farm.status()["done"] == 0);
    auto const worked = farm.work();
    INFO(worked.err);
    REQUIRE(worked.exit_code == 0);
    CHECK(farm.status()["done"] == c.units);
    for (std::string const extension : {"png", "exr"}) {
      auto const merged = farm.merge("-q -o many." + extension);
      INFO(merged.err);
      REQUIRE(merged.exit_code == 0);
      CHECK(farm.folder.read("many." + extension) == farm.folder.read("one." + extension));
    }
  }
}

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

TEST_CASE("units that cannot be used are found and drawn again", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.render("ball.sdf -q -o one.png").exit_code == 0);
  REQUIRE(farm.plan("ball.sdf --tile 16x8").exit_code == 0);
  REQUIRE(farm.work("-q").exit_code == 0);

  std::string const cut = bytes_of(farm.unit(0)), flipped = bytes_of(farm.unit(1));
  put(farm.unit(0), cut.substr(0, cut.size() / 2));
  std::string changed = flipped;
  changed[changed.size() / 2] = char(changed[changed.size() / 2] ^ 4);
  put(farm.unit(1), changed);
  fs::copy_file(farm.unit(3), farm.unit(2), fs::copy_options::overwrite_existing);
  // The class of what drew it follows on the plan's hash: see Head in src/farm/unit_file.cpp.
  std::string forged = bytes_of(farm.unit(4));
  forged[24 + 32] = forged[24 + 32] == 'a' ? 'b' : 'a';
  put(farm.unit(4), forged);
  std::string foreign = bytes_of(farm.unit(5));
  foreign[24] = foreign[24] == 'a' ? 'b' : 'a';
  put(farm.unit(5), foreign);

  CHECK(farm.status()["cut_short"] == 1);
  fs::path const last = farm.unit(5), kept = farm.folder / "kept";
  fs::rename(last, kept);
  CHECK_THAT(farm.merge("-o many.png").err, contains_text("2 of 6 units missing, the first of them 0"));
  fs::rename(kept, last);
  auto const refused = farm.merge("-o many.png");
  INFO(refused.err);
  CHECK(refused.exit_code == 75);
  CHECK_THAT(refused.err,
             contains_text("unit 0 has") && contains_text("unit 1 does not have the bytes that were written") &&
                 contains_text("unit 2 is unit 3") && contains_text("unit 4 was drawn by a device of another class") &&
                 contains_text("unit 5 is of another plan") && contains_text("lichtraum job work shared") &&
                 contains_text("E0209"));
  CHECK(!fs::exists(farm.folder / "many.png"));
  CHECK(farm.files(".bad").size() == 4);  // the other class's may be of use
  CHECK(farm.merge("-o many.png").exit_code == 75);
  auto const again = farm.work();
  CHECK(again.exit_code == 0);
  CHECK_THAT(again.err, contains_text("5 units drawn, 1 there already"));
  REQUIRE(farm.merge("-q -o many.png").exit_code == 0);
  CHECK(farm.folder.read("many.png") == farm.folder.read("one.png"));
}

TEST_CASE("a device of another class is refused", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf --tile 16x16").exit_code == 0);
  // As if another device had planned it.
  fs::path const plan = farm.folder / "shared/plan.json";
  auto json = nlohmann::ordered_json::parse(bytes_of(plan));
  json["device"]["class"] = std::string(32, '0');
  json["device"]["name"] = "some other device";
  put(plan, json.dump());
  auto const refused = farm.work();
  CHECK(refused.exit_code == 65);
  CHECK_THAT(refused.err, contains_text("some other device") && contains_text("--allow-mixed"));
  CHECK(farm.status()["done"] == 0);
  CHECK(farm.work("-q --allow-mixed").exit_code == 0);
  auto const forgotten = farm.merge("-o many.png");
  CHECK(forgotten.exit_code == 75);
  CHECK_THAT(forgotten.err, contains_text("--allow-mixed takes it"));
  CHECK(farm.files(".bad").empty());
  CHECK(farm.merge("-q -o many.png --allow-mixed").exit_code == 0);  // nothing has to be drawn again
}

TEST_CASE("what cannot be read for now is left as it is", "[app][job]") {
  Farm const farm;
  farm.folder.write("part.obj", "v 0 0 -3\nv 1 0 -3\nv 0 1 -3\nf 1 2 3\n");
  farm.folder.write("with.sdf", std::string("define shape mesh part part.obj\n") + ball_scene);
  REQUIRE(farm.plan("with.sdf --tile 16x16").exit_code == 0);
  REQUIRE(farm.work("-q").exit_code == 0);
  // A link to itself cannot be opened, not even by root.
  fs::path const unit = farm.unit(1), model = farm.folder / "part.obj";
  for (fs::path const& path : {unit, model}) {
    fs::rename(path, path.string() + ".away");
    fs::create_symlink(path, path);
    auto const result = farm.merge("-o many.png");
    CHECK(result.exit_code == 75);
    CHECK_THAT(result.err, contains_text(path == unit ? "1 of 4 units missing" : "part.obj' cannot be read: "));
    fs::rename(path.string() + ".away", path);
    CHECK(farm.files(".bad").empty());
    CHECK(farm.merge("-q -o many.png").exit_code == 0);
  }
}

TEST_CASE("a file that has changed since the plan is named", "[app][job]") {
  Farm const farm;
  farm.folder.write("part.obj", "v 0 0 -3\nv 1 0 -3\nv 0 1 -3\nf 1 2 3\n");
  farm.folder.write("with.sdf", std::string("define shape mesh part part.obj\n") + ball_scene);
  REQUIRE(farm.plan("with.sdf").exit_code == 0);
  REQUIRE(farm.work("-q").exit_code == 0);
  farm.folder.write("part.obj", "v 0 0 -3\nv 1 0 -3\nv 0 2 -3\nf 1 2 3\n");
  for (auto const& result : {farm.work(), farm.merge("-o many.png")}) {
    CHECK(result.exit_code == 65);
    CHECK_THAT(result.err, contains_text("part.obj' has changed since the plan was made"));
  }
  fs::remove(farm.folder / "part.obj");
  CHECK_THAT(farm.work().err, contains_text("part.obj' is missing"));
}

TEST_CASE("killed workers leave nothing wrong, and several share the work", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.render("lamp.sdf -q --samples 64 --denoise off --size 160x120 -o one.png").exit_code == 0);
  REQUIRE(farm.plan("lamp.sdf --samples 64 --denoise off --size 160x120 --tile 8x8").exit_code == 0);
  Process worker = farm.process("job work shared -q --device reference");
  std::atomic<int> killed = 0;
  for (int round = 0; round < 3; ++round) {
    std::vector<std::jthread> workers;
    for (int i = 0; i < 3; ++i) {
      workers.emplace_back([&, i] {
        Process mine = worker;
        mine.signals = {{SIGKILL, 0.4 + 0.1 * i}};
        if (run_process(mine).signal == SIGKILL) ++killed;
      });
    }
  }
  CHECK(killed > 0);
  std::atomic<int> good = 0;
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < 3; ++i) {
      workers.emplace_back([&] { good += run_process(worker).exit_code == 0 ? 1 : 0; });
    }
  }
  CHECK(good == 3);
  CHECK(farm.status()["done"] == 300);
  REQUIRE(farm.merge("-q -o many.png").exit_code == 0);
  CHECK(farm.folder.read("many.png") == farm.folder.read("one.png"));
}

TEST_CASE("two workers may draw the same unit at once", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.render("lamp.sdf -q --samples 64 --denoise off -o one.png").exit_code == 0);
  REQUIRE(farm.plan("lamp.sdf --samples 64 --denoise off").exit_code == 0);
  std::atomic<int> good = 0;
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < 4; ++i)
      workers.emplace_back([&] { good += farm.work("-q --units 0..0").exit_code == 0 ? 1 : 0; });
  }
  CHECK(good == 4);
  CHECK(farm.files(".unit").size() == 1);
  CHECK(farm.files(".tmp").empty());
  REQUIRE(farm.merge("-q -o many.png").exit_code == 0);
  CHECK(farm.folder.read("many.png") == farm.folder.read("one.png"));
}

TEST_CASE("where a unit cannot be written, the same command goes on later", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf --size 200x200 --tile 100x100").exit_code == 0);
  Process worker = farm.process("job work shared --device reference");
  worker.max_file_bytes = 50'000;  // a unit has 120,000
  auto const full = run_process(worker);
  CHECK(full.exit_code == 75);
  CHECK_THAT(full.err, contains_text("cannot write") && contains_text("goes on"));
  CHECK(farm.files(".unit").empty());
  CHECK(farm.files(".tmp").empty());
  CHECK(farm.work("-q").exit_code == 0);
  CHECK(farm.merge("-q -o many.png").exit_code == 0);
}

TEST_CASE("a full disk leaves whole units only", "[app][job]") {
  Farm const farm;
  fs::path const shared = farm.folder / "shared";
  fs::create_directory(shared);
  if (::mount("none", shared.c_str(), "tmpfs", 0, "size=512k") != 0) SKIP_TEST("only root can mount");
  struct Unmounter {
    fs::path folder;
    ~Unmounter() { ::umount2(folder.c_str(), MNT_DETACH); }
  } const unmounter{shared};
  CHECK(farm.plan("ball.sdf --size 300x300 --tile 100x100").exit_code == 0);  // nine units of 120,000 bytes
  auto const full = farm.work();
  CHECK(full.exit_code == 75);
  CHECK_THAT(full.err, contains_text("the disk is full"));
  auto const status = farm.status();
  CHECK(status["done"] > 0);
  CHECK(status["done"] < 9);
  CHECK(status["cut_short"] == 0);
  CHECK(farm.files(".tmp").empty());
}

TEST_CASE("what cannot be planned or drawn is refused in a sentence", "[app][job]") {
  Farm const farm;
  auto const refused = [&](std::string const& words, int code, std::string const& text) {
    INFO(words);
    auto const result = farm("job " + words);
    INFO(result.err);
    CHECK(result.exit_code == code);
    CHECK_THAT(result.err, contains_text(text));
    CHECK(result.out.empty());
  };
  refused("", 64, "a command is missing");
  refused("pln", 64, "did you mean 'lichtraum job plan'?");
  refused("plan ball.sdf", 64, "-o DIR");
  refused("plan - -o shared", 64, "standard input");
  refused("plan ball.sdf -o a.png", 64, "a plan is a folder, not a picture");
  refused("plan ball.sdf -o a.png", 64, "lichtraum job merge DIR -o a.png");
  refused("plan ball.sdf -o film.mp4", 64, "a plan is a folder, not a picture");
  refused("plan nowhere.sdf -o shared", 66, "nowhere.sdf");
  refused("plan ball.sdf lamp.sdf -o shared --device reference", 64, "one size");
  refused("plan ball.sdf -o shared --samples-per-unit 17", 64, "a multiple of 16");
  // Later samples are kept block by block: 12 bytes for every 16.
  std::string const many_samples =
      "plan ball.sdf -o shared --device reference --size 9000x9000 --tile 8192x8192 --samples 1024x1024 ";
  refused(many_samples + "--samples-per-unit 524288", 64,
          "a unit of 8192x8192 pixels and 524288 samples needs 26.4 TB of memory");
  refused(many_samples + "--samples-per-unit 524288", 64, "and so do fewer --samples-per-unit");
  refused("plan ball.sdf -o shared --size 400000x400000 --tile 400000x400000 --samples 1 --device reference", 64,
          "a unit of 400000x400000 pixels and 1 sample needs 3.84 TB of memory");
  refused("plan ball.sdf -o shared --tile 0x0", 64, "--tile: expected at least 1x1 pixels, not '0x0'");
  refused("plan ball.sdf -o shared --size 100000x100000 --tile 1x1 --device reference", 64, "units");
  CHECK(!fs::exists(farm.folder / "shared"));
  refused("work shared", 66, "has no plan.json");
  refused("merge shared -o a.png", 66, "has no plan.json");
  REQUIRE(farm.plan("ball.sdf").exit_code == 0);
  CHECK(farm.plan("ball.sdf").exit_code == 0);  // the same again is no harm
  refused("plan lamp.sdf -o shared --device reference", 73, "another plan");
  refused("work shared --units 0..1 --device reference", 64, "units 0..0, not 1");
  refused("work shared --units 5..2", 64, "expected the first unit before the last");
  refused("work", 64, "no folder is given");
  refused("work far(2)", 66, "'far(2)' has no plan.json: lichtraum job plan SCENE -o 'far(2)' makes one");
  refused("work ball.sdf", 66, "'ball.sdf' is not a folder: lichtraum job plan ball.sdf -o FOLDER");
  for (std::string const text : {"{}", "[", "{\"lichtraum_plan\": 1}", "{\"lichtraum_plan\": 2}"}) {
    put(farm.folder / "shared/plan.json", text);
    refused("work shared", 65, "plan.json");
    refused("status shared", 65, "plan.json");
  }
}

TEST_CASE("a picture that fits no memory is cut into units that do", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf --size 100000x100000 --tile 64x64").exit_code == 0);
  CHECK(farm.status()["units"] == 1563 * 1563);
  CHECK(fs::file_size(farm.folder / "shared/plan.json") < 5000);
  CHECK(farm.work("-q --units 1221484..1221485").exit_code == 0);
  CHECK(farm.status()["done"] == 2);
  CHECK(farm.status()["missing"].size() == 2);
}

TEST_CASE("scripts for queues draw all units, and no others", "[app][job]") {
  Farm const farm;
  fs::path const odd = farm.folder / "it's here";
  fs::create_directory(odd);
  REQUIRE(farm.plan("ball.sdf --size 50x50 --tile 10x10").exit_code == 0);
  fs::rename(farm.folder / "shared", odd / "shared");
  Process process = farm.process("job script");
  auto const script = [&](std::string const& queue, std::string const& units = "7") {
    Process mine = process;
    mine.arguments.insert(mine.arguments.end(), {queue, (odd / "shared").string(), "--units-per-task", units});
    auto const result = run_process(mine);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return result.out;
  };
  // What runs in the place of lichtraum, parallel and scontrol tells what it was told.
  fs::create_directory(farm.folder / "bin");
  auto const put_program = [&](std::string const& name, std::string const& text) {
    fs::permissions(farm.folder.write("bin/" + name, text), fs::perms::owner_all);
  };
  put_program("lichtraum", "#!/bin/sh\nfor word; do echo \"<$word>\"; done >> \"$LOG\"\nexit ${STATUS:-0}\n");
  put_program(
      "parallel",
      "#!/bin/sh\nwhile read -r unit; do while [ \"$1\" != lichtraum ]; do shift; done; sh -c \"$* $unit\"; done\n");
  put_program("scontrol", "#!/bin/sh\necho \"scontrol $*\" >> \"$LOG\"\n");
  auto const run = [&](std::string const& text, std::map<std::string, std::string> environment) {
    farm.folder.write("script.sh", text);
    Process shell = farm.process("");
    shell.arguments = {"sh", "script.sh"};
    shell.environment = std::move(environment);
    shell.environment["PATH"] = (farm.folder / "bin").string() + ":" + std::getenv("PATH");
    shell.environment["LOG"] = (farm.folder / "log").string();
    std::error_code ignored;
    fs::remove(farm.folder / "log", ignored);
    run_process(shell);
    return farm.folder.read("log");
  };
  auto const words = [&](std::string const& units) {
    return "<job>\n<work>\n<" + (odd / "shared").string() + ">\n<-q>\n<--units>\n<" + units + ">\n";
  };
  std::string const slurm = script("slurm");
  CHECK_THAT(slurm, contains_text("#SBATCH --array=0-3\n"));
  CHECK(run(slurm, {{"SLURM_ARRAY_TASK_ID", "0"}}) == words("0..6"));
  CHECK(run(slurm, {{"SLURM_ARRAY_TASK_ID", "3"}}) == words("21..24"));
  CHECK(run(slurm, {{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_JOB_ID", "5"}, {"STATUS", "75"}}) ==
        words("7..13") + "scontrol requeue 5_1\n");
  std::map<std::string, std::string> task{{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_JOB_ID", "5"}, {"STATUS", "137"}};
  CHECK(run(slurm, task) == words("7..13") + "scontrol requeue 5_1\n");  // the worker was killed
  task["SLURM_RESTART_COUNT"] = "5";
  CHECK(run(slurm, task) == words("7..13"));
  CHECK(run(slurm, {{"SLURM_ARRAY_TASK_ID", "1"}, {"STATUS", "65"}}) == words("7..13"));
  CHECK(run(script("parallel"), {}) == words("0..6") + words("7..13") + words("14..20") + words("21..24"));

  auto const openjd = Json::parse(script("openjd"));
  auto const& step = openjd["steps"][0];
  CHECK(step["parameterSpace"]["taskParameterDefinitions"][0]["range"] ==
        Json::parse(R"(["0..6", "7..13", "14..20", "21..24"])"));
  CHECK(step["script"]["actions"]["onRun"]["args"][2] == (odd / "shared").string());
  CHECK_THAT(script("opencue"),
             contains_text("range=\"0-24\"") && contains_text("chunk=7") && contains_text("it's here/shared\""));
  CHECK_THAT(script("flamenco"), contains_text("default: 25,") && contains_text("default: 7,"));

  Process unknown = process;
  unknown.arguments.insert(unknown.arguments.end(), {"deadline", (odd / "shared").string()});
  CHECK_THAT(run_process(unknown).err, contains_text("there are slurm, openjd"));
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

TEST_CASE("a scene that is changed while units are drawn is noticed", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("lamp.sdf ball.sdf --size 50x37 --integrator path --samples 64 --tile 10x10").exit_code == 0);
  std::atomic<bool> is_over = false;
  std::jthread const editor([&] {  // once the first scene is being drawn, and the second has not been read
    while (!is_over && farm.files(".unit").empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    put(farm.folder / "ball.sdf", std::string(ball_scene) + "define background 0 1 0\n");
  });
  auto const worked = farm.work("--units 0.." + std::to_string(farm.status()["units"].get<int>() - 1));
  is_over = true;
  CHECK(worked.exit_code == 65);
  CHECK_THAT(worked.err, contains_text("ball.sdf' has changed since the plan was made"));
  Json const status = farm.status();
  CHECK(status["done"] == 20);  // those of lamp.sdf, 50x37
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
