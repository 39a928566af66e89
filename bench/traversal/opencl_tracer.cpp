#include "opencl_tracer.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "cl/opencl.hpp"
#include "cl/render_program.hpp"
#include "shared/packet.h"

namespace lichtraum::bench {
namespace {

std::string read(char const* path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(fmt::format("cannot read {}", path));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

cl::Device first_cpu() {
  std::vector<cl::Platform> platforms;
  cl::Platform::get(&platforms);
  for (cl::Platform const& platform : platforms) {
    std::vector<cl::Device> devices;
    platform.getDevices(CL_DEVICE_TYPE_CPU, &devices);
    if (!devices.empty()) return devices.front();
  }
  throw std::runtime_error("no OpenCL CPU device");
}

std::size_t round_up(std::size_t n, std::size_t step) { return (n + step - 1) / step * step; }

}  // namespace

struct OpenClTracer::State {
  cl::Device device = first_cpu();
  cl::Context context{device};
  cl::CommandQueue queue{context, device};
  Traversal layout;
  cl::Kernel primary, shadow, closest, any_hit;
  std::vector<cl::Buffer> scene;
  device::SceneConstants constants{};

  template <class T, class Allocator>
  cl::Buffer over(std::vector<T, Allocator> const& data) {
    if (data.empty()) return cl::Buffer(context, CL_MEM_READ_ONLY, 64);
    return cl::Buffer(context, CL_MEM_USE_HOST_PTR, sizeof(T) * data.size(), const_cast<T*>(data.data()));
  }
  cl_uint set_scene(cl::Kernel& kernel) {
    cl_uint argument = 0;
    for (cl::Buffer const& buffer : scene) kernel.setArg(argument++, buffer);
    kernel.setArg(argument++, constants);
    return argument;
  }
  /// A launch and what it wrote made visible.
  void run(cl::Kernel const& kernel, cl::NDRange const& global, cl::NDRange const& local, cl::Buffer const& out,
           std::size_t bytes) {
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, global, local);
    void* const mapped = queue.enqueueMapBuffer(out, CL_TRUE, CL_MAP_READ, 0, bytes);
    queue.enqueueUnmapMemObject(out, mapped);
    queue.finish();
  }
};

OpenClTracer::OpenClTracer(SceneBuffers& scene, Traversal layout) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.layout = layout;
  s.constants = scene_constants(scene, scene.shading);
  auto const add = [&](auto const& array) { s.scene.push_back(s.over(array)); };
  for_each_array(scene, add);
  for_each_array(scene.shading, add);
  cl::Program program(s.context, read(LICHTRAUM_BENCH_KERNEL));
  RenderProgram const like_paths{.grouping = layout.grouping,
                                 .has_all_planes = true,
                                 .integrator = Integrator::path,
                                 .traversal_stack_size = round_up(std::max<std::size_t>(scene.stack_size, 1), 96)};
  char const* const other_kernels = std::getenv("LICHTRAUM_KERNEL_DIR");  // as the program has it
  std::string const options =
      fmt::format("{} -D FREE_RAYS_PER_ITEM={} -I {}", like_paths.options(), FreeRays::rays_per_item,
                  other_kernels ? other_kernels : LICHTRAUM_KERNEL_FOLDER);
  try {
    program.build(s.device, options.c_str());
  } catch (cl::Error const&) {
    throw std::runtime_error(program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(s.device));
  }
  s.primary = cl::Kernel(program, "primary");
  s.shadow = cl::Kernel(program, "shadow");
  s.closest = cl::Kernel(program, "closest");
  s.any_hit = cl::Kernel(program, "any_hit");
}

OpenClTracer::~OpenClTracer() = default;

void OpenClTracer::closest(PrimaryRays const& rays, std::vector<RayHit>& hits) const {
  State& s = *state_;
  std::vector<device::ProjectiveCamera> const camera{rays.camera};
  cl::Buffer const camera_buffer = s.over(camera), out = s.over(hits);
  cl_uint argument = s.set_scene(s.primary);
  s.primary.setArg(argument++, camera_buffer);
  s.primary.setArg(argument++, cl_uint(rays.width));
  s.primary.setArg(argument++, rays.pixels_per_ray);
  s.primary.setArg(argument++, out);
  std::size_t const side = s.layout.grouping == RayGrouping::packet ? PACKET_SIDE : 1;
  std::size_t const local = 8 / (side > 2 ? 2 : 1);
  s.run(s.primary, cl::NDRange(rays.width / side, rays.height / side), cl::NDRange(local, local), out,
        sizeof(RayHit) * hits.size());
}

void OpenClTracer::any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded) const {
  State& s = *state_;
  cl::Buffer const points = s.over(rays.points), out = s.over(occluded);
  cl_uint argument = s.set_scene(s.shadow);
  s.shadow.setArg(argument++, points);
  s.shadow.setArg(argument++, rays.light);
  s.shadow.setArg(argument++, cl_uint(rays.width));
  s.shadow.setArg(argument++, out);
  std::size_t const side = s.layout.grouping == RayGrouping::packet ? PACKET_SIDE : 1;
  std::size_t const local = 8 / (side > 2 ? 2 : 1);
  s.run(s.shadow, cl::NDRange(rays.width / side, rays.height / side), cl::NDRange(local, local), out, occluded.size());
}

void OpenClTracer::closest(FreeRays const& rays, std::vector<RayHit>& hits) const {
  State& s = *state_;
  cl::Buffer const origins = s.over(rays.origins), directions = s.over(rays.directions), out = s.over(hits);
  cl_uint argument = s.set_scene(s.closest);
  s.closest.setArg(argument++, origins);
  s.closest.setArg(argument++, directions);
  s.closest.setArg(argument++, out);
  s.run(s.closest, cl::NDRange(rays.size() / FreeRays::rays_per_item), cl::NDRange(1), out,
        sizeof(RayHit) * hits.size());
}

void OpenClTracer::any(FreeRays const& rays, std::vector<std::uint8_t>& occluded) const {
  State& s = *state_;
  cl::Buffer const origins = s.over(rays.origins), directions = s.over(rays.directions), out = s.over(occluded);
  cl_uint argument = s.set_scene(s.any_hit);
  s.any_hit.setArg(argument++, origins);
  s.any_hit.setArg(argument++, directions);
  s.any_hit.setArg(argument++, rays.t_max);
  s.any_hit.setArg(argument++, out);
  s.run(s.any_hit, cl::NDRange(rays.size() / FreeRays::rays_per_item), cl::NDRange(1), out, occluded.size());
}

}  // namespace lichtraum::bench
