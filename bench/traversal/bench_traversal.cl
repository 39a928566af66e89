/* What bench_traversal measures: rays are made where they are traced; each writes what it met. Free rays are traced in
 * batches, as integrators have them. */
#include "program.clh"

#include "camera/generate_rays.clh"

typedef struct {
  float t; /* INFINITY: nothing */
  uint primitive;
  uint instance;
} BenchHit;

static inline BenchHit bench_hit(Scene const* scene, Hit hit) {
  BenchHit out = {INFINITY, 0xffffffffu, NO_INSTANCE};
  if (hit.kind != NO_PRIMITIVE) {
    out.t = hit.t;
    out.primitive = hit.index;
    out.instance = hit.instance;
  }
  return out;
}

static inline Ray camera_ray(__global ProjectiveCamera const* camera, float x, float y) {
  return make_ray(camera->origin.xyz,
                  add_scaled(add_scaled(camera->corner.xyz, x, camera->step_x.xyz), y, camera->step_y.xyz));
}

#ifndef TRACE_PACKETS

__kernel void primary(SCENE_PARAMETERS, __global ProjectiveCamera const* camera, uint const width,
                      float const pixels_per_ray, __global BenchHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  uint const x = (uint)get_global_id(0);
  uint const y = (uint)get_global_id(1);
  Ray const ray = camera_ray(camera, ((float)x + 0.5f) * pixels_per_ray, ((float)y + 0.5f) * pixels_per_ray);
  hits[y * width + x] = bench_hit(&scene, trace_closest(&scene, ray, INFINITY));
}

__kernel void shadow(SCENE_PARAMETERS, __global float4 const* points, float4 const light, uint const width,
                     __global uchar* occluded) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  uint const i = (uint)(get_global_id(1) * width + get_global_id(0));
  float4 const point = points[i];
  bool hidden = false;
  if (point.w > 0.f) {
    hidden = trace_any(&scene, make_ray(point.xyz, light.xyz - point.xyz), 1.f);
  }
  occluded[i] = hidden ? 1 : 0;
}

#else

static inline BenchHit packet_hit(Packet const* p, uint ray) {
  BenchHit const out = {((float const*)p->t)[ray], ((uint const*)p->primitive)[ray] & WIDE_INDEX_MASK,
                        ((uint const*)p->instance)[ray]};
  BenchHit const none = {INFINITY, 0xffffffffu, NO_INSTANCE};
  return out.t < INFINITY ? out : none;
}

/* One work-item a packet. */
__kernel void primary(SCENE_PARAMETERS, __global ProjectiveCamera const* camera, uint const width,
                      float const pixels_per_ray, __global BenchHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  uint const x = (uint)get_global_id(0) * PACKET_SIDE;
  uint const y = (uint)get_global_id(1) * PACKET_SIDE;
  Packet packet;
  packet.origin = camera->origin.xyz;
  packet.t_min = 0.f;
  for (uint group = 0u; group < PACKET_GROUPS; ++group) {
    uint const first = group * PACKET_LANES;
    float16 const px = (lane_columns() + ((float)(x + batch_column(first)) + 0.5f)) * pixels_per_ray;
    float16 const py = (lane_rows() + ((float)(y + batch_row(first)) + 0.5f)) * pixels_per_ray;
    packet.direction[group] = add_scaled(add_scaled(broadcast3(camera->corner.xyz), px, broadcast3(camera->step_x.xyz)),
                                         py, broadcast3(camera->step_y.xyz));
    packet.limit[group] = (float16)(INFINITY);
  }
  trace_packet_closest(&scene, &packet);
  for (uint ray = 0u; ray < BATCH; ++ray) {
    uint const column = x + batch_column(ray);
    uint const row = y + batch_row(ray);
    hits[row * width + column] = packet_hit(&packet, ray);
  }
}

__kernel void shadow(SCENE_PARAMETERS, __global float4 const* points, float4 const light, uint const width,
                     __global uchar* occluded) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  uint const x = (uint)get_global_id(0) * PACKET_SIDE;
  uint const y = (uint)get_global_id(1) * PACKET_SIDE;
  Packet packet;
  packet.origin = light.xyz;
  packet.t_min = 0.f;
  float* directions = (float*)packet.direction;
  float* limits = (float*)packet.limit;
  for (uint ray = 0u; ray < BATCH; ++ray) {
    float4 const point = points[(y + batch_row(ray)) * width + x + batch_column(ray)];
    uint const group = ray / PACKET_LANES;
    uint const lane = ray % PACKET_LANES;
    directions[(3u * group + 0u) * PACKET_LANES + lane] = point.x - light.x;
    directions[(3u * group + 1u) * PACKET_LANES + lane] = point.y - light.y;
    directions[(3u * group + 2u) * PACKET_LANES + lane] = point.z - light.z;
    limits[ray] = point.w > 0.f ? 1.f : -1.f;
  }
  trace_packet_any(&scene, &packet);
  for (uint ray = 0u; ray < BATCH; ++ray) {
    uint const i = (y + batch_row(ray)) * width + x + batch_column(ray);
    occluded[i] = ((float const*)packet.t)[ray] == -INFINITY ? 1 : 0;
  }
}

#endif

/* One work-item a run of rays. */
static inline void load_batch(__global float4 const* origins, __global float4 const* directions, size_t first,
                              uint count, float t_max, RayBatch* rays) {
  for (uint i = 0u; i < count; ++i) {
    float3 const direction = directions[first + i].xyz;
    bool const exists = direction.x != 0.f || direction.y != 0.f || direction.z != 0.f;
    set_ray(rays, i, make_ray(origins[first + i].xyz, direction), exists ? t_max : 0.f);
  }
  rays->count = count;
  rays->is_from_one_point = false;
}

__kernel void closest(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                      __global BenchHit* hits) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const begin = get_global_id(0) * FREE_RAYS_PER_ITEM;
  for (size_t first = begin; first < begin + FREE_RAYS_PER_ITEM; first += BATCH) {
    RayBatch rays;
    HitBatch found;
    load_batch(origins, directions, first, BATCH, INFINITY, &rays);
    trace_closest_batch(&scene, &rays, &found);
    for (uint i = 0u; i < BATCH; ++i) {
      hits[first + i] = bench_hit(&scene, hit_of(&found, i));
    }
  }
}

__kernel void any_hit(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                      float const t_max, __global uchar* occluded) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const begin = get_global_id(0) * FREE_RAYS_PER_ITEM;
  for (size_t first = begin; first < begin + FREE_RAYS_PER_ITEM; first += BATCH) {
    RayBatch rays;
    float3 visibility[MOST_RAYS];
    load_batch(origins, directions, first, BATCH, t_max, &rays);
    trace_visibility_batch(&scene, &rays, visibility);
    for (uint i = 0u; i < BATCH; ++i) {
      occluded[first + i] = visibility[i].x < 1.f ? 1 : 0;
    }
  }
}
