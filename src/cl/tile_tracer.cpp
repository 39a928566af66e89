#include "cl/tile_tracer.hpp"

#include <fmt/format.h>

#include <map>

#include "cl/error.hpp"
#include "cl/opencl_devices.hpp"
#include "cl/program.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t local_width = 8;
constexpr std::size_t local_height = 8;

std::size_t round_up(std::size_t n, std::size_t multiple) { return (n + multiple - 1) / multiple * multiple; }

/// The entries of the ray stack that a depth needs, as one of a few sizes: each is a program of its own.
unsigned ray_stack_size(device::uint max_depth) {
  for (unsigned const size : {8u, 64u, 1024u}) {
    if (max_depth < size) return size;
  }
  throw Error(ErrorKind::usage, fmt::format("a depth of {} is too large: mirror and glass rays can be followed to a "
                                            "depth of 1023 on this device",
                                            max_depth));
}

cl::Device find_device(DeviceInfo const& wanted) {
  std::vector<std::string> warnings;
  for (OpenClDevice const& found : find_opencl_devices(warnings)) {
    if (found.info.name == wanted.name && found.info.platform == wanted.platform) return found.device;
  }
  throw DeviceError(fmt::format("the device '{}' is not there any more", wanted.name), "clGetDeviceIDs",
                    CL_DEVICE_NOT_FOUND);
}

/// A device buffer over a vector of the host.
template <class T>
class HostBuffer {
 public:
  void create(cl::Context const& context, cl_mem_flags flags, std::vector<T>& data) {
    // A buffer of no bytes is not allowed; the kernels do not read it.
    if (data.empty()) data.emplace_back();
    buffer_ = cl::Buffer(context, flags | CL_MEM_USE_HOST_PTR, sizeof(T) * data.size(), data.data());
  }
  cl::Buffer const& get() const { return buffer_; }

 private:
  cl::Buffer buffer_;
};

}  // namespace

struct TileTracer::State {
  DeviceInfo info;
  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;
  std::map<unsigned, cl::Kernel> kernels;  // by the size of the ray stack

  SceneBuffers scene;
  std::uint64_t device_bytes = 0;
  HostBuffer<device::BvhNode> nodes;
  HostBuffer<device::PrimitiveReference> references;
  HostBuffer<device::TrianglePrimitive> triangles;
  HostBuffer<device::SpherePrimitive> spheres;
  HostBuffer<device::EllipsoidPrimitive> ellipsoids;
  HostBuffer<device::BoxPrimitive> boxes;
  HostBuffer<device::Instance> instances;
  HostBuffer<device::PhongMaterial> materials;
  HostBuffer<device::PointLight> lights;

  std::vector<device::FrameParameters> frame;
  HostBuffer<device::FrameParameters> frame_buffer;
  Image* image = nullptr;
  cl::Buffer film;
  std::vector<device::WorkItemRays> rays;
  HostBuffer<device::WorkItemRays> rays_buffer;
  cl::Kernel kernel;

  /// Calls f(vector, buffer) for each array of the scene, in the order of the kernel's arguments.
  template <class F>
  void for_each_array(F&& f) {
    f(scene.nodes, nodes);
    f(scene.references, references);
    f(scene.triangles, triangles);
    f(scene.spheres, spheres);
    f(scene.ellipsoids, ellipsoids);
    f(scene.boxes, boxes);
    f(scene.instances, instances);
    f(scene.materials, materials);
    f(scene.lights, lights);
  }

  void check_size() {
    std::uint64_t largest = 0;
    device_bytes = 0;
    for_each_array([&](auto const& data, auto&) {
      std::uint64_t const bytes = data.size() * sizeof(data[0]);
      largest = std::max(largest, bytes);
      device_bytes += bytes;
    });
    if (device_bytes <= info.global_memory_bytes && largest <= info.max_allocation_bytes) return;
    throw Error(
        ErrorKind::no_device,
        fmt::format("the scene needs {} bytes on the device, {} of them in one buffer; {} has {} bytes and takes "
                    "at most {} in one buffer. Try another --device, or --device reference.",
                    device_bytes, largest, info.name, info.global_memory_bytes, info.max_allocation_bytes));
  }

  cl::Kernel& kernel_for(device::uint max_depth) {
    unsigned const size = ray_stack_size(max_depth);
    auto found = kernels.find(size);
    if (found == kernels.end()) {
      auto const program =
          build_program(context, device, "render", fmt::format("-cl-std=CL1.2 -D RAY_STACK_SIZE={}", size));
      found = kernels.emplace(size, checked([&] { return cl::Kernel(program, "render_tile"); })).first;
    }
    return found->second;
  }
};

TileTracer::TileTracer(DeviceInfo const& device) : state_(std::make_unique<State>()) {
  state_->info = device;
  checked([&] {
    state_->device = find_device(device);
    state_->context = cl::Context(state_->device);
    state_->queue = cl::CommandQueue(state_->context, state_->device);
  });
}

TileTracer::~TileTracer() = default;

void TileTracer::upload(SceneBuffers scene) {
  state_->scene = std::move(scene);
  state_->check_size();
  checked([&] {
    state_->for_each_array([&](auto& data, auto& buffer) { buffer.create(state_->context, CL_MEM_READ_ONLY, data); });
  });
}

SceneBuffers const& TileTracer::scene() const { return state_->scene; }
std::uint64_t TileTracer::device_bytes() const { return state_->device_bytes; }

void TileTracer::begin_frame(device::FrameParameters const& frame, Image& image) {
  State& state = *state_;
  std::uint64_t const film_bytes = image.data().size() * sizeof(float);
  if (film_bytes > state.info.max_allocation_bytes) {
    throw Error(ErrorKind::no_device,
                fmt::format("a picture of {}x{} pixels needs a buffer of {} bytes; {} takes at most {}", image.width(),
                            image.height(), film_bytes, state.info.name, state.info.max_allocation_bytes));
  }
  state.frame.assign(1, frame);
  state.image = &image;
  checked([&] {
    state.kernel = state.kernel_for(frame.max_depth);
    state.frame_buffer.create(state.context, CL_MEM_READ_ONLY, state.frame);
    state.film = cl::Buffer(state.context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, film_bytes, image.data().data());
    cl_uint argument = 0;
    state.kernel.setArg(argument++, state.frame_buffer.get());
    ++argument;  // the tile
    state.for_each_array([&](auto const&, auto const& buffer) { state.kernel.setArg(argument++, buffer.get()); });
    state.kernel.setArg(argument++, state.film);
  });
}

RayCounts TileTracer::trace(device::Tile const& tile) {
  State& state = *state_;
  constexpr cl_uint tile_argument = 1, rays_argument = 12;
  std::size_t const pixels = std::size_t(tile.width) * tile.height;
  RayCounts counts;
  checked([&] {
    if (state.rays.size() < pixels) {
      state.rays.resize(pixels);
      state.rays_buffer.create(state.context, CL_MEM_WRITE_ONLY, state.rays);
    }
    state.kernel.setArg(rays_argument, state.rays_buffer.get());
    state.kernel.setArg(tile_argument, sizeof tile, &tile);
    state.queue.enqueueNDRangeKernel(
        state.kernel, cl::NullRange,
        cl::NDRange(round_up(tile.width, local_width), round_up(tile.height, local_height)),
        cl::NDRange(local_width, local_height));
    std::size_t const bytes = pixels * sizeof(device::WorkItemRays);
    void* const mapped = state.queue.enqueueMapBuffer(state.rays_buffer.get(), CL_TRUE, CL_MAP_READ, 0, bytes);
    auto const* rays = static_cast<device::WorkItemRays const*>(mapped);
    for (std::size_t i = 0; i < pixels; ++i) {
      counts.shadow += rays[i].shadow;
      counts.secondary += rays[i].secondary;
      counts.camera_hits += rays[i].camera_hits;
    }
    counts.camera = pixels * tile.sample_count;
    state.queue.enqueueUnmapMemObject(state.rays_buffer.get(), mapped);
  });
  return counts;
}

void TileTracer::end_frame() {
  State& state = *state_;
  checked([&] {
    std::size_t const bytes = state.image->data().size() * sizeof(float);
    void* const mapped = state.queue.enqueueMapBuffer(state.film, CL_TRUE, CL_MAP_READ, 0, bytes);
    state.queue.enqueueUnmapMemObject(state.film, mapped);
    state.queue.finish();
    state.film = cl::Buffer();
  });
}

}  // namespace lichtraum
