#include "lights/punctual_light.clh"

__kernel void probe_sample_texture(__global Texture const* textures, __global uint const* texels,
                                   __global TextureSlot const* slots, __global float2 const* coordinates, uint content,
                                   __global float4* samples) {
  size_t const i = get_global_id(0);
  Scene scene;
  scene.textures = textures;
  scene.texels = texels;
  samples[i] = sample_texture(&scene, slots[i].texture, slot_coordinate(slots + i, coordinates[i]), content);
}

/* Reads materials back as what they are: words. */
__kernel void probe_pbr_materials(__global PbrMaterial const* materials, __global uint* words) {
  size_t const i = get_global_id(0);
  PbrMaterial const material = materials[i];
  uint const* source = (uint const*)&material;
  for (uint k = 0u; k < sizeof(PbrMaterial) / 4u; ++k) {
    words[i * (sizeof(PbrMaterial) / 4u) + k] = source[k];
  }
}

__kernel void probe_phong_from_pbr(__global PbrPoint const* points, __global PhongMaterial* materials) {
  size_t const i = get_global_id(0);
  PbrPoint const point = points[i];
  materials[i] = phong_from_pbr(&point);
}

__kernel void probe_sample_light(__global PunctualLight const* lights, __global float4 const* positions,
                                 __global float4* to_lights, __global float4* arriving) {
  size_t const i = get_global_id(0);
  PunctualLight const light = lights[i];
  LightSample const sample = sample_light(&light, positions[i].xyz);
  to_lights[i] = (float4)(sample.to_light, sample.distance);
  arriving[i] = (float4)(sample.arriving, 0.f);
}

__kernel void probe_sample_lamp(__global PunctualLight const* lights, __global float4 const* positions,
                                __global float4 const* uniform, __global float4* to_lights, __global float4* arriving) {
  size_t const i = get_global_id(0);
  PunctualLight const light = lights[i];
  LightSample const sample = sample_lamp(&light, positions[i].xyz, uniform[i].x, uniform[i].y);
  to_lights[i] = (float4)(sample.to_light, sample.distance);
  arriving[i] = (float4)(sample.arriving, 0.f);
}
