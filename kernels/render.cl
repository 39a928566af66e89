/* Pictures: one work-item a pixel of a tile, in a 2D range rounded up to the work-group's size.
 *
 * `film` is the whole picture, height x width x 3 floats, row 0 at the top. It holds the sum of the samples so far;
 * they are added one by one in their order, and with the last of frame->sample_count the mean is taken, tone mapped and
 * transferred in place. So the bytes are the same however pixels and samples are cut into tiles, as long as each
 * pixel's samples are launched in order, starting with sample 0.
 *
 * `rays` says how many rays this launch traced: one entry a pixel of the tile, row by row.
 *
 * An array of the scene without elements may be any buffer, but not null. Compile with -D RAY_STACK_SIZE=n, n >
 * frame->max_depth (8 without). */
#include "camera/generate_ray.clh"
#include "film/tone_map.clh"
#include "integrators/whitted.clh"
#include "scene.clh"
#include "shared/frame.h"

__kernel void render_tile(__global FrameParameters const* frame, Tile const tile, __global BvhNode const* nodes,
                          __global PrimitiveReference const* references, __global TrianglePrimitive const* triangles,
                          __global SpherePrimitive const* spheres, __global EllipsoidPrimitive const* ellipsoids,
                          __global BoxPrimitive const* boxes, __global Instance const* instances,
                          __global PhongMaterial const* materials, __global PointLight const* lights,
                          __global float* film, __global WorkItemRays* rays) {
  uint const column = (uint)get_global_id(0);
  uint const row = (uint)get_global_id(1);
  if (column >= tile.width || row >= tile.height) {
    return;
  }
  Scene const scene = {nodes,     references, triangles,          spheres,          ellipsoids,        boxes, instances,
                       materials, lights,     frame->light_count, frame->root_node, frame->ray_epsilon};
  uint const x = tile.x + column;
  uint const y = tile.y + row;
  __global float* pixel = film + 3 * ((size_t)y * frame->width + x);
  float3 sum = tile.first_sample == 0u ? (float3)(0.f) : (float3)(pixel[0], pixel[1], pixel[2]);
  WorkItemRays counts = {0u, 0u, 0u, 0u};
  uint const end_sample = tile.first_sample + tile.sample_count;
  for (uint sample = tile.first_sample; sample < end_sample; ++sample) {
    float2 const offset = sample_in_pixel(frame, x, y, sample);
    Ray const ray = generate_camera_ray(frame->camera, (float)x + offset.x, (float)y + offset.y);
    sum += trace_whitted(&scene, frame, ray, &counts);
  }
  if (end_sample == frame->sample_count) {
    float3 const mean = sum / (float)frame->sample_count;
    sum = (float3)(develop_channel(mean.x, frame->tone_map, frame->transfer),
                   develop_channel(mean.y, frame->tone_map, frame->transfer),
                   develop_channel(mean.z, frame->tone_map, frame->transfer));
  }
  pixel[0] = sum.x;
  pixel[1] = sum.y;
  pixel[2] = sum.z;
  rays[(size_t)row * tile.width + column] = counts;
}
