#include "bsdf/phong.clh"
#include "bsdf/refract.clh"
#include "math/affine.clh"
#include "shared/develop.h"

__kernel void probe_reflect_light(__global PhongMaterial const* materials, __global float4 const* normals,
                                  __global float4 const* smooth_normals, __global float4 const* to_lights,
                                  __global float4 const* to_viewers, __global float4* reflected) {
  size_t const i = get_global_id(0);
  ShadingPoint point;
  Phong phong;
  set_phong(&phong, lane_mask(true), materials + i);
  point.normal = normals[i].xyz;
  point.smooth_normal = smooth_normals[i].xyz;
  point.to_viewer = to_viewers[i].xyz;
  reflected[i] = (float4)(reflect_light(&point, &phong, to_lights[i].xyz), 0.f);
}

/* w of the result: whether there is a refracted ray. */
__kernel void probe_refract(__global float4 const* direction_eta, __global float4 const* normals,
                            __global float4* refracted, __global float4* mirrored) {
  size_t const i = get_global_id(0);
  float3 direction = (float3)(0.f);
  bool const found = refract_direction(direction_eta[i].xyz, normals[i].xyz, direction_eta[i].w, &direction);
  refracted[i] = (float4)(direction, found ? 1.f : 0.f);
  mirrored[i] = (float4)(mirror_direction(direction_eta[i].xyz, normals[i].xyz), 0.f);
}

__kernel void probe_develop(__global float4 const* radiance, DevelopParameters const parameters,
                            __global float4* developed) {
  size_t const i = get_global_id(0);
  LinearColor const c = develop_color(linear_color(radiance[i].x, radiance[i].y, radiance[i].z), parameters);
  developed[i] = (float4)(c.r, c.g, c.b, 0.f);
}

__kernel void probe_affine(__global AffineTransform const* maps, __global float4 const* vectors,
                           __global float4* points, __global float4* mapped_vectors, __global float4* transposed,
                           __global float4* solved) {
  size_t const i = get_global_id(0);
  float3 const v = vectors[i].xyz;
  LinearMap const linear = compose(maps[i], identity_map());
  points[i] = (float4)(map_point(maps[i], v), 0.f);
  mapped_vectors[i] = (float4)(map_vector(maps[i], v), 0.f);
  transposed[i] = (float4)(apply_transpose(linear, v), 0.f);
  solved[i] = (float4)(solve(linear, v), 0.f);
}
