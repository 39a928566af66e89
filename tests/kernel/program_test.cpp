#include "cl/program.hpp"

#include <algorithm>
#include <random>

#include "cl/machine_code_target.hpp"
#include "cl/opencl_devices.hpp"
#include "cl/render_program.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;

namespace {

std::optional<OpenClDevice> find_test_device() {
  std::vector<std::string> warnings;
  for (OpenClDevice const& found : find_opencl_devices(warnings)) {
    if (found.info.name == test::test_device_name()) return found;
  }
  return std::nullopt;
}

bool is_from_source(cl::Program const& program) { return !program.getInfo<CL_PROGRAM_SOURCE>().empty(); }

std::string random_bytes(std::size_t count) {
  std::mt19937 generator(1);
  std::string bytes(count, 0);
  for (char& byte : bytes) byte = char(generator());
  return bytes;
}

}  // namespace

TEST_CASE("a compiled program is taken where it fits, else the source", "[kernel][program]") {
  NEEDS_OPENCL_DEVICE();
  cl::Device const device = find_test_device().value().device;
  cl::Context const context(device);
  RenderProgram const wanted{.grouping = RayGrouping::one, .without_models = true};
  auto const options = wanted.options();
  auto const build = [&](std::vector<PrecompiledProgram> const& table) {
    return build_program(context, device, wanted.name, options, table);
  };

  auto const compiled = build({});
  CHECK(is_from_source(compiled));
  auto const binaries = compiled.getInfo<CL_PROGRAM_BINARIES>();
  std::string_view const binary(reinterpret_cast<char const*>(binaries.at(0).data()), binaries.at(0).size());
  auto const target = machine_code_target(device);
  PrecompiledProgram const fitting{wanted.name, options, target, binary};

  auto const loaded = build({{wanted.name, "-D OTHER", target, binary}, fitting});
  CHECK_FALSE(is_from_source(loaded));
  CHECK(cl::Kernel(loaded, wanted.kernel_name).getInfo<CL_KERNEL_NUM_ARGS>() ==
        cl::Kernel(compiled, wanted.kernel_name).getInfo<CL_KERNEL_NUM_ARGS>());

  CHECK(is_from_source(build({{"other", options, target, binary}})));
  CHECK(is_from_source(build({{wanted.name, options + " -D OTHER", target, binary}})));
  CHECK(is_from_source(build({{wanted.name, options, target + " avx9000", binary}})));
  std::string const refused = random_bytes(100);
  CHECK(is_from_source(build({{wanted.name, options, target, refused}})));
}

TEST_CASE("what was compiled with lichtraum fits the device that it was compiled for", "[kernel][program]") {
  NEEDS_OPENCL_DEVICE();
  auto const programs = precompiled_programs();
  if (programs.empty()) SKIP_TEST("no programs were compiled with this build");
  auto const found = find_test_device().value();
  bool const is_their_platform = programs[0].target.starts_with(found.info.platform);
  if (!is_their_platform) SKIP_TEST("they are for another OpenCL platform");
  cl::Context const context(found.device);
  for (RenderProgram const& usual : usual_render_programs) {
    CHECK_FALSE(is_from_source(build_program(context, found.device, usual.name, usual.options(), programs)));
  }
  CHECK_FALSE(is_from_source(
      build_program(context, found.device, DenoiseProgram::name, DenoiseProgram::options(16), programs)));
}
