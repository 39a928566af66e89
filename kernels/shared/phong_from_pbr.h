#ifndef LICHTRAUM_SHARED_PHONG_FROM_PBR_H
#define LICHTRAUM_SHARED_PHONG_FROM_PBR_H

#include "shared/shading.h"
#include "shared/types.h"

/* From metallic-roughness to Phong's coefficients, for one point of a surface. One text for both languages, as nothing
 * says which mapping is right; docs/GLTF.md has it as a table. */

DEVICE_NAMESPACE_BEGIN

/* A physically based material at one point: factors times textures times the vertex colour. */
typedef struct {
  float color[3]; /* base colour, linear, 0..1 */
  float alpha;    /* 0..1; 1 unless the material blends */
  float metallic; /* 0..1 */
  float roughness;
  float transmission; /* 0..1 */
  float occlusion;    /* 0..1: share of the ambient light that gets here */
  float emission[3];
  float ior;            /* KHR_materials_ior */
  float refraction_ior; /* that rays are bent by: 1 for a thin wall */
  float specular;       /* KHR_materials_specular */
  float specular_color[3];
  uint is_unlit;
} PbrPoint;

SHARED_FUNCTION float clamp_to_unit(float x) { return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; }

SHARED_FUNCTION PhongMaterial phong_from_pbr(PbrPoint const* p) {
  /* GGX's alpha = roughness^2 as a Blinn exponent is 2 / alpha^2 - 2 (Walter et al. 2007); Phong's lobe about the
   * mirrored direction needs a quarter of it. (m + 8) / 8 keeps the highlight's energy; above 1 it would burn out. */
  float const width = p->roughness * p->roughness > 0.02f ? p->roughness * p->roughness : 0.02f;
  float const exponent = (2.0f / (width * width) - 2.0f) / 4.0f;
  float const m = exponent > 0.0f ? exponent : 0.0f;
  float const ratio = (p->ior - 1.0f) / (p->ior + 1.0f);
  /* A metal shows nothing but its surroundings, which a scene of a few lights has not: two fifths of its colour stay.
   */
  float const matt = 1.0f - 0.6f * p->metallic;
  float const transmit = 1.0f - p->alpha * (1.0f - p->transmission * (1.0f - p->metallic));
  float const smooth = 1.0f - p->roughness;
  float ka[3], kd[3], ks[3];
  PhongMaterial out;
  for (int c = 0; c < 3; ++c) {
    /* Reflectance at normal incidence (Schlick 1994). */
    float const dielectric = clamp_to_unit(ratio * ratio * p->specular_color[c]) * p->specular;
    float const f0 = dielectric + p->metallic * (p->color[c] - dielectric);
    kd[c] = p->color[c] * matt;
    ka[c] = kd[c] * p->occlusion;
    ks[c] = p->alpha * clamp_to_unit(f0 * ((m + 8.0f) / 8.0f));
    out.emission[c] = p->alpha * p->emission[c];
    if (p->is_unlit != 0u) {
      ka[c] = kd[c] = ks[c] = 0.0f;
      out.emission[c] = p->alpha * p->color[c];
    }
  }
  out.ka.x = ka[0];
  out.ka.y = ka[1];
  out.ka.z = ka[2];
  out.ka.w = p->is_unlit != 0u ? 1.0f : m;
  out.kd.x = kd[0];
  out.kd.y = kd[1];
  out.kd.z = kd[2];
  out.kd.w = p->is_unlit != 0u ? 0.0f : 0.6f * p->metallic * smooth * smooth * (1.0f - transmit);
  out.ks.x = ks[0];
  out.ks.y = ks[1];
  out.ks.z = ks[2];
  out.ks.w = p->is_unlit != 0u ? 1.0f - p->alpha : transmit;
  out.ior = p->is_unlit != 0u ? 1.0f : p->refraction_ior;
  return out;
}

DEVICE_NAMESPACE_END

#endif
