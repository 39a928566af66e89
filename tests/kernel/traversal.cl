#include "scene_arguments.clh"
#include "traversal/binary.clh"

__kernel void probe_enter_bounds(__global BvhChild const* children, __global ProbeRay const* rays,
                                 __global float const* t_max, __global float* t) {
  size_t const i = get_global_id(0);
  Ray const ray = load_ray(rays[i]);
  t[i] = enter_bounds(children + i, ray.origin, 1.f / ray.direction, t_max[i]);
}

__kernel void probe_trace_closest(SCENE_PARAMETERS, __global ProbeRay const* rays, __global float const* t_max,
                                  __global Hit* hits) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  hits[i] = trace_closest(&scene, load_ray(rays[i]), t_max[i]);
}

__kernel void probe_trace_any(SCENE_PARAMETERS, __global ProbeRay const* rays, __global float const* t_max,
                              __global uint* found) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  found[i] = trace_any(&scene, load_ray(rays[i]), t_max[i]) ? 1u : 0u;
}

__kernel void probe_trace_visibility(SCENE_PARAMETERS, __global ProbeRay const* rays, __global float const* t_max,
                                     __global float* visibility) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  visibility[i] = trace_visibility(&scene, load_ray(rays[i]), t_max[i]).x;
}
