#include "materials/phong_at.clh"
#include "one_ray.clh"

/* What shading sees of the point that each ray hits first; `coefficients`: ka and m, kd and reflect, ks and transmit,
 * emission and ior. w of a position: t, INFINITY without hit; of a normal: 1 on the outer side; of a shading normal: 1
 * when it differs. */
__kernel void probe_points(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                           __global float4* positions, __global float4* normals, __global float4* shading_normals,
                           __global float4* coefficients) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Ray const ray = make_ray(origins[i].xyz, directions[i].xyz);
  RayBatch batch;
  HitBatch hits;
  trace_one_ray(&scene, ray, &batch, &hits);
  positions[i] = (float4)(0.f, 0.f, 0.f, INFINITY);
  normals[i] = shading_normals[i] = (float4)(0.f);
  for (uint k = 0u; k < 4u; ++k) {
    coefficients[4u * i + k] = (float4)(0.f);
  }
  if (hits.kind[0] == NO_PRIMITIVE) {
    return;
  }
  ShadingPoint point;
  find_shading_points(&scene, &batch, &hits, 0u, &point);
  Phong phong;
  find_phong(&scene, point.exists, &point.material, point.attributes, &phong);
  positions[i] = (float4)(lane_of3(&point.position, 0u), hits.t[0]);
  normals[i] = (float4)(lane_of3(&point.geometric_normal, 0u), LANE_MASK(point.from_outside, 0u) != 0 ? 1.f : 0.f);
  shading_normals[i] = (float4)(lane_of3(&point.normal, 0u), 0.f);
  coefficients[4u * i] = (float4)(lane_of3(&phong.ka, 0u), LANE_FLOAT(phong.m, 0u));
  coefficients[4u * i + 1u] = (float4)(lane_of3(&phong.kd, 0u), LANE_FLOAT(phong.reflect, 0u));
  coefficients[4u * i + 2u] = (float4)(lane_of3(&phong.ks, 0u), LANE_FLOAT(phong.transmit, 0u));
  coefficients[4u * i + 3u] = (float4)(lane_of3(&phong.emission, 0u), LANE_FLOAT(phong.ior, 0u));
}

/* How much light gets through to t = 1. */
__kernel void probe_visibility(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                               __global float* visibility, __global uint* any) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Ray const ray = make_ray(origins[i].xyz, directions[i].xyz);
  visibility[i] = trace_visibility(&scene, ray, 1.f).x;
  any[i] = trace_any(&scene, ray, 1.f) ? 1u : 0u;
}

/* Where a ray first hits, after `t`. */
static ShadingPoint point_ahead(Scene const* scene, float4 origin, float4 direction, float* t) {
  RayBatch batch;
  HitBatch hits;
  trace_one_ray(scene, make_ray(origin.xyz, direction.xyz), &batch, &hits);
  ShadingPoint point;
  find_shading_points(scene, &batch, &hits, 0u, &point);
  *t = hits.t[0];
  return point;
}

/* The normal of a coat where the ray first hits. */
__kernel void probe_coat_normals(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                                 __global float4* normals) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  float t;
  ShadingPoint point = point_ahead(&scene, origins[i], directions[i], &t);
  normals[i] = (float4)(lane_of3(&point.coat_normal, 0u), t);
}

/* Along what microfacets are stretched where the ray first hits; zero where nothing says so. */
__kernel void probe_tangents(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                             __global float4* tangents) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  float t;
  ShadingPoint point = point_ahead(&scene, origins[i], directions[i], &t);
  tangents[i] = (float4)(lane_of3(&point.tangent, 0u), t);
}
