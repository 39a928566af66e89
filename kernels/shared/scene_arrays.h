#ifndef LICHTRAUM_SHARED_SCENE_ARRAYS_H
#define LICHTRAUM_SHARED_SCENE_ARRAYS_H

#include "shared/alias_table.h"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/pbr_material.h"
#include "shared/phong_material.h"
#include "shared/texture.h"
#include "shared/vertex.h"
#include "shared/wide.h"

/* Every array of a scene that kernels read, written down once: ARRAY(type of an element, name). From these lists come
 * the struct Scene and the parameters of kernels (scene.clh), what the host fills (src/compile/scene_arrays.hpp) and
 * uploads, probes and benchmarks. */

/* Primitives that the wide layout stores in blocks ... */
#define BLOCK_PRIMITIVE_ARRAYS(ARRAY) \
  ARRAY(TrianglePrimitive, triangles) \
  ARRAY(SpherePrimitive, spheres)

/* ... and those that both layouts store alike: one struct for all unit shapes ... */
#define UNIT_SHAPE_ARRAYS(ARRAY)        \
  ARRAY(EllipsoidPrimitive, ellipsoids) \
  ARRAY(CylinderPrimitive, cylinders)   \
  ARRAY(ConePrimitive, cones)           \
  ARRAY(PlanePrimitive, planes)

/* ... and the others. */
#define SINGLE_PRIMITIVE_ARRAYS(ARRAY) \
  UNIT_SHAPE_ARRAYS(ARRAY)             \
  ARRAY(BoxPrimitive, boxes)

#define PRIMITIVE_ARRAYS(ARRAY) BLOCK_PRIMITIVE_ARRAYS(ARRAY) SINGLE_PRIMITIVE_ARRAYS(ARRAY)

/* The tree, with what is stored as the layout has it: of the binary tree ... */
#define BINARY_TREE_ARRAYS(ARRAY)       \
  ARRAY(BvhNode, nodes)                 \
  ARRAY(PrimitiveReference, references) \
  BLOCK_PRIMITIVE_ARRAYS(ARRAY)

/* ... and of the wide one. */
#define WIDE_TREE_ARRAYS(ARRAY)                                \
  ARRAY(WideNode, wide_nodes)                                  \
  ARRAY(TriangleBlock, triangle_blocks)                        \
  ARRAY(PrimitiveTag, triangle_tags) /* BLOCK_LANES a block */ \
  ARRAY(SphereBlock, sphere_blocks)

#define SHAPE_ARRAYS(ARRAY)                                                                               \
  SINGLE_PRIMITIVE_ARRAYS(ARRAY)                                                                          \
  ARRAY(Instance, instances)                                                                              \
  ARRAY(TriangleAttributes, triangle_attributes) /* one a triangle, as the layout counts them; or none */ \
  ARRAY(uint, sphere_colors)    /* 1 + where in the vertex data rgba of a sphere begin, as the layout */  \
  ARRAY(uint, ellipsoid_colors) /* counts them, and of an ellipsoid; 0: none; or none */                  \
  ARRAY(uint, cylinder_colors)  /* the same of a cylinder: two colours, of its ends */                    \
  ARRAY(float, vertex_data)                                                                               \
  ARRAY(EmissiveTriangle, emissive_triangles)                                                             \
  ARRAY(EmissiveSolid, emissive_solids)

#define TEXTURE_ARRAYS(ARRAY) \
  ARRAY(Texture, textures)    \
  ARRAY(uint, texels)

/* What surfaces and lights are like: all that can change without a look at shapes and textures. */
#define SHADING_ARRAYS(ARRAY)                                                                                 \
  ARRAY(PhongMaterial, materials)                                                                             \
  ARRAY(PbrMaterial, pbr_materials) /* as many as materials, or none */                                       \
  ARRAY(PunctualLight, lights)                                                                                \
  ARRAY(AliasEntry, light_choices)  /* of what lights the scene: lights, environment, emissive shapes */      \
  ARRAY(float, light_probabilities) /* with which each is chosen */                                           \
  ARRAY(LightTreeNode, light_tree)  /* of those that have a place, where they are many or not alone */        \
  ARRAY(float, emission_densities)  /* of materials: of their triangles' points to be chosen, per world area; \
                                       with a tree, in it, from where all its lights are as important as 1 */

/* What arrives from infinitely far away (lights/environment.clh); none of them has elements where nothing does. */
#define ENVIRONMENT_ARRAYS(ARRAY)                                                     \
  ARRAY(float, environment_texels)       /* rgb, row by row from the top: radiance */ \
  ARRAY(AliasEntry, environment_rows)    /* choose a row ... */                       \
  ARRAY(AliasEntry, environment_columns) /* ... and in it a column; one a texel */    \
  ARRAY(float, environment_densities)    /* one a texel: what environment_pdf says of it */

DEVICE_NAMESPACE_BEGIN

/* What kernels know of a scene besides its arrays. */
typedef struct {
  uint root_node; /* of the world's hierarchy */
  uint light_count;
  uint light_choice_count;
  uint emissive_triangle_count;
  uint emissive_solid_count;
  float environment_probability; /* to be chosen of the lights, or with a tree of those that are not in it */
  float distant_importance;      /* of these, as the tree's is told; below 0: there is no tree */
  uint features;                 /* SCENE_... */
  float ray_epsilon; /* how far, relative to its coordinates, a computed hit point may lie off its surface */
  /* The environment; all 0 where there is none. */
  uint environment_width; /* texels */
  uint environment_height;
  float map_from_world[3][3];      /* a rotation: of directions, to the map's; by rows */
  float environment_brightness;    /* what its radiance is multiplied by */
  float environment_power;         /* the mean luminance of that, over the sphere, times 4 pi; 0: black */
  float environment_sampled_power; /* what of it environment_sample draws from; 0: it draws nothing */
  float environment_poles[6];      /* rgb at the top, and at the bottom: the mean of the first row, and of the last */
  float environment_on_level[3];   /* its irradiance on a level surface, from above, over pi */
} SceneConstants;
DEVICE_STRUCT_SIZE(SceneConstants, 128);

/* For SceneConstants.ray_epsilon: 16 rounding units of float, several times what the device code can be off. */
#define DEFAULT_RAY_EPSILON 9.5367431640625e-7f

/* SceneConstants.features: what some of the scene has. What none of it has costs no time. */
#define SCENE_TRANSPARENCY 1u /* a material lets light through */
#define SCENE_CUTOUTS 2u      /* a material is there, or lets light through, in some points only */
#define SCENE_ATTRIBUTES 4u   /* vertices have normals, texture coordinates or colours, also of points and lines */
#define SCENE_PBR 8u          /* a material is derived from a physically based one */
#define SCENE_LIGHT_KINDS 16u /* a light is not LIGHT_CONSTANT */
#define SCENE_RARE_SHAPES 32u /* a shape is of a kind from FIRST_RARE_SHAPE on */
#define SCENE_ENVIRONMENT 64u /* light arrives from infinitely far away */
#define SCENE_TANGENTS 128u   /* a material is anisotropic, or its coat has a normal of its own */
#define SCENE_PANES 256u      /* light goes straight on through a wall (materials/pane.clh); for paths only */
/* What remains where no model and no rare shape is: what eSDF's usual shapes, materials and lights can have. */
#define SCENE_WITHOUT_MODELS SCENE_TRANSPARENCY

DEVICE_NAMESPACE_END

#endif
