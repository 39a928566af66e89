#ifndef LICHTRAUM_SHARED_TEXTURE_H
#define LICHTRAUM_SHARED_TEXTURE_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

#define WRAP_REPEAT 0u
#define WRAP_MIRRORED_REPEAT 1u
#define WRAP_CLAMP_TO_EDGE 2u
#define FILTER_NEAREST 0u
#define FILTER_LINEAR 1u

/* A picture among the texels: RGBA8 in one word (red lowest), row by row, first row at the top. */
typedef struct {
  uint first_texel;
  uint width;    /* > 0 */
  uint height;   /* > 0 */
  uint sampling; /* wrap of u | wrap of v << 2 | filter << 4 */
} Texture;
DEVICE_STRUCT_SIZE(Texture, 16);

#define NO_TEXTURE 0xffffffffu

/* A texture in its place in a material (KHR_texture_transform). */
typedef struct {
  uint texture;   /* NO_TEXTURE: the slot counts as all ones */
  uint texcoord;  /* which of the sets that the material uses */
  float row_u[3]; /* the picture's u is  row_u . (u, v, 1) */
  float row_v[3];
} TextureSlot;
DEVICE_STRUCT_SIZE(TextureSlot, 32);

DEVICE_NAMESPACE_END

#endif
