#include "shared/bvh.h"
#include "shared/denoise.h"
#include "shared/film.h"
#include "shared/frame.h"
#include "shared/geometry.h"
#include "shared/pbr_material.h"
#include "shared/phong_from_pbr.h"
#include "shared/sampling.h"
#include "shared/scene_arrays.h"
#include "shared/texture.h"
#include "shared/vertex.h"
#include "shared/wide.h"

/* In the order of struct_members.h. */
#define OFFSET_OF(type, member) ((uint)(size_t) & (((__private type*)0)->member))

__kernel void probe_struct_sizes(__global uint* sizes) {
#define STRUCT(type) *sizes++ = (uint)sizeof(type);
#define MEMBER(type, member) *sizes++ = OFFSET_OF(type, member);
#include "struct_members.h"
}
