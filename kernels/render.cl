/* Pictures: one work-item a pixel of a tile (or, for packets, a square of PACKET_SIDE x PACKET_SIDE pixels, at
 * multiples of that from the picture's corner), in a 2D range rounded up to the work-group's size.
 *
 * `film` is the whole picture, height x width x 3 floats, row 0 at the top. It holds the sum of the samples so far;
 * they are added one by one in their order, and with the last of frame->sample_count the mean is taken, tone mapped and
 * transferred in place. So the bytes are the same however pixels and samples are cut into tiles, as long as each
 * pixel's samples are launched in order, starting with sample 0.
 *
 * `rays` says how many rays this launch traced: one entry a work-item, row by row.
 *
 * With -D FIRST_SURFACE it is a program that writes what frame->aov says instead, of one sample; not for packets.
 *
 * Compile with -D RAY_STACK_SIZE=n, n > frame->max_depth (8 without), and with the layout (see
 * traversal/traversal.clh), on which the arrays of the tree depend. */
#include "camera/generate_rays.clh"
#include "film/tone_map.clh"
#include "integrators/whitted.clh"
#ifdef FIRST_SURFACE
#include "integrators/first_surface.clh"
#endif

/* Adds a sample to a pixel's sum; with the last one the pixel is finished. */
static inline void finish_pixel(__global FrameParameters const* frame, bool is_last, __global float* pixel,
                                float3 sum) {
  if (is_last) {
    float3 const mean = sum / (float)frame->sample_count;
    sum = (float3)(develop_channel(mean.x, frame->tone_map, frame->transfer),
                   develop_channel(mean.y, frame->tone_map, frame->transfer),
                   develop_channel(mean.z, frame->tone_map, frame->transfer));
  }
  pixel[0] = sum.x;
  pixel[1] = sum.y;
  pixel[2] = sum.z;
}

__kernel void render_tile(SCENE_PARAMETERS, __global FrameParameters const* frame, Tile const tile,
                          __global float* film, __global WorkItemRays* rays) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  uint const end_sample = tile.first_sample + tile.sample_count;
  bool const is_last = end_sample == frame->sample_count;
  WorkItemRays counts = {0u, 0u, 0u, 0u};
  uint const column = (uint)get_global_id(0);
  uint const row = (uint)get_global_id(1);
  /* Squares lie on a grid of the picture, whatever the tile: so which rays share a packet does not depend on it. */
  uint const corner_x = (tile.x / BATCH_SIDE + column) * BATCH_SIDE;
  uint const corner_y = (tile.y / BATCH_SIDE + row) * BATCH_SIDE;
  uint const work_items_a_row = (tile.x + tile.width + BATCH_SIDE - 1u) / BATCH_SIDE - tile.x / BATCH_SIDE;
  if (corner_x >= tile.x + tile.width || corner_y >= tile.y + tile.height) {
    return;
  }
  Wave wave;
  Real3 sums[BATCH_GROUPS];
  Real3 radiance[BATCH_GROUPS];
  for (uint i = 0u; i < BATCH; ++i) {
    uint const x = corner_x + batch_column(i);
    uint const y = corner_y + batch_row(i);
    bool const has_sum = tile.first_sample > 0u && is_in_tile(&tile, x, y);
    __global float const* pixel = film + (has_sum ? 3 * ((size_t)y * frame->width + x) : 0);
    set_lane3(&sums[i / LANES], i % LANES, has_sum ? (float3)(pixel[0], pixel[1], pixel[2]) : (float3)(0.f));
  }
  for (uint sample = tile.first_sample; sample < end_sample; ++sample) {
    generate_camera_rays(frame, &tile, corner_x, corner_y, sample, &wave.rays);
#ifdef FIRST_SURFACE
    trace_first_surface(&scene, frame, &wave.rays, radiance, &counts);
#else
    trace_whitted(&scene, frame, &wave, radiance, &counts);
#endif
    for (uint group = 0u; group < BATCH_GROUPS; ++group) {
      sums[group] = add3(sums[group], radiance[group]);
    }
  }
  for (uint i = 0u; i < BATCH; ++i) {
    uint const x = corner_x + batch_column(i);
    uint const y = corner_y + batch_row(i);
    if (is_in_tile(&tile, x, y)) {
      __global float* pixel = film + 3 * ((size_t)y * frame->width + x);
      finish_pixel(frame, is_last, pixel, lane_of3(&sums[i / LANES], i % LANES));
    }
  }
  rays[(size_t)row * work_items_a_row + column] = counts;
}
