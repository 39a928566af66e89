/* The traversal interface of one layout, chosen by -D. */
#include "traversal/traversal.clh"

typedef struct {
  float t; /* INFINITY: nothing */
  uint shape;
  uint instance;
  uint padding;
} ProbeHit;

static inline ProbeHit probe_hit(Scene const* scene, Hit hit) {
  ProbeHit out = {INFINITY, 0u, 0u, 0u};
  if (hit.kind != NO_PRIMITIVE) {
    PrimitiveReference const reference = {hit.kind, hit.index};
    out.t = hit.t;
    out.shape = primitive_tag(scene, reference).shape;
    out.instance = hit.instance;
  }
  return out;
}

__kernel void probe_closest(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                            __global ProbeHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  hits[i] = probe_hit(&scene, trace_closest(&scene, make_ray(origins[i].xyz, directions[i].xyz), INFINITY));
}

#ifdef LAYOUT_WIDE
#include "traversal/wide_stream.clh"

#define RAYS_A_STREAM 64u

/* One work-item a stream; the first has one ray in turn, the next two, and so on. */
static void probe_stream(Scene const* scene, __global float4 const* origins, __global float4 const* directions,
                         float t_max, int query, __global ProbeHit* hits, __global float* visibility) {
  uint const places = 1u + (uint)get_global_id(0) % RAYS_IN_TURN;
  uint next = (uint)get_global_id(0) * RAYS_A_STREAM;
  uint const end = next + RAYS_A_STREAM;
  uint numbers[RAYS_IN_TURN];
  RayStream stream;
  clear_stream(&stream);
  for (uint place = 0u; place < places; ++place, ++next) {
    start_ray(scene, &stream, place, make_ray(origins[next].xyz, directions[next].xyz), t_max);
    numbers[place] = next;
  }
  for (uint finished = 0u; finished < RAYS_A_STREAM; ++finished) {
    QueryResult result;
    uint const place = finish_ray(scene, &stream, query, &result);
    if (query == QUERY_CLOSEST) {
      hits[numbers[place]] = probe_hit(scene, result.hit);
    } else {
      visibility[numbers[place]] = result.visibility.x;
    }
    if (next < end) {
      start_ray(scene, &stream, place, make_ray(origins[next].xyz, directions[next].xyz), t_max);
      numbers[place] = next++;
    }
  }
}

__kernel void probe_stream_closest(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                                   __global ProbeHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  probe_stream(&scene, origins, directions, INFINITY, QUERY_CLOSEST, hits, 0);
}
__kernel void probe_stream_visibility(SCENE_PARAMETERS, __global float4 const* origins,
                                      __global float4 const* directions, float const t_max,
                                      __global float* visibility) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  probe_stream(&scene, origins, directions, t_max, QUERY_VISIBILITY, 0, visibility);
}
#endif

/* Bit 0: something lies before t_max; bit 1: something opaque does. */
__kernel void probe_hidden(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                           float const t_max, __global uint* hidden) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  Ray const ray = make_ray(origins[i].xyz, directions[i].xyz);
  hidden[i] = (trace_any(&scene, ray, t_max) ? 1u : 0u) | (trace_visibility(&scene, ray, t_max).x == 0.f ? 2u : 0u);
}

__kernel void probe_visibility(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                               float const t_max, __global float* visibility) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  visibility[i] = trace_visibility(&scene, make_ray(origins[i].xyz, directions[i].xyz), t_max).x;
}

#ifdef TRACE_PACKETS
#include "packet_input.clh"

__kernel void probe_packet_closest(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                                   __global ProbeHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  Packet packet;
  load_packet(&packet, origins, directions, INFINITY);
  trace_packet_closest(&scene, &packet);
  for (uint i = 0u; i < PACKET_GROUPS * PACKET_LANES; ++i) {
    hits[get_global_id(0) * PACKET_GROUPS * PACKET_LANES + i] = probe_hit(&scene, packet_hit(&packet, i));
  }
}

/* Bit 0: something lies before t_max (occluded or filtered); bit 1: something opaque does. */
__kernel void probe_packet_hidden(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                                  float const t_max, __global uint* hidden) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  Packet packet;
  load_packet(&packet, origins, directions, t_max);
  trace_packet_any(&scene, &packet);
  for (uint i = 0u; i < PACKET_GROUPS * PACKET_LANES; ++i) {
    bool const occluded = packet_is_occluded(&packet, i);
    bool const filtered = ((int const*)packet.filtered)[i] != 0;
    hidden[get_global_id(0) * PACKET_GROUPS * PACKET_LANES + i] =
        (occluded || filtered ? 1u : 0u) | (occluded ? 2u : 0u);
  }
}
#endif
