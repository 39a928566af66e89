#include "cl/program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cl/embedded_kernels.hpp"
#include "cl/error.hpp"

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

}  // namespace

cl::Program build_program(cl::Context const& context, cl::Device const& device, std::string_view name,
                          std::string options) {
  std::string source;
  if (char const* folder = std::getenv("LICHTRAUM_KERNEL_DIR")) {
    source = read_source(std::filesystem::path(folder) / fmt::format("{}.cl", name));
    options += fmt::format(" -I {}", folder);
  } else {
    source = embedded_source(name);
  }
  return checked([&] {
    cl::Program program(context, source);
    try {
      program.build(device, options.c_str());
    } catch (cl::Error const& error) {
      if (error.err() != CL_BUILD_PROGRAM_FAILURE) throw;
      throw Error(ErrorKind::internal, fmt::format("the device's compiler refuses {}.cl:\n{}", name,
                                                   program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device)));
    }
    return program;
  });
}

}  // namespace lichtraum
