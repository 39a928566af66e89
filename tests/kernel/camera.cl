#include "camera/generate_rays.clh"

/* Through the only sample of a pixel. */
__kernel void probe_camera_ray(__global FrameParameters const* frames, __global uint2 const* pixels,
                               __global float4* origins, __global float4* directions) {
  size_t const i = get_global_id(0);
  Tile const tile = {pixels[i].x, pixels[i].y, 1u, 1u, 0u, 1u, {0u, 0u}};
  RayBatch rays;
  generate_camera_rays(frames + i, &tile, pixels[i].x, pixels[i].y, 0u, &rays);
  Ray const ray = ray_of(&rays, 0u);
  origins[i] = (float4)(ray.origin, rays.t_max[0]);
  directions[i] = (float4)(ray.direction, 0.f);
}

__kernel void probe_sample_in_grid(uint sample_count, __global uint const* samples, __global float2* offsets) {
  size_t const i = get_global_id(0);
  offsets[i] = sample_in_grid(sample_count, samples[i]);
}

__kernel void probe_seeded_sample(__global FrameParameters const* frame, __global uint4 const* pixel_samples,
                                  __global PixelOffset* offsets) {
  size_t const i = get_global_id(0);
  uint4 const sample = pixel_samples[i];
  offsets[i] = seeded_pixel_offset(sample.x, sample.y, sample.z, frame->seed_low, frame->seed_high);
}
