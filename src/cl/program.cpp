#include "cl/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "cl/embedded_kernels.hpp"
#include "cl/error.hpp"
#include "cl/machine_code_target.hpp"
#include "cl/pocl_linker.hpp"

namespace lichtraum {
namespace {

std::string read_source(std::filesystem::path const& path) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorKind::no_input, fmt::format("cannot read the kernel file {}", path.string()));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string embedded_source(std::string_view name) {
  for (EmbeddedKernel const& kernel : embedded_kernels()) {
    if (kernel.name == name) return std::string(kernel.source);
  }
  throw Error(ErrorKind::internal, fmt::format("no device program is called '{}'", name));
}

/// A folder of kernels that counts instead of what is in the library, or null.
char const* kernel_folder() { return std::getenv("LICHTRAUM_KERNEL_DIR"); }

/// Null where none fits.
PrecompiledProgram const* find_precompiled(cl::Device const& device, std::string_view name, std::string const& options,
                                           std::span<PrecompiledProgram const> precompiled) {
  auto const is_wanted = [&](PrecompiledProgram const& program) {
    return program.name == name && program.options == options && program.target == machine_code_target(device);
  };
  auto const found = std::find_if(precompiled.begin(), precompiled.end(), is_wanted);
  return found == precompiled.end() ? nullptr : &*found;
}

std::optional<cl::Program> load_precompiled(cl::Context const& context, cl::Device const& device, std::string_view name,
                                            std::string const& options,
                                            std::span<PrecompiledProgram const> precompiled) {
  auto const* const found = find_precompiled(device, name, options, precompiled);
  if (!found) return std::nullopt;
  try {
    cl::Program const program(context, {device}, {{found->binary.begin(), found->binary.end()}});
    program.build(device, options.c_str());
    return program;
  } catch (cl::Error const&) {
    return std::nullopt;  // the source serves every device
  }
}

cl::Program build_from_source(cl::Context const& context, cl::Device const& device, std::string_view name,
                              std::string const& source, std::string const& options) {
  check_pocl_linker(device);
  cl::Program program(context, source);
  try {
    program.build(device, (options + exact_rounding_option(device)).c_str());
  } catch (cl::Error const& error) {
    if (error.err() != CL_BUILD_PROGRAM_FAILURE) throw;
    throw Error(ErrorKind::internal, fmt::format("the device's compiler refuses {}.cl:\n{}", name,
                                                 program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device)));
  }
  return program;
}

}  // namespace

std::string exact_rounding_option(cl::Device const& device) {
  bool const is_known = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT;
  return is_known ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
}

bool needs_compiler(cl::Device const& device, std::string_view name, std::string const& options,
                    std::span<PrecompiledProgram const> precompiled) {
  return kernel_folder() || !checked([&] { return find_precompiled(device, name, options, precompiled); });
}

cl::Program build_program(cl::Context const& context, cl::Device const& device, std::string_view name,
                          std::string const& options, std::span<PrecompiledProgram const> precompiled) {
  return checked([&] {
    if (char const* const folder = kernel_folder()) {
      auto const source = read_source(std::filesystem::path(folder) / fmt::format("{}.cl", name));
      return build_from_source(context, device, name, source, options + fmt::format(" -I {}", folder));
    }
    if (auto program = load_precompiled(context, device, name, options, precompiled)) return *program;
    return build_from_source(context, device, name, embedded_source(name), options);
  });
}

}  // namespace lichtraum
