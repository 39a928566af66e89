#include "shading/direct_light.clh"
#include "traversal/traversal.clh"

/* What shading sees of the point that each ray hits first; `coefficients`: ka and m, kd and reflect, ks and transmit,
 * emission and ior. w of a position: t, INFINITY without hit; of a normal: 1 on the outer side; of a shading normal: 1
 * when it differs. */
__kernel void probe_points(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                           __global float4* positions, __global float4* normals, __global float4* shading_normals,
                           __global float4* coefficients) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Ray const ray = make_ray(origins[i].xyz, directions[i].xyz);
  Hit const hit = trace_closest(&scene, ray, INFINITY);
  positions[i] = (float4)(0.f, 0.f, 0.f, INFINITY);
  normals[i] = shading_normals[i] = (float4)(0.f);
  for (uint k = 0u; k < 4u; ++k) {
    coefficients[4u * i + k] = (float4)(0.f);
  }
  if (hit.kind == NO_PRIMITIVE) {
    return;
  }
  ShadingPoint const point = find_shading_point(&scene, ray, hit);
  positions[i] = (float4)(point.position, hit.t);
  normals[i] = (float4)(point.geometric_normal, (float)point.from_outside);
  shading_normals[i] = (float4)(point.normal, (float)point.is_bent);
  coefficients[4u * i] = point.phong.ka;
  coefficients[4u * i + 1u] = point.phong.kd;
  coefficients[4u * i + 2u] = point.phong.ks;
  coefficients[4u * i + 3u] =
      (float4)(point.phong.emission[0], point.phong.emission[1], point.phong.emission[2], point.phong.ior);
}

/* How much light gets through to t = 1. */
__kernel void probe_visibility(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                               __global float* visibility, __global uint* any) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Ray const ray = make_ray(origins[i].xyz, directions[i].xyz);
  visibility[i] = trace_visibility(&scene, ray, 1.f);
  any[i] = trace_any(&scene, ray, 1.f) ? 1u : 0u;
}
