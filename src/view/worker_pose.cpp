#include "view/worker.hpp"

// How a Worker poses an animated model.

namespace lichtraum::view {

void Worker::pose(unsigned number, double time_seconds) {
  std::lock_guard const lock(mutex_);
  pose_ = {number, time_seconds};
  has_question_ = true;
  changed_.notify_all();
}

void Worker::choose_animation(unsigned number, std::size_t animation) {
  std::lock_guard const lock(mutex_);
  new_animation_ = {number, animation};
  has_question_ = true;
  changed_.notify_all();
}

void Worker::apply_pose(Renderer& renderer) {
  auto const time_seconds = take(pose_);
  if (!time_seconds || !loaded_->can_be_posed()) return;
  try {
    Scene const scene = loaded_->pose(*time_seconds);
    PosedView posed{scene_number_, *time_seconds, view_of(loaded_job_, scene), {}, {}};
    posed.cameras.assign(scene.cameras.begin(), scene.cameras.end());
    posed.bounds = bounds_in_view(loaded_job_, scene, posed.request.camera);
    auto prepared = renderer.prepare(scene, loaded_job_.root, prepared_);
    scene_statistics_ = renderer.set_scene(has_edits_ ? renderer.edit(prepared, edits_in_place_) : prepared);
    prepared_ = std::move(prepared);
    bounds_ = posed.bounds;
    film_ = {};
    std::lock_guard const lock(mutex_);
    news_.posed = std::move(posed);
    expect_marking();
    restart_refinement();
  } catch (std::exception const& error) {  // of this pose, or for want of memory; the one before is shown still
    tell_of(error);
  }
  wake_();
}

}  // namespace lichtraum::view
