#include "camera/generate_ray.clh"

__kernel void probe_camera_ray(__global PinholeCamera const* cameras, __global float4 const* points,
                               __global float4* origins, __global float4* directions) {
  size_t const i = get_global_id(0);
  Ray const ray = generate_camera_ray(cameras[i], points[i].x, points[i].y);
  origins[i] = (float4)(ray.origin, 0.f);
  directions[i] = (float4)(ray.direction, 0.f);
}

__kernel void probe_sample_in_pixel(__global FrameParameters const* frame, __global uint4 const* pixel_samples,
                                    __global float2* offsets) {
  size_t const i = get_global_id(0);
  offsets[i] = sample_in_pixel(frame, pixel_samples[i].x, pixel_samples[i].y, pixel_samples[i].z);
}
