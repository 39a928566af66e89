#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "cl/render_program.hpp"
#include "lichtraum.hpp"
#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// Pictures have the same bytes on every processor. PoCL compiles for one of a few classes of x86 processors, which
// POCL_KERNELLIB_NAME chooses (pocl_get_distro_kernellib_name in its lib/CL/pocl_llvm_utils.cc): vectors of four to
// sixteen numbers, fma as an instruction or as a function. So one machine stands for its ancestors.

using namespace lichtraum;
namespace fs = std::filesystem;

namespace {

struct ProcessorClass {
  std::string name;
  std::vector<std::string> flags;  ///< what /proc/cpuinfo says of a processor that can run it
};

std::vector<ProcessorClass> const classes{
    {"sse2", {"sse2"}}, {"sse41", {"sse4_1"}}, {"avx2", {"avx2", "fma", "f16c", "bmi2"}}, {"avx512", {"avx512f"}}};

bool is_supported(ProcessorClass const& wanted) {
  std::ifstream in("/proc/cpuinfo");
  std::string line;
  while (std::getline(in, line) && !line.starts_with("flags")) {
  }
  line += " ";
  return std::all_of(wanted.flags.begin(), wanted.flags.end(),
                     [&](std::string const& flag) { return line.find(" " + flag + " ") != std::string::npos; });
}

bool has_pocl() {
  auto const devices = find_devices().devices;
  return std::any_of(devices.begin(), devices.end(), [](DeviceInfo const& device) {
    return device.kind == DeviceKind::cpu && device.platform == "Portable Computing Language";
  });
}

/// Of a folder and those below it: the files with that extension, by name.
using Files = std::map<std::string, std::string>;
Files files_in(fs::path const& folder, std::string const& extension) {
  Files files;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != extension) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()].assign(std::istreambuf_iterator<char>(in), {});
  }
  return files;
}

/// Eight of the gallery's models, as words of a command line.
std::string gallery_models(fs::path const& folder) {
  Process make{{"python3", project_path("tools/make_models"), folder.string(), "knot", "gears", "fence", "jug",
                "window", "materials", "glasses", "globe"}};
  make.timeout_seconds = 120;
  REQUIRE(run_process(make).exit_code == 0);
  std::string words;
  for (auto const& entry : fs::directory_iterator(folder)) words += " " + entry.path().string();
  return words;
}

std::string scenes() {
  std::string words;
  for (auto const& entry : fs::recursive_directory_iterator(project_path("scenes"))) {
    if (entry.path().extension() == ".sdf") words += " " + entry.path().string();
  }
  return words;
}

/// What a run left behind: pictures, and the machine code that PoCL made for it.
struct Run {
  Files pictures;
  Files machine_code;
};

/// `processors`: a class. In a process and with a cache of its own.
Run draw(Lichtraum const& lichtraum, std::string const& words, std::string const& extension,
         std::string const& processors) {
  TemporaryFolder const pictures, cache;
  Process process = lichtraum.process("render -q --device cpu --output-dir " + pictures.path().string() + words);
  process.environment["POCL_CACHE_DIR"] = cache.path().string();
  process.environment["POCL_KERNELLIB_NAME"] = processors;
  process.timeout_seconds = 300;
  ProcessResult const result = run_process(process);
  INFO(processors << words << ": " << result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err == "");  // the compiler's warnings are none of the user's business
  return {files_in(pictures.path(), extension), files_in(cache.path(), ".so")};
}

/// The names of those whose bytes differ, or which only one has.
std::string differing_names(Files const& a, Files const& b) {
  std::string names;
  for (auto const& [name, bytes] : a) {
    if (!b.contains(name) || b.at(name) != bytes) names += " " + name;
  }
  return a.size() == b.size() ? names : names + " (not as many)";
}

/// All scenes and some models on one layout: the same pictures for each class that this processor can stand for, but
/// the one that is `left_out`.
void check_classes(std::string const& options, std::string const& extension, std::string const& left_out = "") {
  if (!has_pocl()) SKIP_TEST("PoCL is not installed, or does not work");
  if (!is_installed("python3")) SKIP_TEST("python3, which makes the models, is not installed");
  Lichtraum const lichtraum;
  std::string const inputs = scenes() + gallery_models(lichtraum.folder / "models");
  REQUIRE(std::count(inputs.begin(), inputs.end(), ' ') >= 20);
  std::string const words = " --size 64x48 --samples 2x2 " + options + " -o %04d" + extension + inputs;
  std::vector<Run> runs;
  for (ProcessorClass const& processors : classes) {
    if (processors.name == left_out || !is_supported(processors)) continue;  // the latter is said by the test below
    Run run = draw(lichtraum, words, extension, processors.name);
    INFO(processors.name);
    CHECK(run.pictures.size() >= 20);
    // Else PoCL was built for one class only, or heeds another variable, and nothing was tried.
    CHECK(!run.machine_code.empty());
    for (Run const& other : runs) {
      CHECK(run.machine_code != other.machine_code);
      CHECK(differing_names(other.pictures, run.pictures) == "");
    }
    runs.push_back(std::move(run));
  }
  if (runs.size() < 2) SKIP_TEST("this processor stands for one class only");
}

}  // namespace

// Programs take minutes to compile for each class. So paths are in the first two of these only, as are scenes deeper
// than 7, which need programs of their own; and for sse41 PoCL makes nearly the same of those as for sse2: vectors of
// four, without fma.
TEST_CASE("radiance has the same bytes for each class of processors", "[app][long]") {
  check_classes("--traversal packet", ".pfm", "sse41");
}

TEST_CASE("radiance has the same bytes for each class of processors, sse41 too", "[app][long][classes][.]") {
  check_classes("--traversal packet", ".pfm");
}

TEST_CASE("pictures in sRGB have the same bytes for each class of processors", "[app][long]") {
  check_classes("--integrator whitted --depth 7 --traversal wide --tonemap reinhard --transfer srgb --bits 16", ".png");
}

TEST_CASE("depth has the same bytes for each class of processors", "[app][long]") {
  check_classes("--integrator whitted --depth 7 --traversal scalar --planes depth", ".png");
}

TEST_CASE("kernels are compiled for each class of processors that a package is for, once", "[app][long]") {
  if (!has_pocl()) SKIP_TEST("PoCL is not installed, or does not work");
  if (!fs::exists(LICHTRAUM_BUILD_DIR "/src/precompile_kernels")) SKIP_TEST("this build compiles no kernels");
  TemporaryFolder const folder;
  std::size_t const count = std::size(usual_render_programs) + 2, develop = count - 1;  // the quickest to compile
  Process script{{LICHTRAUM_CMAKE, "-D", "OUTPUT=" + (folder / "part.inc").string(), "-D",
                  "PROGRAM=" LICHTRAUM_BUILD_DIR "/src/precompile_kernels", "-D", "CLASSES=ssse3,sse41,ssse3", "-D",
                  fmt::format("NUMBER={}", develop), "-D", fmt::format("COUNT={}", count), "-P",
                  project_path("tools/precompile_kernels.cmake")}};
  script.timeout_seconds = 300;
  ProcessResult const result = run_process(script);
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  std::string const rows = files_in(folder.path(), ".inc").at("part.inc");
  for (std::string const processor : {"core2", "penryn"}) {  // as LLVM names these classes
    INFO(processor);
    std::string const target = "-" + processor + "; ";
    std::size_t const row = rows.find(target);
    REQUIRE(row != std::string::npos);
    CHECK(rows.find(target, row + 1) == std::string::npos);
  }
}

TEST_CASE("this processor stands for every class", "[app][long]") {
  std::string missing;
  for (ProcessorClass const& processors : classes) {
    if (!is_supported(processors)) missing += " " + processors.name;
  }
  if (!missing.empty()) SKIP_TEST("it does not for" + missing);
}
