#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "app/extreme_pixels.hpp"
#include "app/scene_light.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// What tells whether a picture shows anything.
class Sight {
 public:
  /// Of a part of it, or all, as it was traced.
  void add(RayCounts const& rays, Film& film);
  /// Of the same, what people see of its radiance.
  void add(Image const& pixels, Development const& development) { extremes_.add(pixels, development); }

  /// No ray of the camera met anything.
  bool is_empty() const { return camera_rays_ > 0 && camera_hits_ == 0; }
  /// All of it, though the camera sees something.
  bool is_black() const { return camera_hits_ > 0 && is_black_; }
  /// There were so many mirrored, refracted or scattered rays, of all pixels together: one of them may be that deep.
  bool may_reach_depth(int depth) const { return secondary_rays_ >= std::uint64_t(depth); }
  /// Rays meet surfaces, and show none of them. Known where normals were traced.
  bool shows_no_surface() const { return camera_hits_ > 0 && !has_normals_; }
  /// 0..1, see ExtremePixels; 0 where only films were added.
  double white_share(Background const& background, Development const& development) const;
  double black_share(Background const& background, Development const& development) const;

 private:
  /// Of the camera's rays, those that met something.
  double seen() const { return camera_rays_ > 0 ? double(camera_hits_) / double(camera_rays_) : 0; }

  std::uint64_t camera_rays_ = 0;
  std::uint64_t camera_hits_ = 0;
  std::uint64_t secondary_rays_ = 0;
  bool is_black_ = true;
  bool has_normals_ = false;  // or nobody knows
  ExtremePixels extremes_;
};

/// A picture that was drawn, and of what.
struct DrawnPicture {
  RenderRequest const& request;
  Development const& development;
  Background const& background;  ///< that of the request, or the scene's
  Bounds const& bounds;          ///< of the scene
  SceneLight light = SceneLight::some;
  bool is_model = false;
  bool is_whole = true;            ///< false: a region of it, which may well show nothing
  std::string_view map_repairs{};  ///< EnvironmentMap::repairs of what lights it
};

enum class PictureFault { far_away, repaired_map, no_light, too_bright, nothing_seen };

/// Each with a warning that says why and what to do, at no place. All of the picture was added to `sight`.
std::vector<std::pair<PictureFault, Diagnostic>> faults_of(DrawnPicture const& drawn, Sight const& sight);

}  // namespace lichtraum::app
