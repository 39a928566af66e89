#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum::obj {

enum class Channel { red, green, blue, alpha };

/// Pictures as glTF wants them, made of those that MTL names. Each is made once for all materials that use it, and all
/// together take no more than max_bytes.
class MadePictures {
 public:
  using Picture = std::shared_ptr<TextureImage const>;
  static constexpr std::size_t max_bytes = std::size_t(1) << 29;  ///< on every machine

  /// `picture` (none: white) with `source` in one of its channels: how bright it is, as MTL's scalar maps are read; for
  /// alpha its own where it has any. Where the sizes differ, it has the larger width and height, and each pixel is
  /// the one of either that is there. Just `picture` without a source, and where there is no room.
  Picture with_channel(Picture const& picture, Channel channel, Picture const& source);
  bool is_normal_map(Picture const& bump_map);  ///< see obj::is_normal_map
  /// The normal map of heights, see normals_from_heights. Null where there is no room.
  Picture normals_from(Picture const& heights, double multiplier, bool is_clamped);
  bool is_full() const { return is_full_; }  ///< whether one was left out for want of room

 private:
  bool take(int width, int height);

  std::map<std::tuple<Picture, Channel, Picture>, Picture> packed_;
  std::map<std::tuple<Picture, double, bool>, Picture> normals_;
  std::map<Picture, bool> are_normals_;
  std::size_t bytes_ = 0;
  bool is_full_ = false;
};

}  // namespace lichtraum::obj
