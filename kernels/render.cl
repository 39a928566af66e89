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
#include "camera/generate_packet.clh"
#include "camera/generate_ray.clh"
#include "film/tone_map.clh"
#include "integrators/whitted.clh"
#include "integrators/whitted_packet.clh"
#include "scene.clh"
#include "shared/frame.h"
#ifdef FIRST_SURFACE
#include "integrators/first_surface.clh"
#endif

static inline bool is_in_tile(Tile const* tile, uint x, uint y) {
  return x >= tile->x && x < tile->x + tile->width && y >= tile->y && y < tile->y + tile->height;
}

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
#ifdef TRAVERSAL_PACKET
  uint const column = (uint)get_global_id(0);
  uint const row = (uint)get_global_id(1);
  /* Squares lie on a grid of the picture, whatever the tile: so which rays share a packet does not depend on it. */
  uint const corner_x = (tile.x / PACKET_SIDE + column) * PACKET_SIDE;
  uint const corner_y = (tile.y / PACKET_SIDE + row) * PACKET_SIDE;
  uint const work_items_a_row = (tile.x + tile.width + PACKET_SIDE - 1u) / PACKET_SIDE - tile.x / PACKET_SIDE;
  if (corner_x >= tile.x + tile.width || corner_y >= tile.y + tile.height) {
    return;
  }
  Packet packet;
  PacketShading shading;
  Vector16 sums[PACKET_GROUPS];
  for (uint i = 0u; i < PACKET_GROUPS * PACKET_LANES; ++i) {
    uint const x = corner_x + packet_ray_column(i);
    uint const y = corner_y + packet_ray_row(i);
    bool const has_sum = tile.first_sample > 0u && is_in_tile(&tile, x, y);
    __global float const* pixel = film + (has_sum ? 3 * ((size_t)y * frame->width + x) : 0);
    float3 const sum = has_sum ? (float3)(pixel[0], pixel[1], pixel[2]) : (float3)(0.f);
    store_lane(sum, &sums[i / PACKET_LANES], i % PACKET_LANES);
  }
  for (uint sample = tile.first_sample; sample < end_sample; ++sample) {
    generate_camera_packet(frame, &tile, corner_x, corner_y, sample, &packet);
    trace_whitted_packet(&scene, frame, &packet, &shading, &counts);
    for (uint group = 0u; group < PACKET_GROUPS; ++group) {
      sums[group] = add16(sums[group], shading.radiance[group]);
    }
  }
  for (uint i = 0u; i < PACKET_GROUPS * PACKET_LANES; ++i) {
    uint const x = corner_x + packet_ray_column(i);
    uint const y = corner_y + packet_ray_row(i);
    if (is_in_tile(&tile, x, y)) {
      __global float* pixel = film + 3 * ((size_t)y * frame->width + x);
      finish_pixel(frame, is_last, pixel, load_lane(&sums[i / PACKET_LANES], i % PACKET_LANES));
    }
  }
#else
  uint const column = (uint)get_global_id(0);
  uint const row = (uint)get_global_id(1);
  uint const work_items_a_row = tile.width;
  if (column >= tile.width || row >= tile.height) {
    return;
  }
  uint const x = tile.x + column;
  uint const y = tile.y + row;
  __global float* pixel = film + 3 * ((size_t)y * frame->width + x);
  float3 sum = tile.first_sample == 0u ? (float3)(0.f) : (float3)(pixel[0], pixel[1], pixel[2]);
  for (uint sample = tile.first_sample; sample < end_sample; ++sample) {
    float2 const offset = sample_in_pixel(frame, x, y, sample);
    Ray const ray = generate_camera_ray(frame->camera, (float)x + offset.x, (float)y + offset.y);
#ifdef FIRST_SURFACE
    sum = trace_first_surface(&scene, frame, ray, &counts);
#else
    sum += trace_whitted(&scene, frame, ray, &counts);
#endif
  }
  finish_pixel(frame, is_last, pixel, sum);
#endif
  rays[(size_t)row * work_items_a_row + column] = counts;
}
