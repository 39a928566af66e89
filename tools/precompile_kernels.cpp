// precompile_kernels OUTPUT NUMBER COUNT: compiles the device programs that most pictures take, for each OpenCL device
// that is a processor of this machine, and of these each COUNTth from number NUMBER on; appends the rows of them that
// the table in src/cl/precompiled_programs.cpp.in includes to OUTPUT. Nothing for a device whose target has rows there.
//
// Part of the build, so it needs little of the library. Run by tools/precompile_kernels.cmake, as PoCL may abort it.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "cl/machine_code_target.hpp"
#include "cl/noise_filter.hpp"
#include "cl/opencl_devices.hpp"
#include "cl/program.hpp"
#include "cl/render_program.hpp"
#include "shared/develop.h"
#include "shared/scene_arrays.h"

using namespace lichtraum;

namespace {

/// A launch makes the code for work-groups of this size, which PoCL adds to the program's binary.
std::vector<unsigned char> compile(cl::Device const& device, RenderProgram const& wanted) {
  cl::Context const context(device);
  cl::CommandQueue const queue(context, device);
  auto const program = build_program(context, device, wanted.name, wanted.options(), {});
  cl::Kernel kernel(program, wanted.kernel_name);
  cl::Buffer const anything(context, CL_MEM_READ_WRITE, 4096);
  cl_uint const scene_arguments = kernel.getInfo<CL_KERNEL_NUM_ARGS>() - RenderProgram::own_arguments;
  for (cl_uint i = 0; i + 1 < scene_arguments; ++i) kernel.setArg(i, anything);
  kernel.setArg(scene_arguments - 1, device::SceneConstants());
  for (cl_uint i = 0; i < RenderProgram::film_arrays; ++i) {
    kernel.setArg(scene_arguments + RenderProgram::film_argument + i, anything);
  }
  kernel.setArg(scene_arguments + RenderProgram::planes_argument, cl_uint(0));
  for (cl_uint const i : {RenderProgram::frame_argument, RenderProgram::rays_argument}) {
    kernel.setArg(scene_arguments + i, anything);
  }
  warm_up(queue, kernel, scene_arguments, wanted.grouping);
  return program.getInfo<CL_PROGRAM_BINARIES>().at(0);
}

std::vector<unsigned char> compile_develop(cl::Device const& device) {
  cl::Context const context(device);
  cl::CommandQueue const queue(context, device);
  auto const program = build_program(context, device, DevelopProgram::name, DevelopProgram::options, {});
  cl::Buffer const anything(context, CL_MEM_READ_WRITE, 4096);
  for (bool const has_alpha : {false, true}) {
    cl::Kernel kernel(program, DevelopProgram::kernel_name(has_alpha));
    kernel.setArg(0, device::DevelopParameters());
    kernel.setArg(1, cl_ulong(0));
    for (cl_uint i = 2; i < (has_alpha ? 4u : 3u); ++i) kernel.setArg(i, anything);
    // PoCL makes code of its own for grids of fewer than 2^16 work-items.
    for (std::size_t const work_items : {std::size_t(64), std::size_t(1) << 17}) {
      queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(work_items),
                                 cl::NDRange(DevelopProgram::work_group_size));
      queue.finish();
    }
  }
  return program.getInfo<CL_PROGRAM_BINARIES>().at(0);
}

std::vector<unsigned char> compile_denoise(cl::Device const& device, int lanes) {
  cl::Context const context(device);
  auto const program = build_program(context, device, DenoiseProgram::name, DenoiseProgram::options(lanes), {});
  NoiseFilter(context, program, lanes).warm_up(cl::CommandQueue(context, device));
  return program.getInfo<CL_PROGRAM_BINARIES>().at(0);
}

/// As the value of a string_view; octal escapes end after three digits.
std::string literal(std::string_view bytes) {
  std::string text;
  text.reserve(4 * bytes.size());
  for (char const byte : bytes) {
    bool const is_verbatim = byte >= ' ' && byte <= '~' && byte != '"' && byte != '\\' && byte != '?';
    text += is_verbatim ? std::string(1, byte) : fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
  }
  return fmt::format("{{\"{}\", {}}}", text, bytes.size());
}

}  // namespace

int main(int argument_count, char** arguments) try {
  if (argument_count != 4) return 64;
  std::size_t const number = std::stoul(arguments[2]), part_count = std::stoul(arguments[3]);
  std::ifstream in(arguments[1]);
  std::string const before(std::istreambuf_iterator<char>(in), {});
  bool is_found = false;
  std::string table;
  std::vector<std::string> warnings;
  for (OpenClDevice const& found : find_opencl_devices(warnings)) {
    if (found.info.kind != DeviceKind::cpu) continue;  // drivers of other devices keep compiled programs themselves
    is_found = true;
    std::string const target = literal(machine_code_target(found.device));
    if (before.find(target) != std::string::npos) continue;
    std::size_t counted = 0;
    auto const add = [&](std::string_view name, std::string_view options, auto const& compile_program) {
      if (counted++ % part_count != number - 1) return;
      std::vector<unsigned char> const binary = compile_program();
      table += fmt::format("    {{{}, {},\n     {},\n     {}}},\n", literal(name), literal(options), target,
                           literal({reinterpret_cast<char const*>(binary.data()), binary.size()}));
    };
    for (RenderProgram const& program : usual_render_programs) {
      add(program.name, program.options(), [&] { return compile(found.device, program); });
    }
    add(DevelopProgram::name, DevelopProgram::options, [&] { return compile_develop(found.device); });
    add(DenoiseProgram::name, DenoiseProgram::options(16), [&] { return compile_denoise(found.device, 16); });
  }
  if (!is_found) return 69;
  std::ofstream out(arguments[1], std::ios::app);
  out << table;
  return out.flush() ? 0 : 74;
} catch (std::exception const& error) {
  std::fputs(fmt::format("precompile_kernels: {}\n", error.what()).c_str(), stderr);
  return 70;
}
