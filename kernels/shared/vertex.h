#ifndef LICHTRAUM_SHARED_VERTEX_H
#define LICHTRAUM_SHARED_VERTEX_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* What each vertex of a triangle has, one float after the other in this order; which of it, the triangle's format says.
 * Normals and tangents are in the frame of the object, of any length but the same for all of a mesh: a mesh that was
 * stretched keeps the lengths that its map gave them, so that interpolating before and after the map is the same. */
#define VERTEX_NORMAL 1u  /* x, y, z */
#define VERTEX_TANGENT 2u /* x, y, z, and the sign of the bitangent */
#define VERTEX_COLOR 4u   /* red, green, blue, alpha; linear */
/* u, v: of the texture coordinates that the material uses, set k of those where bit k is set. */
#define VERTEX_TEXCOORD_SHIFT 8
#define VERTEX_MAX_TEXCOORDS 24

/* Which vertices a triangle has, beside its corners. One entry a triangle, in the order of the triangles, in scenes
 * that have any. */
typedef struct {
  uint corners[3]; /* where in the vertex data each corner's floats begin */
  uint format;     /* VERTEX_...; 0: nothing */
} TriangleAttributes;
DEVICE_STRUCT_SIZE(TriangleAttributes, 16);

DEVICE_NAMESPACE_END

#endif
