#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum::obj {

enum class Channel { red, green, blue, alpha };

/// Pictures whose channels come from several, as glTF wants them where MTL has a file for each number.
class PackedPictures {
 public:
  using Picture = std::shared_ptr<TextureImage const>;
  static constexpr std::size_t max_bytes = std::size_t(1) << 29;  ///< of all together, as for what is decoded

  /// `picture` (none: white) with `source` in one of its channels: how bright it is, as MTL's scalar maps are read; for
  /// alpha its own where it has any. Where the sizes differ, it has the larger width and height, and each pixel is
  /// the one of either that is there. Made once for all materials that use it. Just `picture` without a source, and
  /// where all together would take more than max_bytes.
  Picture with_channel(Picture const& picture, Channel channel, Picture const& source);
  bool is_full() const { return is_full_; }  ///< whether one was left out for that

 private:
  std::map<std::tuple<Picture, Channel, Picture>, Picture> made_;
  std::size_t bytes_ = 0;
  bool is_full_ = false;
};

}  // namespace lichtraum::obj
