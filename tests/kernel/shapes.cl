#include "math/affine.clh"
#include "shapes/box.clh"
#include "shapes/cone.clh"
#include "shapes/cylinder.clh"
#include "shapes/ellipsoid.clh"
#include "shapes/plane.clh"
#include "shapes/sphere.clh"
#include "shapes/triangle.clh"

typedef struct {
  float4 origin;
  float4 direction;
} ProbeRay;

static inline Ray load_ray(ProbeRay ray) { return make_ray(ray.origin.xyz, ray.direction.xyz); }

__kernel void probe_sphere(__global SpherePrimitive const* spheres, __global ProbeRay const* rays,
                           __global float const* t_max, __global float* t) {
  size_t const i = get_global_id(0);
  t[i] = intersect_sphere(sphere_of(spheres + i), load_ray(rays[i]), t_max[i]);
}

__kernel void probe_ellipsoid(__global EllipsoidPrimitive const* ellipsoids, __global ProbeRay const* rays,
                              __global float const* t_max, __global float* t) {
  size_t const i = get_global_id(0);
  t[i] = intersect_ellipsoid(ellipsoids + i, load_ray(rays[i]), t_max[i]);
}

__kernel void probe_cylinder(__global UnitShape const* shapes, __global ProbeRay const* rays,
                             __global float const* t_max, __global float* t) {
  size_t const i = get_global_id(0);
  Ray const unit = map_ray(shapes[i].unit_from_object, load_ray(rays[i]));
  Crossings const crossings = cross_unit_cylinder(unit.origin, unit.direction);
  t[i] = nearest_in_front((float2)(crossings.t_enter, crossings.t_leave), t_max[i]);
}

__kernel void probe_cone(__global UnitShape const* shapes, __global ProbeRay const* rays, __global float const* t_max,
                         __global float* t) {
  size_t const i = get_global_id(0);
  Ray const unit = map_ray(shapes[i].unit_from_object, load_ray(rays[i]));
  Crossings const crossings = cross_unit_cone(unit.origin, unit.direction);
  t[i] = nearest_in_front((float2)(crossings.t_enter, crossings.t_leave), t_max[i]);
}

__kernel void probe_plane(__global UnitShape const* shapes, __global ProbeRay const* rays, __global float const* t_max,
                          __global float* t) {
  size_t const i = get_global_id(0);
  Ray const unit = map_ray(shapes[i].unit_from_object, load_ray(rays[i]));
  Crossings const crossings = cross_unit_plane(unit.origin, unit.direction);
  t[i] = nearest_in_front((float2)(crossings.t_enter, crossings.t_leave), t_max[i]);
}

__kernel void probe_box(__global BoxPrimitive const* boxes, __global ProbeRay const* rays, __global float const* t_max,
                        __global float* t) {
  size_t const i = get_global_id(0);
  t[i] = intersect_box(boxes + i, load_ray(rays[i]), t_max[i]);
}

__kernel void probe_triangle(__global TrianglePrimitive const* triangles, __global ProbeRay const* rays,
                             __global float const* t_max, __global float* t) {
  size_t const i = get_global_id(0);
  TriangleRay const ray = make_triangle_ray(load_ray(rays[i]));
  t[i] = intersect_triangle(triangles + i, &ray, t_max[i]);
}

/* How many ends of a crossing count. */
__kernel void probe_count_in_front(__global float2 const* ts, __global float const* t_max, __global uint* counts) {
  size_t const i = get_global_id(0);
  counts[i] = count_in_front(ts[i], t_max[i]);
}
