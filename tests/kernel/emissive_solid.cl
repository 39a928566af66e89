/* Spheres, ellipsoids and boxes that shine, for LANES points a work-item. */
#include "lights/emissive_solid.clh"

static inline Real3 load_points(__global float4 const* points, size_t first) {
  Real3 point;
  for (uint lane = 0u; lane < LANES; ++lane) {
    set_lane3(&point, lane, points[first + lane].xyz);
  }
  return point;
}

/* `uniforms`: in x and y; a lane with less than 0 must not be touched. Directions and how far rays may go, and as x and
 * y the density and the red radiance. */
__kernel void probe_sample(SCENE_PARAMETERS, __global uint const* numbers, __global float4 const* positions,
                           __global float2 const* uniforms, __global float4* directions, __global float2* found) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * LANES;
  Word number;
  Real u, v;
  for (uint lane = 0u; lane < LANES; ++lane) {
    LANE_WORD(number, lane) = numbers[first + lane];
    LANE_FLOAT(u, lane) = uniforms[first + lane].x;
    LANE_FLOAT(v, lane) = uniforms[first + lane].y;
  }
  EmissiveSample sample = sample_emissive_solids(&scene, u >= 0.f, number, load_points(positions, first), u, v);
  for (uint lane = 0u; lane < LANES; ++lane) {
    directions[first + lane] = (float4)(lane_of3(&sample.to_light, lane), LANE_FLOAT(sample.t_max, lane));
    found[first + lane] = (float2)(LANE_FLOAT(sample.pdf, lane), lane_of3(&sample.radiance, lane).x);
  }
}

/* `directions`: with the cosine at the surface as w; `positions`: with the distance to it. */
__kernel void probe_pdf(SCENE_PARAMETERS, __global uint const* numbers, __global float4 const* positions,
                        __global float4 const* directions, __global float* pdfs) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * LANES;
  Word number;
  Real distance, cosine;
  for (uint lane = 0u; lane < LANES; ++lane) {
    LANE_WORD(number, lane) = numbers[first + lane];
    LANE_FLOAT(distance, lane) = positions[first + lane].w;
    LANE_FLOAT(cosine, lane) = directions[first + lane].w;
  }
  Real pdf = emissive_solid_pdf(&scene, distance > 0.f, number, load_points(positions, first),
                                load_points(directions, first), distance, cosine);
  for (uint lane = 0u; lane < LANES; ++lane) {
    pdfs[first + lane] = LANE_FLOAT(pdf, lane);
  }
}

/* `names`: instance, kind and index. */
__kernel void probe_find(SCENE_PARAMETERS, __global uint4 const* names, __global uint* numbers) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Hit const hit = {1.f, names[i].y, names[i].z, names[i].x};
  numbers[i] = find_emissive_solid(&scene, hit);
}
