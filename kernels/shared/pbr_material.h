#ifndef LICHTRAUM_SHARED_PBR_MATERIAL_H
#define LICHTRAUM_SHARED_PBR_MATERIAL_H

#include "shared/pbr_fields.h"
#include "shared/texture.h"
#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* Flags of a PbrMaterial. */
#define PBR_IS_PRESENT 1u   /* 0: the material is Phong's, and the rest of the struct is zero */
#define PBR_VARIES 2u       /* textures change Phong's coefficients from point to point */
#define PBR_CUTOUT 4u       /* at some points nothing is there: traversal has to ask */
#define PBR_FILTERS 8u      /* how much light it lets through changes from point to point */
#define PBR_VARIES_MORE 16u /* textures change what Phong's coefficients know nothing of: sheen, anisotropy, ... */
#define PBR_PANE 32u        /* where it is smooth and lets light through, that goes straight on */

/* GGX's least alpha: sharper highlights than this would lose too many digits. */
#define MIN_ALPHA 0.001f

#define ALPHA_OPAQUE 0u
#define ALPHA_MASK 1u
#define ALPHA_BLEND 2u

/* What kernels read of the material of a glTF model, in the order of the Phong materials. */
typedef struct {
  uint flags;
#define PBR_COLOR(name, initial, extension, key) float name[3];
#define PBR_SHARE(name, initial, extension, key) float name;
#define PBR_NUMBER(name, initial, least, most, extension, key) float name;
#define PBR_TEXTURE(name, extension, key) TextureSlot name;
#define PBR_MODE(type, name, initial) uint name;
  PBR_DEVICE_FIELDS(PBR_COLOR, PBR_SHARE, PBR_NUMBER, PBR_TEXTURE, PBR_MODE)
#undef PBR_COLOR
#undef PBR_SHARE
#undef PBR_NUMBER
#undef PBR_TEXTURE
#undef PBR_MODE
} PbrMaterial;
DEVICE_STRUCT_SIZE(PbrMaterial, 756);

DEVICE_NAMESPACE_END

#endif
