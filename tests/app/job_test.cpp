#include <signal.h>
#include <sys/mount.h>

#include <atomic>
#include <thread>

#include "farm.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

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

TEST_CASE("each of as many units as a plan may have can be asked for", "[app][job]") {
  Farm const farm;
  REQUIRE(farm.plan("ball.sdf --size 10000x9999 --tile 1x1").exit_code == 0);
  CHECK(farm.work("-q --units 99989999").exit_code == 0);
  CHECK(farm.status()["done"] == 1);
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
