#pragma once

#include <string>

#include "cl/opencl.hpp"
#include "lichtraum/renderer.hpp"
#include "shared/film.h"

namespace lichtraum {

/// One of the ways in which kernels/render.cl is compiled.
struct RenderProgram {
  static constexpr char const* name = "render";
  static constexpr char const* kernel_name = "render_tile";
  /// Counted from the first after the scene's. The film's come first: an array a plane, then which are wanted.
#define COUNT_PLANE(type, name, bit, channels) +1
  static constexpr cl_uint film_argument = 0, film_arrays = 0 FILM_PLANES(COUNT_PLANE);
#undef COUNT_PLANE
  static constexpr cl_uint planes_argument = film_arrays, frame_argument = film_arrays + 1,
                           tile_argument = film_arrays + 2, rays_argument = film_arrays + 3;
  static constexpr cl_uint own_arguments = film_arrays + 4;

  RayGrouping grouping = RayGrouping::packet;
  bool has_all_planes = false;  ///< else radiance alone
  bool without_models = false;  ///< for scenes without what only models have: SCENE_WITHOUT_MODELS
  Integrator integrator = Integrator::whitted;
  unsigned ray_stack_size = 8;
  std::size_t traversal_stack_size = 96;

  /// For clBuildProgram. Two programs are the same when these are.
  std::string options() const;
};

/// Those that are compiled with lichtraum: of pictures, and of all planes (which the window asks for, too), for scenes
/// without models and for all; of paths all planes, as denoising takes some of them; with the layout and the limits
/// that they have unless asked otherwise.
inline constexpr RenderProgram usual_render_programs[] = {
    {.has_all_planes = false, .without_models = true},
    {.has_all_planes = false, .without_models = false},
    {.has_all_planes = true, .without_models = true},
    {.has_all_planes = true, .without_models = false},
    {.has_all_planes = true, .without_models = true, .integrator = Integrator::path},
    {.has_all_planes = true, .without_models = false, .integrator = Integrator::path},
};

/// kernels/develop.cl.
struct DevelopProgram {
  static constexpr char const* name = "develop";
  static constexpr char const* options = "-cl-std=CL1.2";
  static constexpr std::size_t work_group_size = 64;
  static constexpr char const* kernel_name(bool has_alpha) { return has_alpha ? "develop_straight_colors" : "develop"; }
};

/// kernels/denoise.cl.
struct DenoiseProgram {
  static constexpr char const* name = "denoise";
  /// `lanes`: pixels of a work-item.
  static constexpr char const* options(int lanes) {
    return lanes == 16 ? "-cl-std=CL1.2 -D LANES=16" : "-cl-std=CL1.2";
  }
  /// Along each of two axes.
  static constexpr std::size_t work_group_size(int lanes) { return lanes == 16 ? 1 : 8; }
};

/// The entries of the ray stack that a depth needs, as one of a few sizes: each is a program of its own.
/// Throws Error{usage} when there is no such size.
unsigned ray_stack_size(unsigned max_depth);

/// A traversal's stack, as one of a few sizes.
std::size_t traversal_stack_size(std::size_t needed);

/// Along each of two axes. A square of pixels has much memory of its own: a group of one lets the next work-item find
/// it in the cache.
constexpr std::size_t work_group_side(RayGrouping grouping) { return grouping == RayGrouping::one ? 8 : 1; }

/// Launches the kernel for a tile of no pixels, and waits. PoCL loads a kernel's machine code, or makes it, when it is
/// first launched. All arguments but the tile must be set; `scene_arguments` come first.
void warm_up(cl::CommandQueue const& queue, cl::Kernel& kernel, cl_uint scene_arguments, RayGrouping grouping);

}  // namespace lichtraum
