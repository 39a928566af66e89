/* What is computed for sixteen points at once, next to the same for one. */
#include "integrators/whitted_packet.clh"
#include "packet_input.clh"
#include "traversal/traversal.clh"

static inline bool is_same(float3 a, float3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
static inline bool is_same4(float4 a, float4 b) { return is_same(a.xyz, b.xyz) && a.w == b.w; }

/* A bit for each member that is not what it should be. */
static inline uint compare_points(ShadingPoint const* found, ShadingPoint const* expected) {
  return (is_same(found->position, expected->position) ? 0u : 1u) |
         (is_same(found->geometric_normal, expected->geometric_normal) ? 0u : 2u) |
         (is_same(found->normal, expected->normal) ? 0u : 4u) |
         (is_same(found->to_viewer, expected->to_viewer) ? 0u : 8u) |
         (is_same4(found->phong.kd, expected->phong.kd) ? 0u : 16u) |
         (is_same4(found->phong.ks, expected->phong.ks) ? 0u : 32u) |
         (found->phong.ka.w == expected->phong.ka.w && found->phong.ior == expected->phong.ior ? 0u : 64u) |
         (found->offset == expected->offset ? 0u : 128u) | (found->from_outside == expected->from_outside ? 0u : 256u) |
         (found->is_bent == expected->is_bent ? 0u : 512u);
}

typedef struct {
  uint kind;      /* PRIMITIVE_..., or NO_PRIMITIVE */
  uint different; /* bits; see compare_points, and below */
  uint lit;       /* the light adds something */
} ProbePoint;

__kernel void probe_points(SCENE_PARAMETERS, __global FrameParameters const* frame, __global float4 const* origins,
                           __global float4 const* directions, float4 const light, __global ProbePoint* out) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  Packet packet;
  PacketShading shading;
  WorkItemRays rays = {0u, 0u, 0u, 0u};
  load_packet(&packet, origins, directions, INFINITY);
  trace_packet_closest(&scene, &packet);
  find_seen_points(&scene, frame, &packet, &shading, &rays);
  for (uint i = 0u; i < PACKET_GROUPS * PACKET_LANES; ++i) {
    uint const group = i / PACKET_LANES;
    uint const lane = i % PACKET_LANES;
    PacketPoints const* points = &shading.points[group];
    Hit const hit = packet_hit(&packet, i);
    float3 const radiance = load_lane(&shading.radiance[group], lane);
    ProbePoint result = {hit.kind, 0u, 0u};
    if (hit.kind == NO_PRIMITIVE) {
      result.different = LANE_INT(points->hit, lane) == 0 && is_same(radiance, frame->background.xyz) ? 0u : 1u;
    } else {
      Ray const ray = make_ray(packet.origin, packet_direction(&packet, i));
      ShadingPoint const expected = find_shading_point(&scene, ray, hit);
      ShadingPoint const found = load_point(points, lane);
      result.different = compare_points(&found, &expected) | (LANE_INT(points->hit, lane) != 0 ? 0u : 1024u) |
                         (is_same(radiance, unshadowed_radiance(frame, &expected.phong)) ? 0u : 2048u);
      float3 const to_light = unit_vector(light.xyz - expected.position);
      Vector16 const to_light16 = unit_vector16(subtract16(broadcast16(light.xyz), points->position));
      Vector16 const reflected16 = reflect_light16(points, to_light16);
      float3 const reflected = reflect_light(&expected.phong, expected.normal, to_light, expected.to_viewer);
      result.different |= is_same(load_lane(&reflected16, lane), reflected) ? 0u : 4096u;
      result.lit = is_black(reflected) ? 0u : 1u;
    }
    out[get_global_id(0) * PACKET_GROUPS * PACKET_LANES + i] = result;
  }
}
