#ifndef LICHTRAUM_SHARED_GEOMETRY_H
#define LICHTRAUM_SHARED_GEOMETRY_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* The kinds of thing a leaf holds. */
#define PRIMITIVE_TRIANGLE 0u
#define PRIMITIVE_SPHERE 1u
#define PRIMITIVE_ELLIPSOID 2u /* a unit shape, as what comes after instances */
#define PRIMITIVE_BOX 3u
#define PRIMITIVE_INSTANCE 4u
/* From here on: what only scenes with SCENE_RARE_SHAPES have. */
#define PRIMITIVE_CYLINDER 5u
#define FIRST_RARE_SHAPE PRIMITIVE_CYLINDER
#define PRIMITIVE_CONE 6u
#define PRIMITIVE_PLANE 7u /* in no box, so beside the hierarchies */

/* Rows of a 3x4 matrix: (row.xyz . p + row.w) is a coordinate of the mapped point. */
typedef struct {
  float4 row_x;
  float4 row_y;
  float4 row_z;
} AffineTransform;
DEVICE_STRUCT_SIZE(AffineTransform, 48);

/* What every primitive ends with. */
typedef struct {
  uint material; /* index into the materials */
  uint shape;    /* which shape of the scene graph it came from: for object ids */
} PrimitiveTag;
DEVICE_STRUCT_SIZE(PrimitiveTag, 8);

typedef struct {
  float vertices[3][3]; /* a, b, c: x, y, z in the frame of the object */
  PrimitiveTag tag;
} TrianglePrimitive;
DEVICE_STRUCT_SIZE(TrianglePrimitive, 44);
DEVICE_PRIMITIVE(TrianglePrimitive, PRIMITIVE_TRIANGLE);

/* A sphere that its transforms left a sphere. */
typedef struct {
  float center[3];
  float radius; /* > 0 */
  PrimitiveTag tag;
} SpherePrimitive;
DEVICE_STRUCT_SIZE(SpherePrimitive, 24);
DEVICE_PRIMITIVE(SpherePrimitive, PRIMITIVE_SPHERE);

/* A shape that has one size in a frame of its own, under an affine map. Which shape, its kind says. */
typedef struct {
  AffineTransform unit_from_object;
  PrimitiveTag tag;
  uint padding[2];
} UnitShape;
DEVICE_STRUCT_SIZE(UnitShape, 64);

/* The sphere of radius 1 around the origin. */
DEVICE_UNIT_SHAPE(EllipsoidPrimitive, PRIMITIVE_ELLIPSOID);
/* Radius 1 around the y axis, from y = 0 to y = 1, with both ends. */
DEVICE_UNIT_SHAPE(CylinderPrimitive, PRIMITIVE_CYLINDER);
/* Around the y axis, of radius 1 at y = 0, with an end there, and its tip at y = 1. */
DEVICE_UNIT_SHAPE(ConePrimitive, PRIMITIVE_CONE);
/* y = 0, without an end. */
DEVICE_UNIT_SHAPE(PlanePrimitive, PRIMITIVE_PLANE);

/* Axis-parallel in a frame of its own; flat where min == max. The frame is the box's own as written, so that a flat box
 * needs no singular matrix. */
typedef struct {
  AffineTransform box_from_object;
  float min[3];
  float max[3];
  PrimitiveTag tag;
} BoxPrimitive;
DEVICE_STRUCT_SIZE(BoxPrimitive, 80);
DEVICE_PRIMITIVE(BoxPrimitive, PRIMITIVE_BOX);

/* One occurrence of a shared object in the world. */
typedef struct {
  AffineTransform object_from_world;
  uint root_node; /* of the object's hierarchy */
  uint padding[3];
} Instance;
DEVICE_STRUCT_SIZE(Instance, 64);

DEVICE_NAMESPACE_END

#endif
