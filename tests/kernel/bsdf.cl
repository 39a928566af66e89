/* The BSDF for LANES directions a work-item: one surface, for each direction the viewer's wo. */
#include "bsdf/bsdf_at.clh"

static inline Real3 load_directions(__global float4 const* directions) {
  Real3 v;
  for (uint lane = 0u; lane < LANES; ++lane) {
    set_lane3(&v, lane, directions[lane].xyz);
  }
  return v;
}

static inline Bsdf load_bsdf(__global BsdfParameters const* source) {
  BsdfParameters const parameters = *source;
  Bsdf bsdf;
  set_bsdf(&bsdf, lane_mask(true), &parameters);
  return bsdf;
}

/* f |wi.z|, and the density as w. */
__kernel void probe_evaluate(__global BsdfParameters const* parameters, uint from_outside, float4 coat_normal,
                             __global float4 const* viewers, __global float4 const* lights, __global float4* values) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf const bsdf = load_bsdf(parameters);
  BsdfView const view =
      view_bsdf(&bsdf, lane_mask(from_outside != 0u), load_directions(viewers + first), broadcast3(coat_normal.xyz));
  BsdfValue value = bsdf_evaluate(&bsdf, &view, load_directions(lights + first));
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[first + lane] = (float4)(lane_of3(&value.value, lane), LANE_FLOAT(value.pdf, lane));
  }
}

/* wi, and its density as w; the weights. `uniforms`: choice, u, v. */
__kernel void probe_sample(__global BsdfParameters const* parameters, uint from_outside, float4 coat_normal,
                           __global float4 const* viewers, __global float4 const* uniforms, __global float4* directions,
                           __global float4* weights) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf const bsdf = load_bsdf(parameters);
  BsdfView const view =
      view_bsdf(&bsdf, lane_mask(from_outside != 0u), load_directions(viewers + first), broadcast3(coat_normal.xyz));
  Real3 const random = load_directions(uniforms + first);
  BsdfSample sample = bsdf_sample(&bsdf, &view, random.x, random.y, random.z);
  for (uint lane = 0u; lane < LANES; ++lane) {
    directions[first + lane] = (float4)(lane_of3(&sample.wi, lane), LANE_FLOAT(sample.pdf, lane));
    weights[first + lane] = (float4)(lane_of3(&sample.weight, lane), 0.f);
  }
}

/* The probabilities with which lobes are chosen: coat, glossy, diffuse, transmitted; mirror, glass, sheen, translucent.
 */
__kernel void probe_choices(__global BsdfParameters const* parameters, uint from_outside, float4 coat_normal,
                            __global float4 const* viewers, __global float4* spread, __global float4* delta) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf const bsdf = load_bsdf(parameters);
  BsdfView view =
      view_bsdf(&bsdf, lane_mask(from_outside != 0u), load_directions(viewers + first), broadcast3(coat_normal.xyz));
  for (uint lane = 0u; lane < LANES; ++lane) {
    spread[first + lane] = (float4)(LANE_FLOAT(view.to_coat, lane), LANE_FLOAT(view.to_glossy, lane),
                                    LANE_FLOAT(view.to_diffuse, lane), LANE_FLOAT(view.to_transmitted, lane));
    delta[first + lane] = (float4)(LANE_FLOAT(view.to_mirror, lane), LANE_FLOAT(view.to_glass, lane),
                                   LANE_FLOAT(view.to_sheen, lane), LANE_FLOAT(view.to_translucent, lane));
  }
}

__kernel void probe_ggx_albedo(__global float const* alphas, __global float const* cosines, __global float2* albedos) {
  size_t const i = get_global_id(0);
  GgxAlbedo albedo = round_ggx_albedo((Real)(alphas[i]), (Real)(cosines[i]));
  albedos[i] = (float2)(LANE_FLOAT(albedo.a, 0), LANE_FLOAT(albedo.b, 0));
}

__kernel void probe_bsdf_from_phong(__global PhongMaterial const* materials, __global BsdfParameters* parameters) {
  size_t const i = get_global_id(0);
  PhongMaterial const material = materials[i];
  parameters[i] = bsdf_from_phong(&material);
}

/* Materials without textures. */
__kernel void probe_bsdf_from_pbr(__global PbrMaterial const* materials, __global BsdfParameters* parameters) {
  size_t const i = get_global_id(0);
  Scene scene;
  PointAttributes const nothing = no_attributes();
  parameters[i] = bsdf_from_pbr(&scene, materials + i, &nothing);
}
