/* Phong's BSDF for LANES directions a work-item: one material, for each direction the viewer's wo. */
#include "bsdf/phong_bsdf.clh"

static inline Real3 load_directions(__global float4 const* directions) {
  Real3 v;
  for (uint lane = 0u; lane < LANES; ++lane) {
    set_lane3(&v, lane, directions[lane].xyz);
  }
  return v;
}

static inline Phong load_phong(__global PhongMaterial const* material) {
  Phong phong;
  set_phong(&phong, lane_mask(true), material);
  return phong;
}

/* f, and the density as w. */
__kernel void probe_evaluate(__global PhongMaterial const* material, __global float4 const* viewers,
                             __global float4 const* lights, __global float4* values) {
  size_t const first = get_global_id(0) * LANES;
  Phong const phong = load_phong(material);
  Real3 const wo = load_directions(viewers + first);
  Real3 const wi = load_directions(lights + first);
  Real3 f = phong_evaluate(&phong, wo, wi);
  Real pdf = phong_pdf(&phong, wo, wi);
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[first + lane] = (float4)(lane_of3(&f, lane), LANE_FLOAT(pdf, lane));
  }
}

/* wi, and its density as w; the weights. */
__kernel void probe_sample(__global PhongMaterial const* material, float eta, __global float4 const* viewers,
                           __global float2 const* uniforms, __global float4* directions, __global float4* weights) {
  size_t const first = get_global_id(0) * LANES;
  Phong const phong = load_phong(material);
  Real u, v;
  for (uint lane = 0u; lane < LANES; ++lane) {
    LANE_FLOAT(u, lane) = uniforms[first + lane].x;
    LANE_FLOAT(v, lane) = uniforms[first + lane].y;
  }
  BsdfSample sample = phong_sample(&phong, (Real)(eta), load_directions(viewers + first), u, v);
  for (uint lane = 0u; lane < LANES; ++lane) {
    directions[first + lane] = (float4)(lane_of3(&sample.wi, lane), LANE_FLOAT(sample.pdf, lane));
    weights[first + lane] = (float4)(lane_of3(&sample.weight, lane), 0.f);
  }
}
