#ifndef LICHTRAUM_SHARED_PBR_FIELDS_H
#define LICHTRAUM_SHARED_PBR_FIELDS_H

/* The fields of glTF's metallic-roughness material with its extensions, written down once. From these lists come
 * PbrModel (lichtraum/pbr_model.hpp), PbrMaterial of the device, what the glTF loader reads and operator<< prints, and
 * the window's sliders.
 *
 *   COLOR(name, initial, extension, key)                linear red, green and blue
 *   SHARE(name, initial, extension, key)                0..1
 *   NUMBER(name, initial, least, most, extension, key)  smaller ones are not allowed; larger ones are, but no slider
 *                                                       goes there
 *   TEXTURE(name, extension, key)                       factors are multiplied with their textures
 *   MODE(type, name, initial)
 *
 * `extension` is KHR_materials_... without that, and `key` the word in it; no extension: what is in glTF's core, or in
 * one word of it with something else, has code of its own in the loader. */

/* What kernels read. */
#define PBR_DEVICE_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE)                                                       \
  COLOR(base_color, 1, "", "") /* also times the vertex colour */                                                    \
  SHARE(alpha, 1, "", "")      /* the same, of the base colour */                                                    \
  TEXTURE(base_color_texture, "", "")                                                                                \
  SHARE(metallic, 1, "", "")  /* times the texture's blue */                                                         \
  SHARE(roughness, 1, "", "") /* times the texture's green */                                                        \
  TEXTURE(metallic_roughness_texture, "", "")                                                                        \
  TEXTURE(normal_texture, "", "")                                                                                    \
  NUMBER(normal_scale, 1, 0, 4, "", "")                                                                              \
  TEXTURE(occlusion_texture, "", "") /* red */                                                                       \
  SHARE(occlusion_strength, 1, "", "")                                                                               \
  COLOR(emissive, 0, "", "") /* with KHR_materials_emissive_strength multiplied in */                                \
  TEXTURE(emissive_texture, "", "")                                                                                  \
  MODE(AlphaMode, alpha_mode, AlphaMode::opaque)                                                                     \
  NUMBER(alpha_cutoff, 0.5, 0, 1, "", "")                                                                            \
  MODE(bool, unlit, false) /* KHR_materials_unlit: shows its base colour, whatever the light */                      \
  NUMBER(ior, 1.5, 1, 3, "ior", "ior")                                                                               \
  SHARE(specular, 1, "specular", "specularFactor")                                                                   \
  TEXTURE(specular_texture, "specular", "specularTexture") /* alpha */                                               \
  COLOR(specular_color, 1, "specular", "specularColorFactor")                                                        \
  TEXTURE(specular_color_texture, "specular", "specularColorTexture")                                                \
  SHARE(transmission, 0, "transmission", "transmissionFactor")                                                       \
  TEXTURE(transmission_texture, "transmission", "transmissionTexture") /* red */                                     \
  NUMBER(thickness, 0, 0, 1, "volume", "thicknessFactor")              /* 0 is a thin wall, all else a solid body */ \
  MODE(bool, double_sided, false)                                                                                    \
  NUMBER(attenuation_distance, INFINITY, 0, 10, "volume", "attenuationDistance") /* > 0; infinite: clear */          \
  COLOR(attenuation_color, 1, "volume", "attenuationColor")                                                          \
  SHARE(clearcoat, 0, "clearcoat", "clearcoatFactor")                                                                \
  TEXTURE(clearcoat_texture, "clearcoat", "clearcoatTexture") /* red */                                              \
  SHARE(clearcoat_roughness, 0, "clearcoat", "clearcoatRoughnessFactor")                                             \
  TEXTURE(clearcoat_roughness_texture, "clearcoat", "clearcoatRoughnessTexture") /* green */                         \
  TEXTURE(clearcoat_normal_texture, "clearcoat", "clearcoatNormalTexture")                                           \
  NUMBER(clearcoat_normal_scale, 1, 0, 4, "", "")                                                                    \
  COLOR(sheen_color, 0, "sheen", "sheenColorFactor")                                                                 \
  TEXTURE(sheen_color_texture, "sheen", "sheenColorTexture")                                                         \
  SHARE(sheen_roughness, 0, "sheen", "sheenRoughnessFactor")                                                         \
  TEXTURE(sheen_roughness_texture, "sheen", "sheenRoughnessTexture") /* alpha */                                     \
  SHARE(anisotropy, 0, "anisotropy", "anisotropyStrength")                                                           \
  NUMBER(anisotropy_rotation, 0, -3.14159265, 3.14159265, "", "") /* radians */                                      \
  TEXTURE(anisotropy_texture, "anisotropy", "anisotropyTexture")  /* red and green: direction, blue: strength */     \
  SHARE(diffuse_transmission, 0, "diffuse_transmission", "diffuseTransmissionFactor")                                \
  TEXTURE(diffuse_transmission_texture, "diffuse_transmission", "diffuseTransmissionTexture") /* alpha */            \
  COLOR(diffuse_transmission_color, 1, "diffuse_transmission", "diffuseTransmissionColorFactor")                     \
  TEXTURE(diffuse_transmission_color_texture, "diffuse_transmission", "diffuseTransmissionColorTexture")             \
  NUMBER(dispersion, 0, 0, 1, "dispersion", "dispersion") /* 20 / Abbe number */                                     \
  SHARE(iridescence, 0, "iridescence", "iridescenceFactor")                                                          \
  TEXTURE(iridescence_texture, "iridescence", "iridescenceTexture") /* red */                                        \
  NUMBER(iridescence_ior, 1.3, 1, 3, "iridescence", "iridescenceIor")                                                \
  NUMBER(iridescence_thickness_minimum, 100, 0, 1000, "iridescence", "iridescenceThicknessMinimum") /* nm */         \
  NUMBER(iridescence_thickness_maximum, 400, 0, 1000, "iridescence", "iridescenceThicknessMaximum") /* nm */         \
  TEXTURE(iridescence_thickness_texture, "iridescence", "iridescenceThicknessTexture")              /* green */

/* What none of them reads. */
#define PBR_HOST_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE) \
  TEXTURE(thickness_texture, "volume", "thicknessTexture") /* green */

#define PBR_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE) \
  PBR_DEVICE_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE) PBR_HOST_FIELDS(COLOR, SHARE, NUMBER, TEXTURE, MODE)

#endif
