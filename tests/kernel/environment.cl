/* Light from infinitely far away, for LANES directions a work-item. */
#include "lights/environment.clh"

/* Radiance, and the density as w. */
__kernel void probe_evaluate(SCENE_PARAMETERS, __global float4 const* directions, __global float4* values) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * LANES;
  Real3 direction;
  for (uint lane = 0u; lane < LANES; ++lane) {
    set_lane3(&direction, lane, directions[first + lane].xyz);
  }
  Real3 radiance = environment_radiance(&scene, direction);
  Real pdf = environment_pdf(&scene, direction);
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[first + lane] = (float4)(lane_of3(&radiance, lane), LANE_FLOAT(pdf, lane));
  }
}

/* Directions, and their densities as w; what arrives from there. */
__kernel void probe_sample(SCENE_PARAMETERS, __global float2 const* uniforms, __global float4* directions,
                           __global float4* radiances) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * LANES;
  Real u, v;
  for (uint lane = 0u; lane < LANES; ++lane) {
    LANE_FLOAT(u, lane) = uniforms[first + lane].x;
    LANE_FLOAT(v, lane) = uniforms[first + lane].y;
  }
  EnvironmentSample sample = environment_sample(&scene, u, v);
  for (uint lane = 0u; lane < LANES; ++lane) {
    directions[first + lane] = (float4)(lane_of3(&sample.wi, lane), LANE_FLOAT(sample.pdf, lane));
    radiances[first + lane] = (float4)(lane_of3(&sample.radiance, lane), 0.f);
  }
}
