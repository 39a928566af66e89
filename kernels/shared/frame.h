#ifndef LICHTRAUM_SHARED_FRAME_H
#define LICHTRAUM_SHARED_FRAME_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

/* A camera, prepared for one resolution (pbrt 5.2). Through the image point (x, y), in pixels from the top left, goes
 * the ray from the origin in the direction  corner + x * step_x + y * step_y;  of an orthographic camera, the ray from
 * origin + corner + x * step_x + y * step_y  in the same direction as all. In the world; no direction is normalised. */
typedef struct {
  float4 origin;    /* w unused */
  float4 corner;    /* w unused */
  float4 step_x;    /* w unused */
  float4 step_y;    /* w unused */
  float4 direction; /* of an orthographic camera's rays; w unused */
  uint is_orthographic;
  uint padding[3];
} ProjectiveCamera;
DEVICE_STRUCT_SIZE(ProjectiveCamera, 96);

/* A thin lens, in the world: a pinhole's ray with the origin o and the direction d begins at o + u * across + v * up
 * instead, with (u, v) in the unit disc, and goes through o + focus * d (pbrt 5.2.3). */
typedef struct {
  float4 across; /* as long as the lens's radius, 0 of a pinhole; w unused */
  float4 up;     /* the same; w unused */
  float focus;   /* in units of the directions of a pinhole's rays */
  uint has_area; /* 0: a pinhole */
  uint padding[2];
} ThinLens;
DEVICE_STRUCT_SIZE(ThinLens, 48);

#define SAMPLING_GRID 0u
#define SAMPLING_SEEDED 1u
#define SAMPLING_SOBOL 2u

#define BACKGROUND_COLORS 0u
#define BACKGROUND_ENVIRONMENT 1u

#define GROUND_NONE 0u
#define GROUND_MATT 1u
#define GROUND_GLOSSY 2u

/* Everything about the picture that is the same for each of its pixels. */
typedef struct {
  ProjectiveCamera camera;
  ThinLens lens;
  float4 ambient;         /* sum of all La; w unused */
  float4 background;      /* what mirrors and glass show where nothing is; w unused */
  float4 background_top;  /* what the camera's rays see, at the picture's upper edge; w unused */
  float4 background_step; /* and by how much more a pixel further down; w unused */
  uint region_x;          /* of the film, pixels in the picture */
  uint region_y;
  uint region_width;
  uint region_height;
  uint sampling;     /* SAMPLING_... */
  uint sample_count; /* per pixel, in all; a square number for a grid */
  uint seed_low;
  uint seed_high;
  uint max_depth;
  uint background_kind; /* BACKGROUND_... */
  float max_indirect;   /* of paths, see RenderRequest; may be INFINITY */
  uint ground;          /* GROUND_... */
  float4 ground_plane;  /* unit normal, upwards, and how far along it the plane lies from the world's origin */
} FrameParameters;
DEVICE_STRUCT_SIZE(FrameParameters, 272);

/* What one launch computes: a rectangle of pixels, a range of their samples. */
typedef struct {
  uint x;
  uint y;
  uint width;
  uint height;
  uint first_sample;
  uint sample_count;
  uint padding[2];
} Tile;
DEVICE_STRUCT_SIZE(Tile, 32);

/* How many rays of each kind one work-item traced. */
typedef struct {
  uint camera_hits;
  uint shadow;
  uint secondary;
  uint not_finite; /* samples that were left out */
} WorkItemRays;
DEVICE_STRUCT_SIZE(WorkItemRays, 16);

DEVICE_NAMESPACE_END

#endif
