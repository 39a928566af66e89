/* Which light a light tree chooses, for LANES points a work-item. */
#include "lights/emissive_triangle.clh"
#include "lights/light_tree.clh"

/* `choices`: the point's, below 1. Numbers, and as x and y the probability and the importance. */
__kernel void probe_choose(SCENE_PARAMETERS, __global float4 const* positions, __global float4 const* normals,
                           __global float const* choices, __global uint* numbers, __global float2* chances) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const first = get_global_id(0) * LANES;
  Real3 position, normal;
  Real choice;
  for (uint lane = 0u; lane < LANES; ++lane) {
    set_lane3(&position, lane, positions[first + lane].xyz);
    set_lane3(&normal, lane, normals[first + lane].xyz);
    LANE_FLOAT(choice, lane) = choices[first + lane];
  }
  /* A lane without a point must not be touched. */
  Mask lanes = choice >= 0.f;
  LightTreeChoice chosen = choose_in_light_tree(&scene, lanes, position, normal, choice);
  for (uint lane = 0u; lane < LANES; ++lane) {
    numbers[first + lane] = LANE_WORD(chosen.number, lane);
    float const probability = LANE_MASK(chosen.is_in_tree, lane) != 0 ? LANE_FLOAT(chosen.probability, lane) : 0.f;
    chances[first + lane] = (float2)(probability, LANE_FLOAT(chosen.importance, lane));
  }
}

/* The world's areas of the scene's first triangle: of itself, and of its instances. */
__kernel void probe_area(SCENE_PARAMETERS, __global float* areas) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Hit const hit = {1.f, PRIMITIVE_TRIANGLE, 0u, i > 0u ? (uint)i - 1u : NO_INSTANCE};
  areas[i] = world_area(&scene, hit);
}
