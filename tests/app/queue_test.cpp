#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

// What `job script` prints, run by the real thing. Slurm is tests/farm/one_node_slurm.

namespace {

/// A plan of 16 units, and the picture that they have to give.
struct Plan : Lichtraum {
  Plan() {
    folder.write("ball.sdf", ball_scene);
    REQUIRE(render("ball.sdf -q --size 64x48 -o one.png").exit_code == 0);
    REQUIRE((*this)("job plan ball.sdf -q --device reference --size 64x48 --tile 16x12 -o shared").exit_code == 0);
    // Tasks find the program by its name, and draw without OpenCL.
    std::filesystem::create_directory(folder / "bin");
    auto const program =
        folder.write("bin/lichtraum", "#!/bin/sh\nexec " LICHTRAUM_PROGRAM " \"$@\" --device reference\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }

  /// Runs the words in the plan's folder; says what `program` has to say when it fails.
  void run(std::vector<std::string> const& words) const {
    Process process;
    process.arguments = words;
    process.folder = folder.path();
    process.environment = {{"PATH", (folder / "bin").string() + ":" + std::getenv("PATH")},
                           {"HOME", folder.path().string()}};
    process.timeout_seconds = 600;
    auto const result = run_process(process);
    INFO(words.front());
    INFO(result.out + result.err);
    REQUIRE(result.exit_code == 0);
  }

  void script(std::string const& queue, std::string const& file) const {
    auto const result = (*this)("job script " + queue + " shared");
    REQUIRE(result.exit_code == 0);
    folder.write(file, result.out);
  }

  void check_picture() const {
    CHECK_THAT((*this)("job status shared").out, contains_text("16 of 16 units done"));
    REQUIRE((*this)("job merge shared -q -o many.png").exit_code == 0);
    CHECK(folder.read("many.png") == folder.read("one.png"));
  }
};

/// moreutils has another program of the same name.
bool is_gnu_parallel() {
  Process process;
  process.arguments = {"parallel", "--version"};
  return is_installed("parallel") && run_process(process).out.rfind("GNU parallel", 0) == 0;
}

}  // namespace

TEST_CASE("GNU parallel draws a plan of 16 units", "[app][job][queue]") {
  if (!is_gnu_parallel()) SKIP_TEST("GNU parallel is not installed");
  Plan const plan;
  plan.script("parallel", "work.sh");
  plan.run({"sh", "work.sh", "-j", "2"});
  plan.check_picture();
}

TEST_CASE("openjd run draws a plan of 16 units", "[app][job][queue]") {
  if (!is_installed("openjd")) SKIP_TEST("openjd is not installed (pip install openjd-cli)");
  Plan const plan;
  plan.script("openjd", "work.json");
  plan.run({"openjd", "check", "work.json"});
  plan.run({"openjd", "run", "work.json", "--step", "work"});
  plan.check_picture();
}
