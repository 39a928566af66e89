/* What is computed for LANES rays at once. With -D LAYOUT_WIDE, and LANES=1 or 16. */
#include "bsdf/phong.clh"
#include "lights/punctual_light.clh"
#include "materials/phong_at.clh"
#include "surface/shading_point.clh"

#define VALUES 38u /* a ray */

static inline void put3(Real3* v, uint lane, __global float** values) {
  float3 const value = lane_of3(v, lane);
  *(*values)++ = value.x;
  *(*values)++ = value.y;
  *(*values)++ = value.z;
}

/* Everything about the points that rays hit, VALUES a ray; the first is the kind of what was hit, the second whether
 * the light adds something. Rays with w = 0 in their directions do not exist. */
__kernel void probe_points(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                           __global PunctualLight const* lit_by, __global float* out) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * BATCH;
  PunctualLight const light = lit_by[0];
  RayBatch rays;
  HitBatch hits;
  rays.count = BATCH;
  rays.is_from_one_point = false;
  for (uint i = 0u; i < BATCH; ++i) {
    Ray const ray = make_ray(origins[first + i].xyz, directions[first + i].xyz);
    set_ray(&rays, i, ray, directions[first + i].w > 0.f ? INFINITY : -1.f);
  }
  trace_closest_batch(&scene, &rays, &hits);
  for (uint group = 0u; group < BATCH_GROUPS; ++group) {
    ShadingPoint point;
    find_shading_points(&scene, &rays, &hits, group * LANES, &point);
    Phong phong;
    find_phong(&scene, point.exists, &point.material, point.attributes, &phong);
    LightSample sample = sample_light(&light, point.position);
    Real3 reflected = multiply3(sample.arriving, reflect_light(&point, &phong, sample.to_light));
    Real3 unshadowed = unshadowed_radiance(&phong, (float3)(0.3f, 0.2f, 0.1f));
    for (uint lane = 0u; lane < LANES; ++lane) {
      __global float* values = out + (first + group * LANES + lane) * VALUES;
      for (uint k = 0u; k < VALUES; ++k) {
        values[k] = 0.f;
      }
      *values++ = (float)(int)hits.kind[group * LANES + lane];
      if (LANE_MASK(point.exists, lane) == 0) {
        continue;
      }
      Mask is_lit = !is_black(reflected);
      *values++ = LANE_MASK(is_lit, lane) != 0 ? 1.f : 0.f;
      *values++ = LANE_MASK(point.from_outside, lane) != 0 ? 1.f : 0.f;
      *values++ = LANE_FLOAT(point.offset, lane);
      *values++ = LANE_FLOAT(phong.m, lane);
      *values++ = LANE_FLOAT(phong.reflect, lane);
      *values++ = LANE_FLOAT(phong.transmit, lane);
      *values++ = LANE_FLOAT(phong.ior, lane);
      put3(&point.position, lane, &values);
      put3(&point.geometric_normal, lane, &values);
      put3(&point.normal, lane, &values);
      put3(&point.to_viewer, lane, &values);
      put3(&phong.kd, lane, &values);
      put3(&phong.ks, lane, &values);
      put3(&unshadowed, lane, &values);
      put3(&sample.to_light, lane, &values);
      put3(&sample.arriving, lane, &values);
      put3(&reflected, lane, &values);
    }
  }
}
