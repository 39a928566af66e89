#pragma once

#include "lichtraum/job.hpp"

namespace lichtraum {

/// Whether `view` says by itself where a camera stands.
inline bool has_place(JobView const& view) { return view.eye || view.orbit; }

/// `camera` as the job has it: moved and turned as its view says, and fitted to the size of its picture. `scene` is
/// what is drawn. Throws Error{usage} as check_view, also where the camera would look along `up`, and for an unknown
/// root.
Camera viewpoint(Camera camera, Job const& job, Scene const& scene, Resolution const& size);

}  // namespace lichtraum
