#ifndef LICHTRAUM_SHARED_PBR_MATERIAL_H
#define LICHTRAUM_SHARED_PBR_MATERIAL_H

#include "shared/texture.h"
#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* Flags of a PbrMaterial. */
#define PBR_IS_PRESENT 1u /* 0: the material has Phong's coefficients only, and the rest of the struct is zero */
#define PBR_VARIES 2u     /* textures change Phong's coefficients from point to point */
#define PBR_CUTOUT 4u     /* at some points nothing is there: traversal has to ask */
#define PBR_FILTERS 8u    /* how much light it lets through changes from point to point */
#define PBR_UNLIT 16u     /* KHR_materials_unlit */
#define PBR_DOUBLE_SIDED 32u
#define PBR_HAS_ATTENUATION 64u /* attenuation_distance counts */

#define ALPHA_OPAQUE 0u
#define ALPHA_MASK 1u
#define ALPHA_BLEND 2u

/* The whole material of a glTF model (include/lichtraum/pbr_material.hpp says what each means), in the order of the
 * Phong materials. Whitted's integrator reads the first part. */
typedef struct {
  uint flags;
  uint alpha_mode;
  float alpha_cutoff;
  float ior;
  float base_color[4];
  float emissive[3];
  float metallic;
  float roughness;
  float normal_scale;
  float occlusion_strength;
  float transmission;
  float specular;
  float specular_color[3];
  TextureSlot base_color_texture;
  TextureSlot metallic_roughness_texture;
  TextureSlot normal_texture;
  TextureSlot occlusion_texture;
  TextureSlot emissive_texture;
  TextureSlot transmission_texture;
  TextureSlot specular_texture;
  TextureSlot specular_color_texture;
  float thickness;
  float dispersion;

  float attenuation_distance;
  float attenuation_color[3];
  TextureSlot thickness_texture;

  float clearcoat;
  float clearcoat_roughness;
  TextureSlot clearcoat_texture;
  TextureSlot clearcoat_roughness_texture;
  TextureSlot clearcoat_normal_texture;

  float sheen_color[3];
  float sheen_roughness;
  TextureSlot sheen_color_texture;
  TextureSlot sheen_roughness_texture;

  float anisotropy;
  float anisotropy_rotation; /* radians */
  TextureSlot anisotropy_texture;

  float iridescence;
  float iridescence_ior;
  float iridescence_thickness_minimum; /* nanometres, as the maximum */
  float iridescence_thickness_maximum;
  TextureSlot iridescence_texture;
  TextureSlot iridescence_thickness_texture;
} PbrMaterial;
DEVICE_STRUCT_SIZE(PbrMaterial, 696);

DEVICE_NAMESPACE_END

#endif
