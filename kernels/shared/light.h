#ifndef LICHTRAUM_SHARED_LIGHT_H
#define LICHTRAUM_SHARED_LIGHT_H

#include "shared/geometry.h"
#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

#define LIGHT_CONSTANT 0u    /* a point; as bright at any distance */
#define LIGHT_FALLS_OFF 1u   /* a point or spot */
#define LIGHT_DIRECTIONAL 2u /* from infinitely far away */

/* KHR_lights_punctual has the formulae. */
typedef struct {
  uint kind;           /* LIGHT_... */
  uint is_near;        /* its position is near enough to the scene that shadow rays may start there */
  float ld[3];         /* rgb: what arrives, of one that falls off at distance 1 */
  float position[3];   /* world; not of a directional light */
  float direction[3];  /* unit, where a spot or directional light shines */
  float inverse_range; /* falls off to nothing at 1 / this */
  float cone_scale;    /* brightness in a cone: (cosine * scale + offset)^2, clamped to 0..1; 0 and 1 without cone */
  float cone_offset;
  float radius; /* of the disc as which points see it; 0: a point */
} PunctualLight;
DEVICE_STRUCT_SIZE(PunctualLight, 60);

/* A triangle that shines, once for each instance of it: corner + u * edges[0] + v * edges[1]. They are in an order that
 * does not depend on the layout of the hierarchy. */
typedef struct {
  float corner[3];   /* world */
  float edges[2][3]; /* world */
  uint triangle;     /* among all, for what its vertices have */
  uint material;
} EmissiveTriangle;
DEVICE_STRUCT_SIZE(EmissiveTriangle, 44);

/* A sphere, an ellipsoid or a box that shines, once for each instance of it. They are in the order of instance, kind
 * and index. */
typedef struct {
  AffineTransform unit_from_world; /* of a sphere or an ellipsoid: the ball of radius 1 around the origin */
  float center[3];                 /* world */
  float axes[3][3];                /* world: half a box's edges; the maps of x, y and z of the ball's frame */
  uint instance;                   /* as in a hit */
  uint kind;
  uint index;
  uint material;
} EmissiveSolid;
DEVICE_STRUCT_SIZE(EmissiveSolid, 112);

/* Of a light tree (lights/light_tree.clh): so many children a node, each in a ball; light or lights. */
#define LIGHT_TREE_CHILDREN 16
typedef struct {
  float center[3][LIGHT_TREE_CHILDREN]; /* world */
  float radius[LIGHT_TREE_CHILDREN];    /* > 0 */
  float axis[3][LIGHT_TREE_CHILDREN];   /* unit: the normal of flat lights, which shine to both sides, on the average */
  float spread[LIGHT_TREE_CHILDREN]; /* how far their normals' tips are from the axis', at most; 1: any way, and no axis
                                      */
  float intensity[LIGHT_TREE_CHILDREN]; /* of all lights' sum; 0: there is no child */
  uint children[LIGHT_TREE_CHILDREN];   /* nodes; or a light's number, and LIGHT_TREE_LEAF */
} LightTreeNode;
DEVICE_STRUCT_SIZE(LightTreeNode, 640);
#define LIGHT_TREE_LEAF 0x80000000u

DEVICE_NAMESPACE_END

#endif
