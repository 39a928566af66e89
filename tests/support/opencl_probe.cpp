#include "support/opencl_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "cl/opencl.hpp"
#include "cl/program.hpp"
#include "support/project_files.hpp"

namespace lichtraum::test {
namespace {

struct Device {
  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;
};

std::optional<cl::Device> choose_device() {
  char const* const wanted = std::getenv("LICHTRAUM_TEST_DEVICE");
  std::vector<cl::Device> found;
  try {
    std::vector<cl::Platform> platforms;
    cl::Platform::get(&platforms);
    for (auto const& platform : platforms) {
      std::vector<cl::Device> devices;
      try {
        platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
      } catch (cl::Error const&) {
      }
      found.insert(found.end(), devices.begin(), devices.end());
    }
  } catch (cl::Error const&) {  // no platform at all
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    bool const chosen =
        wanted != nullptr && *wanted != '\0'
            ? std::to_string(i) == wanted || found[i].getInfo<CL_DEVICE_NAME>().find(wanted) != std::string::npos
            : (found[i].getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
    if (chosen) return found[i];
  }
  return std::nullopt;
}

/// One device, context and queue for the whole test program. Never destroyed: OpenCL libraries have static objects of
/// their own, which may be gone by then.
std::optional<Device> const& test_device() {
  static auto const* const device = [] {
    auto const chosen = choose_device();
    if (!chosen) return new std::optional<Device>();
    cl::Context const context(*chosen);
    return new std::optional<Device>(Device{*chosen, context, cl::CommandQueue(context, *chosen)});
  }();
  return *device;
}

std::string describe(cl::Error const& error) { return fmt::format("{}: OpenCL error {}", error.what(), error.err()); }

cl::Buffer make_buffer(cl::Context const& context, ProbeArgument const& argument) {
  bool const initialised = argument.kind != ProbeArgument::Kind::output && argument.bytes > 0;
  cl_mem_flags const flags = CL_MEM_READ_WRITE | (initialised ? CL_MEM_COPY_HOST_PTR : 0);
  return cl::Buffer(context, flags, std::max<std::size_t>(argument.bytes, 1), initialised ? argument.data : nullptr);
}

}  // namespace

std::optional<std::string> test_device_name() {
  if (!test_device()) return std::nullopt;
  return test_device()->device.getInfo<CL_DEVICE_NAME>();
}

std::size_t scaled_count(std::size_t full) {
  char const* const scale = std::getenv("LICHTRAUM_TEST_SCALE");
  if (scale == nullptr) return full;
  return std::max<std::size_t>(1, std::size_t(double(full) * std::atof(scale)));
}

std::size_t quickest_lanes() {
  return test_device().value().device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU ? 16 : 1;
}

struct ProbeProgram::State {
  cl::Program program;
};

ProbeProgram::ProbeProgram(std::string const& file, std::string const& options) : state_(std::make_unique<State>()) {
  char const* const changed_kernels = std::getenv("LICHTRAUM_KERNEL_DIR");
  std::string const kernel_dir = changed_kernels ? changed_kernels : project_path("kernels");
  std::ifstream stream((file == "render.cl" ? kernel_dir : project_path("tests/kernel")) + "/" + file);
  if (!stream) throw std::runtime_error("cannot read " + file);
  std::string const source{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  Device const& device = test_device().value();
  cl::Program program(device.context, source);
  try {
    program.build({device.device}, ("-cl-std=CL1.2 -I " + kernel_dir + " -I " + project_path("tests/kernel") + " " +
                                    options + exact_rounding_option(device.device))
                                       .c_str());
  } catch (cl::Error const& error) {
    throw std::runtime_error(file + ": " + describe(error) + "\n" +
                             program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device));
  }
  auto const log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device);
  if (log.find("warning:") != std::string::npos) throw std::runtime_error(file + ":\n" + log);
  state_->program = program;
}

ProbeProgram::~ProbeProgram() = default;

void ProbeProgram::run(std::string const& kernel_name, std::size_t width, std::vector<ProbeArgument> const& arguments,
                       std::size_t height, std::size_t local_width, std::size_t local_height) const {
  Device const& device = test_device().value();
  try {
    cl::Kernel kernel(state_->program, kernel_name.c_str());
    std::vector<cl::Buffer> buffers(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (arguments[i].kind == ProbeArgument::Kind::value) {
        kernel.setArg(cl_uint(i), arguments[i].bytes, arguments[i].data);
      } else {
        buffers[i] = make_buffer(device.context, arguments[i]);
        kernel.setArg(cl_uint(i), buffers[i]);
      }
    }
    auto const round_up = [](std::size_t n, std::size_t step) { return (n + step - 1) / step * step; };
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange,
                                      cl::NDRange(round_up(width, local_width), round_up(height, local_height)),
                                      cl::NDRange(local_width, local_height));
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      bool const written =
          arguments[i].kind == ProbeArgument::Kind::output || arguments[i].kind == ProbeArgument::Kind::updated;
      if (written && arguments[i].bytes > 0) {
        device.queue.enqueueReadBuffer(buffers[i], CL_TRUE, 0, arguments[i].bytes, arguments[i].data);
      }
    }
    device.queue.finish();
  } catch (cl::Error const& error) {
    throw std::runtime_error(kernel_name + ": " + describe(error));
  }
}

}  // namespace lichtraum::test
