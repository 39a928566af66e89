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

static inline BsdfView load_view(Bsdf* bsdf, uint from_outside, float4 smooth_normal, float4 coat_normal,
                                 __global float4 const* viewers) {
  Real3 const wo = load_directions(viewers);
  Mask const is_outside = lane_mask(from_outside != 0u);
  cover_with_film(bsdf, is_outside, wo.z);
  return view_bsdf(bsdf, is_outside, wo, broadcast3(smooth_normal.xyz), broadcast3(coat_normal.xyz));
}

/* f |wi.z|, and the density as w. */
__kernel void probe_evaluate(__global BsdfParameters const* parameters, uint from_outside, float4 smooth_normal,
                             float4 coat_normal, __global float4 const* viewers, __global float4 const* lights,
                             __global float4* values) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf bsdf = load_bsdf(parameters);
  BsdfView const view = load_view(&bsdf, from_outside, smooth_normal, coat_normal, viewers + first);
  BsdfValue value = bsdf_evaluate(&bsdf, &view, load_directions(lights + first));
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[first + lane] = (float4)(lane_of3(&value.value, lane), LANE_FLOAT(value.pdf, lane));
  }
}

/* wi, and its density as w; the weights. `uniforms`: choice, u, v. */
__kernel void probe_sample(__global BsdfParameters const* parameters, uint from_outside, float4 smooth_normal,
                           float4 coat_normal, __global float4 const* viewers, __global float4 const* uniforms,
                           __global float4* directions, __global float4* weights) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf bsdf = load_bsdf(parameters);
  BsdfView const view = load_view(&bsdf, from_outside, smooth_normal, coat_normal, viewers + first);
  Real3 const random = load_directions(uniforms + first);
  BsdfSample sample = bsdf_sample(&bsdf, &view, random.x, random.y, random.z);
  for (uint lane = 0u; lane < LANES; ++lane) {
    directions[first + lane] = (float4)(lane_of3(&sample.wi, lane), LANE_FLOAT(sample.pdf, lane));
    weights[first + lane] = (float4)(lane_of3(&sample.weight, lane), 0.f);
  }
}

/* The probabilities with which lobes are chosen: coat, glossy, diffuse, transmitted; mirror, glass, sheen, translucent.
 */
__kernel void probe_choices(__global BsdfParameters const* parameters, uint from_outside, float4 smooth_normal,
                            float4 coat_normal, __global float4 const* viewers, __global float4* spread,
                            __global float4* delta) {
  size_t const first = get_global_id(0) * LANES;
  Bsdf bsdf = load_bsdf(parameters);
  BsdfView view = load_view(&bsdf, from_outside, smooth_normal, coat_normal, viewers + first);
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

/* Films: index, thickness in nm, and the cosine of the viewer's angle; what their bases reflect head-on. */
__kernel void probe_thin_film(__global float4 const* films, __global float4 const* bases,
                              __global float4* reflectances) {
  size_t const first = get_global_id(0) * LANES;
  Real3 const film = load_directions(films + first);
  ThinFilm const viewed = view_thin_film(film.x, film.y, film.z);
  Real3 reflectance = thin_film_reflectance(&viewed, load_directions(bases + first));
  for (uint lane = 0u; lane < LANES; ++lane) {
    reflectances[first + lane] = (float4)(lane_of3(&reflectance, lane), 0.f);
  }
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
