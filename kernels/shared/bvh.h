#ifndef LICHTRAUM_SHARED_BVH_H
#define LICHTRAUM_SHARED_BVH_H

#include "shared/geometry.h"

DEVICE_NAMESPACE_BEGIN

/* A leaf's entry: `index` counts within the array of that kind. */
typedef struct {
  uint kind;
  uint index;
} PrimitiveReference;
DEVICE_STRUCT_SIZE(PrimitiveReference, 8);

/* One end of an edge of the binary tree: the child's bounds and where the child is. A leaf's `count` is > 0, and
 * `first` is its first entry in the primitive references. An inner node's `count` is 0, and `first` is its place in the
 * nodes. An absent child has count 0 and min > max. */
typedef struct {
  float min[3];
  uint first;
  float max[3];
  uint count;
} BvhChild;
DEVICE_STRUCT_SIZE(BvhChild, 32);

typedef struct {
  BvhChild children[2];
} BvhNode;
DEVICE_STRUCT_SIZE(BvhNode, 64);

/* No path from a root to a leaf has more nodes than this: the builder proves it, the traversal's stack relies on it. */
#define BVH_MAX_DEPTH 64

DEVICE_NAMESPACE_END

#endif
