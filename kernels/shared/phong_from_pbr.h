#ifndef LICHTRAUM_SHARED_PHONG_FROM_PBR_H
#define LICHTRAUM_SHARED_PHONG_FROM_PBR_H

#include "shared/phong_material.h"
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

/* The share of light that gets through a surface without being bent. */
SHARED_FUNCTION float straight_transmittance(float alpha, float transmission, float metallic, uint is_unlit) {
  return is_unlit != 0u ? 1.0f - alpha : 1.0f - alpha * (1.0f - transmission * (1.0f - metallic));
}

/* How much of a metal is in what reflects f0 head-on. A dielectric of an infinite index (0), as
 * KHR_materials_pbrSpecularGlossiness has it, may be one: above the 0.04 of common dielectrics it is. */
SHARED_FUNCTION float metal_in_reflection(float ior, float f0) {
  return ior == 0.0f ? clamp_to_unit((f0 - 0.04f) / 0.96f) : 0.0f;
}

SHARED_FUNCTION PhongMaterial phong_from_pbr(PbrPoint const* p) {
  /* GGX's alpha = roughness^2 as a Blinn exponent is 2 / alpha^2 - 2 (Walter et al. 2007); Phong's lobe about the
   * mirrored direction needs a quarter of it. (m + 8) / 8 keeps the highlight's energy; above 1 it would burn out. */
  float const width = p->roughness * p->roughness > 0.02f ? p->roughness * p->roughness : 0.02f;
  float const exponent = (2.0f / (width * width) - 2.0f) / 4.0f;
  float const m = exponent > 0.0f ? exponent : 0.0f;
  float const ratio = (p->ior - 1.0f) / (p->ior + 1.0f);
  /* A metal shows nothing but its surroundings, which a scene of a few lights lacks: two fifths of its colour stay.
   */
  float const matt = 1.0f - 0.6f * p->metallic;
  float const transmit = straight_transmittance(p->alpha, p->transmission, p->metallic, p->is_unlit);
  float const smooth = 1.0f - p->roughness;
  float dielectric[3];
  float in_dielectric[3];
  float most_in_dielectric = 0.0f;
  for (int c = 0; c < 3; ++c) {
    /* Reflectance at normal incidence (Schlick 1994). */
    dielectric[c] = clamp_to_unit(ratio * ratio * p->specular_color[c]) * p->specular;
    in_dielectric[c] = (1.0f - p->metallic) * metal_in_reflection(p->ior, dielectric[c]);
    most_in_dielectric = in_dielectric[c] > most_in_dielectric ? in_dielectric[c] : most_in_dielectric;
  }
  float const metal = p->metallic > most_in_dielectric ? p->metallic : most_in_dielectric;
  PhongMaterial out;
  for (int c = 0; c < 3; ++c) {
    float const f0 = dielectric[c] + p->metallic * (p->color[c] - dielectric[c]);
    out.kd[c] = p->color[c] * matt * (1.0f - most_in_dielectric) + 0.4f * in_dielectric[c];
    out.ka[c] = out.kd[c] * p->occlusion;
    out.ks[c] = p->alpha * clamp_to_unit(f0 * ((m + 8.0f) / 8.0f));
    out.emission[c] = p->alpha * p->emission[c];
    if (p->is_unlit != 0u) {
      out.ka[c] = out.kd[c] = out.ks[c] = 0.0f;
      out.emission[c] = p->alpha * p->color[c];
    }
  }
  out.m = p->is_unlit != 0u ? 1.0f : m;
  out.reflect = p->is_unlit != 0u ? 0.0f : 0.6f * metal * smooth * smooth * (1.0f - transmit);
  out.transmit = transmit;
  out.ior = p->is_unlit != 0u ? 1.0f : p->refraction_ior;
  return out;
}

DEVICE_NAMESPACE_END

#endif
