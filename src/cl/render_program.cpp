#include "cl/render_program.hpp"

#include <fmt/format.h>

#include "lichtraum/error.hpp"
#include "shared/frame.h"
#include "shared/scene_arrays.h"

namespace lichtraum {
namespace {

std::string_view grouping_options(RayGrouping grouping) {
  switch (grouping) {
    case RayGrouping::one:
      return "";
    case RayGrouping::stream:
      return " -D LAYOUT_WIDE";
    case RayGrouping::packet:
      return " -D LAYOUT_WIDE -D TRACE_PACKETS";
  }
  return {};
}

std::string_view function_name(Integrator integrator) {
#define TRACE_FUNCTION(name) "trace_" #name,
  constexpr std::string_view names[] = {INTEGRATORS(TRACE_FUNCTION)};
#undef TRACE_FUNCTION
  return names[std::size_t(integrator)];
}

}  // namespace

std::string RenderProgram::options() const {
  std::string text = fmt::format("-cl-std=CL1.2 -D INTEGRATE={} -D RAY_STACK_SIZE={}{}", function_name(integrator),
                                 ray_stack_size, grouping_options(grouping));
  if (integrator == Integrator::path) text += " -D LIGHT_PASSES_GLASS=0 -D HIDES_BACKS=1";
  if (!has_all_planes) text += fmt::format(" -D POSSIBLE_PLANES={}", PLANE_RADIANCE);
  if (grouping != RayGrouping::one) text += fmt::format(" -D TRAVERSAL_STACK_SIZE={}", traversal_stack_size);
  if (without_models) text += fmt::format(" -D POSSIBLE_FEATURES={}", SCENE_WITHOUT_MODELS);
  return text;
}

unsigned ray_stack_size(unsigned max_depth) {
  for (unsigned const size : {8u, 64u, 1024u}) {
    if (max_depth < size) return size;
  }
  throw Error(ErrorKind::usage, fmt::format("a depth of {} is too large: mirror and glass rays can be followed to a "
                                            "depth of 1023 on this device",
                                            max_depth));
}

std::size_t traversal_stack_size(std::size_t needed) {
  for (std::size_t const size : {std::size_t(96), std::size_t(256)}) {
    if (needed <= size) return size;
  }
  return 2 * WIDE_STACK_SIZE;  // no two levels need more
}

void warm_up(cl::CommandQueue const& queue, cl::Kernel& kernel, cl_uint scene_arguments, RayGrouping grouping) {
  device::Tile const nothing{};
  kernel.setArg(scene_arguments + RenderProgram::tile_argument, nothing);
  cl::NDRange const one_group(work_group_side(grouping), work_group_side(grouping));
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, one_group, one_group);
  queue.finish();
}

}  // namespace lichtraum
