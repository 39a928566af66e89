#ifndef LICHTRAUM_SHARED_WIDE_H
#define LICHTRAUM_SHARED_WIDE_H

#include "shared/geometry.h"
#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* The hierarchy for CPUs: the binary tree collapsed to sixteen children a node, triangles and spheres in
 * blocks of four. */
#define WIDE_CHILDREN 16
#define BLOCK_LANES 4

/* Rows of WideNode::bounds. The far row of an axis is its near row ^ 1, for rays of either direction. */
#define WIDE_MIN_X 0u
#define WIDE_MAX_X 1u
#define WIDE_MIN_Y 2u
#define WIDE_MAX_Y 3u
#define WIDE_MIN_Z 4u
#define WIDE_MAX_Z 5u

/* A child in one word: its kind above WIDE_INDEX_BITS, below them an index: of a node, of a block of triangles or
 * spheres, or of the one primitive or instance in the array of its kind. */
#define WIDE_INDEX_BITS 28
#define WIDE_INDEX_MASK 0x0fffffffu
/* A leaf's kind is PRIMITIVE_... */
#define WIDE_KIND_NODE 14u

/*   bounds    min x | 0 1 2 ... 15 |   one row is one float16
 *             max x | 0 1 2 ... 15 |
 *             ...
 *   children        | 0 1 2 ... 15 |
 * Leaves come first, then the largest: the order for any-hit (traversal/wide_stream.clh). An absent child has
 * min = INFINITY and max = -INFINITY, which no ray meets. */
typedef struct {
  float bounds[6][WIDE_CHILDREN];
  uint children[WIDE_CHILDREN];
} DEVICE_ALIGNED(64) WideNode;
DEVICE_STRUCT_SIZE(WideNode, 448);

/* Four triangles: vertices[corner][axis] is one float4. Lanes without a triangle have vertices of NaN, which no ray
 * meets. The triangle in lane l of block b has the index BLOCK_LANES * b + l among all. */
typedef struct {
  float vertices[3][3][BLOCK_LANES];
} TriangleBlock;
DEVICE_STRUCT_SIZE(TriangleBlock, 144);

/* Four spheres: center[axis] is one float4. Lanes without a sphere have a radius of NaN, which no ray meets. The sphere
 * in lane l of block b has the index BLOCK_LANES * b + l among all. */
typedef struct {
  float center[3][BLOCK_LANES];
  float radius[BLOCK_LANES];
  PrimitiveTag tags[BLOCK_LANES];
} SphereBlock;
DEVICE_STRUCT_SIZE(SphereBlock, 96);

/* No path from a root to a leaf has more wide nodes than this: a wide node stands for one or more binary ones. */
#define WIDE_MAX_DEPTH 64
/* A traversal that visits one child and keeps the others never keeps more than this. */
#define WIDE_STACK_SIZE (WIDE_MAX_DEPTH * (WIDE_CHILDREN - 1) + 1)

DEVICE_NAMESPACE_END

#endif
