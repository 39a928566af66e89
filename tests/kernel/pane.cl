/* What gets through to t_max, of each colour; in the layout that is chosen by -D. */
#include "traversal/traversal.clh"

__kernel void probe_visibility(SCENE_PARAMETERS, __global float4 const* origins, __global float4 const* directions,
                               float const t_max, __global float4* visibility) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  size_t const i = get_global_id(0);
  visibility[i] = (float4)(trace_visibility(&scene, make_ray(origins[i].xyz, directions[i].xyz), t_max), 0.f);
}
