#include "cl/tile_tracer.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <span>

#include "cl/error.hpp"
#include "cl/noise_filter.hpp"
#include "cl/opencl_devices.hpp"
#include "cl/program.hpp"
#include "cl/render_program.hpp"
#include "shared/packet.h"

namespace lichtraum {
namespace {

/// The work-items of a launch, in two dimensions.
struct LaunchSize {
  std::size_t width = 0;
  std::size_t height = 0;
};

/// A work-item traces a pixel, or a batch's square of pixels on the picture's grid.
LaunchSize launch_size(device::Tile const& tile, RayGrouping grouping) {
  if (grouping == RayGrouping::one) return {tile.width, tile.height};
  auto const squares = [](std::size_t begin, std::size_t length) {
    return (begin + length + PACKET_SIDE - 1) / PACKET_SIDE - begin / PACKET_SIDE;
  };
  return {squares(tile.x, tile.width), squares(tile.y, tile.height)};
}

std::size_t round_up(std::size_t n, std::size_t multiple) { return (n + multiple - 1) / multiple * multiple; }

cl::Device find_device(DeviceInfo const& wanted) {
  std::vector<std::string> warnings;
  for (OpenClDevice const& found : find_opencl_devices(warnings)) {
    if (found.info.name == wanted.name && found.info.platform == wanted.platform) return found.device;
  }
  throw DeviceError(fmt::format("the device '{}' is no longer available", wanted.name), "clGetDeviceIDs",
                    CL_DEVICE_NOT_FOUND);
}

/// A device buffer over an array of the host.
template <class Array>
cl::Buffer buffer_over(cl::Context const& context, cl_mem_flags flags, Array const& data) {
  using Element = typename Array::value_type;
  // A buffer of no bytes is not allowed; the kernels do not touch it.
  if (data.empty()) return cl::Buffer(context, flags, sizeof(Element));
  return cl::Buffer(context, flags | CL_MEM_USE_HOST_PTR, sizeof(Element) * data.size(),
                    const_cast<Element*>(data.data()));
}

/// What all arrays take there. Throws Error{no_device} where they do not fit.
std::uint64_t bytes_on(DeviceInfo const& device, SceneBuffers const& scene, ShadingTables const& tables) {
  std::uint64_t largest = 0, sum = 0;
  auto const add = [&](auto const& data) {
    std::uint64_t const bytes = data.size() * sizeof(data[0]);
    largest = std::max(largest, bytes);
    sum += bytes;
  };
  for_each_array(scene, add);
  for_each_array(tables, add);
  if (sum <= device.global_memory_bytes && largest <= device.max_allocation_bytes) return sum;
  throw Error(ErrorKind::no_device,
              fmt::format("the scene needs {} bytes on the device, {} of them in one buffer; {} has {} bytes and takes "
                          "at most {} in one buffer. Try another --device, or --device reference.",
                          sum, largest, device.name, device.global_memory_bytes, device.max_allocation_bytes));
}

}  // namespace

struct TileTracer::State {
  DeviceInfo info;
  RayGrouping grouping = RayGrouping::one;
  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;
  struct KnownKernel {
    cl::Kernel kernel;
    bool is_loaded = false;
  };
  std::map<std::string, KnownKernel> kernels;  // by their programs' options; those of develop.cl by their names
  std::optional<NoiseFilter> noise_filter;     // once it is needed

  std::shared_ptr<SceneBuffers const> scene = std::make_shared<SceneBuffers>();
  std::shared_ptr<ShadingTables const> tables = std::make_shared<ShadingTables>();
  bool is_uploaded = false;
  std::uint64_t device_bytes = 0;
  std::vector<cl::Buffer> geometry, shading, environment;  // in the order of the kernel's parameters

  std::vector<device::FrameParameters> frame;
  cl::Buffer frame_buffer;
  struct PlaneBuffer {
    cl::Buffer buffer;
    std::size_t bytes;
  };
  std::vector<PlaneBuffer> film;  // of the planes that are wanted
  PlaneSet planes;
  std::vector<device::WorkItemRays> rays;
  cl::Buffer rays_buffer;
  cl::Kernel kernel;
  cl_uint arguments_before = 0;  // the scene's

  /// A plane of the film that is traced, as a kernel's argument.
  template <class Value>
  void set_plane(cl_uint argument, Resolution const& size, std::span<Value> values) {
    if (values.empty()) {
      kernel.setArg(argument, sizeof(cl_mem), nullptr);
      return;
    }
    if (values.size_bytes() > info.max_allocation_bytes) {
      throw Error(
          ErrorKind::no_device,
          fmt::format("{}x{} pixels need a buffer of {} bytes; {} takes at most {}. Render the picture in parts, "
                      "with --region.",
                      size.width, size.height, values.size_bytes(), info.name, info.max_allocation_bytes));
    }
    film.push_back({cl::Buffer(context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, values.size_bytes(), values.data()),
                    values.size_bytes()});
    kernel.setArg(argument, film.back().buffer);
  }

  RenderProgram program_for(device::FrameParameters const& parameters, Integrator integrator,
                            PlaneSet const& wanted) const {
    // Panes are the paths' business.
    device::uint const features = integrator == Integrator::path ? tables->features : tables->features & ~SCENE_PANES;
    return {grouping,
            wanted != PlaneSet{FilmPlane::radiance},
            (features & ~SCENE_WITHOUT_MODELS) == 0,
            integrator,
            integrator == Integrator::whitted ? ray_stack_size(parameters.max_depth) : ray_stack_size(0),
            traversal_stack_size(scene->stack_size)};
  }

  KnownKernel& kernel_for(RenderProgram const& program) {
    auto const options = program.options();
    auto found = kernels.find(options);
    if (found == kernels.end()) {
      auto const built = build_program(context, device, program.name, options, precompiled_programs());
      found =
          kernels.emplace(options, KnownKernel{checked([&] { return cl::Kernel(built, program.kernel_name); })}).first;
    }
    return found->second;
  }

  /// Once for each kernel; its arguments are set.
  void load(KnownKernel& known) {
    if (known.is_loaded) return;
    make_room_for_rays(1);
    warm_up(queue, kernel, arguments_before, grouping);
    known.is_loaded = true;
  }

  void make_room_for_rays(std::size_t work_items) {
    if (rays.size() < work_items) {
      rays.resize(work_items);
      rays_buffer = buffer_over(context, CL_MEM_WRITE_ONLY, rays);
    }
    kernel.setArg(arguments_before + RenderProgram::rays_argument, rays_buffer);
  }
};

TileTracer::TileTracer(DeviceInfo const& device, RayGrouping grouping) : state_(std::make_unique<State>()) {
  state_->info = device;
  state_->grouping = grouping;
  checked([&] {
    state_->device = find_device(device);
    state_->context = cl::Context(state_->device);
    state_->queue = cl::CommandQueue(state_->context, state_->device);
  });
}

TileTracer::~TileTracer() = default;

void TileTracer::upload(std::shared_ptr<SceneBuffers const> scene, std::shared_ptr<ShadingTables const> tables) {
  bool const has_scene = state_->is_uploaded && scene == state_->scene;
  if (has_scene && tables == state_->tables) return;
  std::uint64_t const device_bytes = bytes_on(state_->info, *scene, *tables);
  state_->is_uploaded = false;
  bool const has_environment = has_scene && tables->environment_table == state_->tables->environment_table;
  // The old ones go when no buffer uses them any longer.
  state_->scene.swap(scene);
  state_->tables.swap(tables);
  state_->device_bytes = device_bytes;
  checked([&] {
    auto const add_to = [&](std::vector<cl::Buffer>& buffers) {
      buffers.clear();
      return [&](auto const& data) { buffers.push_back(buffer_over(state_->context, CL_MEM_READ_ONLY, data)); };
    };
    if (!has_scene) for_each_array(*state_->scene, add_to(state_->geometry));
    device::for_each_array(static_cast<device::ShadingArrays const&>(*state_->tables), add_to(state_->shading));
    auto const& environment = *state_->tables->environment_table;
    if (!has_environment) device::for_each_array(environment, add_to(state_->environment));
  });
  state_->is_uploaded = true;
}

std::uint64_t TileTracer::device_bytes() const { return state_->device_bytes; }

bool TileTracer::needs_compiler(device::FrameParameters const& frame, Integrator integrator,
                                PlaneSet const& planes) const {
  auto const options = state_->program_for(frame, integrator, planes).options();
  return !state_->kernels.contains(options) &&
         lichtraum::needs_compiler(state_->device, RenderProgram::name, options, precompiled_programs());
}

void TileTracer::begin_frame(device::FrameParameters const& frame, Integrator integrator, Film& film) {
  State& state = *state_;
  if (!state.is_uploaded) throw Error(ErrorKind::no_device, "the scene is not on the device, which did not take it");
  PlaneSet const& planes = film.planes();
  state.frame.assign(1, frame);
  checked(state.queue, [&] {
    auto& known = state.kernel_for(state.program_for(frame, integrator, planes));
    state.kernel = known.kernel;
    state.frame_buffer = buffer_over(state.context, CL_MEM_READ_ONLY, state.frame);
    cl_uint argument = 0;
    for (auto const* const buffers : {&state.geometry, &state.shading, &state.environment}) {
      for (cl::Buffer const& buffer : *buffers) state.kernel.setArg(argument++, buffer);
    }
    auto constants = scene_constants(*state.scene, *state.tables);
    bool const is_lit = planes.has(FilmPlane::radiance) || frame.ground != GROUND_NONE;
    if (!is_lit) constants.light_count = constants.light_choice_count = 0;
    state.kernel.setArg(argument++, constants);
    state.arguments_before = argument;
    state.kernel.setArg(argument + RenderProgram::frame_argument, state.frame_buffer);
    state.kernel.setArg(argument + RenderProgram::planes_argument, cl_uint(planes.bits()));
    state.film.clear();
    for (std::size_t i = 0; i < plane_count; ++i) {
      auto const plane = FilmPlane(i);
      auto const film_argument = argument + RenderProgram::film_argument + cl_uint(i);
      if (info_of(plane).is_number) {
        state.set_plane(film_argument, film.size(), film.numbers(plane));
      } else {
        state.set_plane(film_argument, film.size(), film.floats(plane));
      }
    }
    state.load(known);
  });
  state.planes = planes;
}

RayCounts TileTracer::trace(device::Tile const& tile) {
  State& state = *state_;
  LaunchSize const size = launch_size(tile, state.grouping);
  std::size_t const local_side = work_group_side(state.grouping);
  std::size_t const work_items = size.width * size.height;
  RayCounts counts;
  checked(state.queue, [&] {
    state.make_room_for_rays(work_items);
    state.kernel.setArg(state.arguments_before + RenderProgram::tile_argument, tile);
    state.queue.enqueueNDRangeKernel(state.kernel, cl::NullRange,
                                     cl::NDRange(round_up(size.width, local_side), round_up(size.height, local_side)),
                                     cl::NDRange(local_side, local_side));
    std::size_t const bytes = work_items * sizeof(device::WorkItemRays);
    void* const mapped = state.queue.enqueueMapBuffer(state.rays_buffer, CL_TRUE, CL_MAP_READ, 0, bytes);
    auto const* rays = static_cast<device::WorkItemRays const*>(mapped);
    for (std::size_t i = 0; i < work_items; ++i) {
      counts.shadow += rays[i].shadow;
      counts.secondary += rays[i].secondary;
      counts.camera_hits += rays[i].camera_hits;
      counts.not_finite += rays[i].not_finite;
    }
    device::uint const samples = state.planes.has(PlaneRule::mean) ? tile.sample_count : 0;
    bool const has_centers = state.planes.has(PlaneRule::center) && tile.first_sample == 0;
    counts.camera = std::uint64_t(tile.width) * tile.height * (samples + (has_centers ? 1 : 0));
    state.queue.enqueueUnmapMemObject(state.rays_buffer, mapped);
  });
  return counts;
}

void TileTracer::end_frame() {
  State& state = *state_;
  checked(state.queue, [&] {
    for (auto const& [buffer, bytes] : state.film) {
      void* const mapped = state.queue.enqueueMapBuffer(buffer, CL_TRUE, CL_MAP_READ, 0, bytes);
      state.queue.enqueueUnmapMemObject(buffer, mapped);
    }
    state.queue.finish();
    state.film.clear();
  });
}

void TileTracer::develop(std::vector<float>& radiance, std::vector<float> const& alpha,
                         device::DevelopParameters const& parameters) {
  State& state = *state_;
  if (radiance.empty()) return;
  checked(state.queue, [&] {
    auto const name = DevelopProgram::kernel_name(!alpha.empty());
    auto const known = state.kernels.find(name);
    cl::Kernel kernel = known != state.kernels.end()
                            ? known->second.kernel
                            : cl::Kernel(build_program(state.context, state.device, DevelopProgram::name,
                                                       DevelopProgram::options, precompiled_programs()),
                                         name);
    state.kernels.insert_or_assign(name, State::KnownKernel{kernel, true});
    cl::Buffer const sums = buffer_over(state.context, CL_MEM_READ_WRITE, radiance);
    kernel.setArg(0, parameters);
    std::size_t const pixel_count = radiance.size() / 3;
    kernel.setArg(1, cl_ulong(pixel_count));
    kernel.setArg(2, sums);
    cl::Buffer alpha_sums;
    if (!alpha.empty()) {
      alpha_sums = buffer_over(state.context, CL_MEM_READ_ONLY, alpha);
      kernel.setArg(3, alpha_sums);
    }
    constexpr std::size_t group = DevelopProgram::work_group_size;
    state.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(round_up(pixel_count, group)),
                                     cl::NDRange(group));
    std::size_t const bytes = radiance.size() * sizeof(float);
    void* const mapped = state.queue.enqueueMapBuffer(sums, CL_TRUE, CL_MAP_READ, 0, bytes);
    state.queue.enqueueUnmapMemObject(sums, mapped);
    state.queue.finish();
  });
}

void TileTracer::filter_noise(NoisePlanes& planes) {
  State& state = *state_;
  if (!state.noise_filter) {
    int const lanes = state.grouping == RayGrouping::one ? 1 : 16;
    checked(state.queue, [&] {
      state.noise_filter.emplace(state.context,
                                 build_program(state.context, state.device, DenoiseProgram::name,
                                               DenoiseProgram::options(lanes), precompiled_programs()),
                                 lanes);
    });
  }
  state.noise_filter->run(state.queue, planes);
}

}  // namespace lichtraum
