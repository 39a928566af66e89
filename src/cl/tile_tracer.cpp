#include "cl/tile_tracer.hpp"

#include <fmt/format.h>

#include <map>
#include <span>

#include "cl/error.hpp"
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

/// A work-item traces a pixel, or a packet's square of pixels on the picture's grid.
LaunchSize launch_size(device::Tile const& tile, Traversal traversal) {
  if (traversal != Traversal::packet) return {tile.width, tile.height};
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
  throw DeviceError(fmt::format("the device '{}' is not there any more", wanted.name), "clGetDeviceIDs",
                    CL_DEVICE_NOT_FOUND);
}

/// A device buffer over a vector of the host.
template <class T>
class HostBuffer {
 public:
  void create(cl::Context const& context, cl_mem_flags flags, std::span<T const> data) {
    // A buffer of no bytes is not allowed; the kernels do not touch it.
    if (data.empty()) {
      buffer_ = cl::Buffer(context, flags, sizeof(T));
      return;
    }
    buffer_ = cl::Buffer(context, flags | CL_MEM_USE_HOST_PTR, sizeof(T) * data.size(), const_cast<T*>(data.data()));
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
  struct KnownKernel {
    cl::Kernel kernel;
    bool is_loaded = false;
  };
  std::map<std::string, KnownKernel> kernels;  // by their programs' options

  std::shared_ptr<SceneBuffers const> scene = std::make_shared<SceneBuffers>();
  std::shared_ptr<ShadingTables const> tables = scene;
  bool is_uploaded = false;
  std::uint64_t device_bytes = 0;
  HostBuffer<device::BvhNode> nodes;
  HostBuffer<device::PrimitiveReference> references;
  HostBuffer<device::TrianglePrimitive> triangles;
  HostBuffer<device::SpherePrimitive> spheres;
  HostBuffer<device::SphereBlock> sphere_blocks;
  HostBuffer<device::EllipsoidPrimitive> ellipsoids;
  HostBuffer<device::BoxPrimitive> boxes;
  HostBuffer<device::Instance> instances;
  HostBuffer<device::WideNode> wide_nodes;
  HostBuffer<device::TriangleBlock> triangle_blocks;
  HostBuffer<device::PrimitiveTag> triangle_tags;
  HostBuffer<device::PhongMaterial> materials;
  HostBuffer<device::PunctualLight> lights;
  HostBuffer<device::PbrMaterial> pbr_materials;
  HostBuffer<device::Texture> textures;
  HostBuffer<device::uint> texels;
  HostBuffer<device::TriangleAttributes> triangle_attributes;
  HostBuffer<float> vertex_data;

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
    if (scene->traversal == Traversal::scalar) {
      f(scene->nodes, nodes);
      f(scene->references, references);
      f(scene->triangles, triangles);
      f(scene->spheres, spheres);
    } else {
      f(scene->wide_nodes, wide_nodes);
      f(scene->triangle_blocks, triangle_blocks);
      f(scene->triangle_tags, triangle_tags);
      f(scene->sphere_blocks, sphere_blocks);
    }
    f(scene->ellipsoids, ellipsoids);
    f(scene->boxes, boxes);
    f(scene->instances, instances);
    for_each_table(f);
    f(scene->textures, textures);
    f(scene->texels, texels);
    f(scene->triangle_attributes, triangle_attributes);
    f(scene->vertex_data, vertex_data);
  }

  template <class F>
  void for_each_table(F&& f) {
    f(tables->materials, materials);
    f(tables->lights, lights);
    f(tables->pbr_materials, pbr_materials);
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

  /// How the frame is traced: the first surface is looked for ray by ray.
  Traversal frame_traversal() const {
    return frame[0].aov != 0 && scene->traversal == Traversal::packet ? Traversal::wide : scene->traversal;
  }

  KnownKernel& kernel_for(device::FrameParameters const& parameters) {
    RenderProgram const program{frame_traversal(), parameters.aov != 0, (tables->features & ~SCENE_PLAIN) == 0,
                                ray_stack_size(parameters.max_depth), traversal_stack_size(scene->stack_size)};
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
    launch_on_nothing(queue, kernel, frame_traversal());
    known.is_loaded = true;
  }

  void make_room_for_rays(std::size_t work_items) {
    if (rays.size() < work_items) {
      rays.resize(work_items);
      rays_buffer.create(context, CL_MEM_WRITE_ONLY, rays);
    }
    kernel.setArg(RenderProgram::rays_argument, rays_buffer.get());
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

void TileTracer::upload(std::shared_ptr<SceneBuffers const> scene, std::shared_ptr<ShadingTables const> tables) {
  bool const has_scene = state_->is_uploaded && scene == state_->scene;
  if (has_scene && tables == state_->tables) return;
  auto const create = [&](auto const& data, auto& buffer) { buffer.create(state_->context, CL_MEM_READ_ONLY, data); };
  state_->is_uploaded = false;
  state_->scene = std::move(scene);
  state_->tables.swap(tables);  // the old ones go when no buffer is over them any more
  state_->check_size();
  checked([&] { has_scene ? state_->for_each_table(create) : state_->for_each_array(create); });
  state_->is_uploaded = true;
}

SceneBuffers const& TileTracer::scene() const { return *state_->scene; }
ShadingTables const& TileTracer::tables() const { return *state_->tables; }
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
    auto& known = state.kernel_for(frame);
    state.kernel = known.kernel;
    state.frame_buffer.create(state.context, CL_MEM_READ_ONLY, state.frame);
    state.film = cl::Buffer(state.context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, film_bytes, image.data().data());
    cl_uint argument = 0;
    state.kernel.setArg(argument++, state.frame_buffer.get());
    ++argument;  // the tile
    state.for_each_array([&](auto const&, auto const& buffer) { state.kernel.setArg(argument++, buffer.get()); });
    state.kernel.setArg(argument++, state.film);
    state.load(known);
  });
}

RayCounts TileTracer::trace(device::Tile const& tile) {
  State& state = *state_;
  LaunchSize const size = launch_size(tile, state.frame_traversal());
  std::size_t const local_side = work_group_side(state.frame_traversal());
  std::size_t const work_items = size.width * size.height;
  RayCounts counts;
  checked([&] {
    state.make_room_for_rays(work_items);
    state.kernel.setArg(RenderProgram::tile_argument, sizeof tile, &tile);
    state.queue.enqueueNDRangeKernel(state.kernel, cl::NullRange,
                                     cl::NDRange(round_up(size.width, local_side), round_up(size.height, local_side)),
                                     cl::NDRange(local_side, local_side));
    std::size_t const bytes = work_items * sizeof(device::WorkItemRays);
    void* const mapped = state.queue.enqueueMapBuffer(state.rays_buffer.get(), CL_TRUE, CL_MAP_READ, 0, bytes);
    auto const* rays = static_cast<device::WorkItemRays const*>(mapped);
    for (std::size_t i = 0; i < work_items; ++i) {
      counts.shadow += rays[i].shadow;
      counts.secondary += rays[i].secondary;
      counts.camera_hits += rays[i].camera_hits;
    }
    counts.camera = std::uint64_t(tile.width) * tile.height * tile.sample_count;
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
