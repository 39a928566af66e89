#include "lights/light_visibility.clh"
#include "one_ray.clh"
#include "scene_arguments.clh"
#include "surface/leave_surface.clh"

/* The surface that each ray hits first. */
__kernel void probe_find_surface(SCENE_PARAMETERS, __global ProbeRay const* rays, __global Hit* hits,
                                 __global float4* position_offset, __global float4* normals) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  Ray const ray = load_ray(rays[i]);
  RayBatch batch;
  HitBatch found;
  trace_one_ray(&scene, ray, &batch, &found);
  Hit const hit = hit_of(&found, 0u);
  hits[i] = hit;
  position_offset[i] = (float4)(0.f);
  normals[i] = (float4)(0.f);
  if (hit.kind != NO_PRIMITIVE) {
    HitPrimitives primitives;
    fetch_primitives(&scene, &found, 0u, &primitives);
    Surface const surface = find_surface(&scene, &primitives, ray.origin, ray.direction, hit.t);
    position_offset[i] = (float4)(surface.position, surface.offset);
    normals[i] = (float4)(surface.normal, 0.f);
  }
}

/* Rays that leave a surface. */
__kernel void probe_leave_surface(SCENE_PARAMETERS, __global float4 const* position_offset,
                                  __global float4 const* normals, __global float4 const* directions,
                                  __global Hit* hits) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  Ray const ray = leave_surface(position_offset[i].xyz, normals[i].xyz, position_offset[i].w, directions[i].xyz);
  hits[i] = trace_closest(&scene, ray, INFINITY);
}

__kernel void probe_light_visibility(SCENE_PARAMETERS, __global float4 const* position_offset,
                                     __global float4 const* normals, __global PunctualLight const* probed_lights,
                                     __global float* visibility) {
  size_t const i = get_global_id(0);
  Scene const scene = SCENE_FROM_PARAMETERS;
  ShadingPoint point;
  point.position = position_offset[i].xyz;
  point.geometric_normal = normals[i].xyz;
  point.offset = position_offset[i].w;
  PunctualLight const light = probed_lights[i];
  Real3 const to_light = sample_light(&light, point.position).to_light;
  Mask const lit = lane_mask(true);
  Real3 const start = add_scaled(point.position, point.offset, point.geometric_normal);
  Real seen;
  trace_light_visibility(&scene, &light, &point, &start, &to_light, &lit, 1u, false, &seen);
  visibility[i] = seen;
}
