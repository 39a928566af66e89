#include "cl/noise_filter.hpp"

#include <utility>

#include "cl/error.hpp"
#include "cl/render_program.hpp"

namespace lichtraum {
namespace {

/// Sets all of a kernel's arguments.
template <class... Arguments>
void set_arguments(cl::Kernel& kernel, Arguments const&... arguments) {
  cl_uint i = 0;
  (kernel.setArg(i++, arguments), ...);
}

}  // namespace

NoiseFilter::NoiseFilter(cl::Context const& context, cl::Program const& program, int lanes)
    : context_(context),
      lanes_(lanes),
      variance_(program, "denoise_variance"),
      luminance_(program, "denoise_luminance"),
      level_(program, "denoise_level") {}

void NoiseFilter::run(cl::CommandQueue const& queue, NoisePlanes& planes) {
  checked(queue, [&] {
    auto const buffer = [&](std::vector<float>& values) {
      return cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, values.size() * sizeof(float),
                        values.data());
    };
    auto const& layout = planes.layout;
    auto const group = DenoiseProgram::work_group_size(lanes_);
    auto const up = [](std::size_t n, std::size_t multiple) { return (n + multiple - 1) / multiple * multiple; };
    cl::NDRange const size(up(up(layout.width, std::size_t(lanes_)) / std::size_t(lanes_), group),
                           up(layout.height, group));
    auto const launch = [&](cl::Kernel const& kernel) {
      queue.enqueueNDRangeKernel(kernel, cl::NullRange, size, cl::NDRange(group, group));
    };
    cl::Buffer const guides = buffer(planes.guides), luminance = buffer(planes.luminance);
    cl::Buffer light = buffer(planes.light), filtered = buffer(planes.filtered);
    set_arguments(variance_, layout, guides, light);
    launch(variance_);
    for (int level = 0; level < int(NOISE_FILTER_LEVELS); ++level) {
      cl_int const step = 1 << level;
      set_arguments(luminance_, layout, step, guides, light, luminance);
      launch(luminance_);
      set_arguments(level_, layout, step, guides, light, luminance, filtered);
      launch(level_);
      std::swap(light, filtered);
      planes.light.swap(planes.filtered);
    }
    void* const mapped = queue.enqueueMapBuffer(light, CL_TRUE, CL_MAP_READ, 0, planes.light.size() * sizeof(float));
    queue.enqueueUnmapMemObject(light, mapped);
    queue.finish();
  });
}

void NoiseFilter::warm_up(cl::CommandQueue const& queue) {
  device::NoiseFilterLayout const nothing{};
  cl::Buffer const any(context_, CL_MEM_READ_WRITE, sizeof(float));
  set_arguments(variance_, nothing, any, any);
  set_arguments(luminance_, nothing, cl_int(1), any, any, any);
  set_arguments(level_, nothing, cl_int(1), any, any, any, any);
  auto const group = DenoiseProgram::work_group_size(lanes_);
  for (std::size_t const rows : {group, std::size_t(1) << 17}) {
    for (cl::Kernel const& kernel : {variance_, luminance_, level_}) {
      queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(group, rows), cl::NDRange(group, group));
    }
  }
  queue.finish();
}

}  // namespace lichtraum
