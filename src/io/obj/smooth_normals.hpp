#pragma once

#include "io/obj/obj_file.hpp"

namespace lichtraum::obj {

/// Gives corners of smoothing groups that have no normal one of their own, added to `file.normals`: the mean of the
/// normals of the group's triangles around that position, weighted by their angles there, so that it does not matter
/// how polygons were cut (Thürmer and Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998). Takes O(n log
/// n).
void add_smooth_normals(ObjFile& file);

}  // namespace lichtraum::obj
