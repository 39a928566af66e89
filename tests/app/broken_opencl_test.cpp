#include <unistd.h>

#include "lichtraum.hpp"
#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// What OpenCL can do to a program, and that this one survives it.

namespace {

/// The program where the only OpenCL platform aborts its process.
ProcessResult with_aborting_platform(Lichtraum const& lichtraum, std::string const& words) {
  lichtraum.folder.write("aborting.icd", LICHTRAUM_ABORTING_PLATFORM "\n");
  Process process = lichtraum.process(words);
  process.environment = {{"OCL_ICD_VENDORS", (lichtraum.folder / "aborting.icd").string()}};
  return run_process(process);
}

}  // namespace

TEST_CASE("a platform that aborts does not take devices and doctor with it", "[app][devices]") {
  Lichtraum const lichtraum;
  auto const devices = with_aborting_platform(lichtraum, "devices");
  CHECK(devices.exit_code == 0);
  CHECK(devices.signal == 0);
  CHECK_THAT(devices.out, contains_text("reference"));
  CHECK_THAT(devices.err, contains_text("signal 6") && contains_text("This platform does not want to live."));
  auto const doctor = with_aborting_platform(lichtraum, "doctor");
  CHECK(doctor.exit_code == 69);
  CHECK_THAT(doctor.err, contains_text("This platform does not want to live."));
}

TEST_CASE("where PoCL would abort for want of /sys, render says so and falls back", "[app][devices]") {
  Lichtraum const lichtraum;
  Process hidden;
  hidden.arguments = {"unshare", "--mount", "sh", "-c", "mount -t tmpfs none /sys && exec \"$@\"", "sh", "true"};
  if (run_process(hidden).exit_code != 0) SKIP_TEST("only root may hide /sys from a process");

  lichtraum.folder.write("a.sdf", ball_scene);
  Process const render = lichtraum.process("render a.sdf");
  hidden.arguments.pop_back();
  hidden.arguments.insert(hidden.arguments.end(), render.arguments.begin(), render.arguments.end());
  hidden.folder = render.folder;
  auto const result = run_process(hidden);
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err, contains_text("child process") && contains_text("reference tracer"));
  CHECK(std::filesystem::exists(lichtraum.folder / "ball.ppm"));
}

TEST_CASE("70: a kernel that does not compile is a fault of ours, with the compiler's words", "[app][exit]") {
  Lichtraum const lichtraum;
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("render.cl", "__kernel void render_tile(void) { undeclared_function_of_ours(); }\n");
  Process process = lichtraum.process("render a.sdf");
  process.environment = {{"LICHTRAUM_KERNEL_DIR", lichtraum.folder.path().string()}};
  auto const result = run_process(process);
  CHECK(result.exit_code == 70);
  CHECK_THAT(result.err,
             contains_text("this is a fault in lichtraum: ") && contains_text("undeclared_function_of_ours"));
  CHECK_THAT(result.err, contains_text("\n  command: lichtraum render a.sdf\n"));
  CHECK_THAT(result.err, contains_text("\n  version: lichtraum ") && contains_text("\n  Please report it, "));
  CHECK(!std::filesystem::exists(lichtraum.folder / "ball.ppm"));
}

TEST_CASE("69: a PoCL that would abort for want of a linker is told of, with what to install", "[app][exit][devices]") {
  Lichtraum const lichtraum;
  auto const devices = lichtraum::find_devices().devices;
  if (devices.front().platform_version.find("PoCL ") == std::string::npos) SKIP_TEST("PoCL is not installed");
  if (devices.front().platform_version.find("PoCL 7.") != std::string::npos) SKIP_TEST("PoCL 7 may need no linker");
  lichtraum.folder.write("a.sdf", ball_scene);
  Process process = lichtraum.process("render a.sdf");
  // Nothing was compiled before, and the program's own machine code is left out.
  process.environment = {{"PATH", lichtraum.folder.path().string()},
                         {"POCL_CACHE_DIR", lichtraum.folder.path().string()},
                         {"LICHTRAUM_KERNEL_DIR", project_path("kernels")}};
  auto const result = run_process(process);
  CHECK(result.signal == 0);
  CHECK(result.exit_code == 69);
  CHECK_THAT(result.err, contains_text("binutils") && contains_text("--device reference"));
  CHECK(!std::filesystem::exists(lichtraum.folder / "ball.ppm"));
}

TEST_CASE("compiled programs go to a folder of the user's in the temporary directory where HOME cannot be written",
          "[app][devices]") {
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  std::filesystem::path const temporary = lichtraum.folder / "tmp";
  std::filesystem::create_directory(temporary);
  // Not even root can make folders in /proc.
  std::map<std::string, std::string> const unwritable{
      {"HOME", "/proc/nobody"}, {"XDG_CACHE_HOME", ""}, {"POCL_CACHE_DIR", ""}};
  Process process = lichtraum.process("render a.sdf -q --json");
  process.environment = unwritable;
  process.environment["TMPDIR"] = temporary.string();
  auto const drawn = [&] {
    auto const result = run_process(process);
    INFO(result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, !contains_text("\"kind\": \"reference\""));
  };
  drawn();
  std::filesystem::path const cache = temporary / ("lichtraum-" + std::to_string(geteuid()));
  CHECK(std::filesystem::status(cache).permissions() == std::filesystem::perms::owner_all);

  SECTION("a home that is missing altogether") {
    for (auto& [name, value] : process.environment) value = name == "TMPDIR" ? value : "";
    drawn();
  }
  SECTION("no folder at all: the reason is told as it is") {
    // Somebody else could have made it: it is not used.
    std::filesystem::permissions(cache, std::filesystem::perms::all);
    process.arguments = lichtraum.process("render a.sdf").arguments;
    auto const result = run_process(process);
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, contains_text("/proc/nobody/.cache/pocl/kcache") && contains_text(cache.string()) &&
                               contains_text("set POCL_CACHE_DIR"));
    CHECK_THAT(result.err, !contains_text("pocl-opencl-icd"));
  }
}
