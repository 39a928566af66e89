#pragma once

#include <cstddef>
#include <vector>

#include "lichtraum/camera.hpp"

namespace lichtraum {

/// A picture of float RGB pixels, first row at the top.
class Image {
 public:
  Image() = default;
  /// Black.
  explicit Image(Resolution size);

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  Resolution size() const { return size_; }

  /// Three floats: red, green, blue.
  float* pixel(int x, int y) { return rgb_.data() + offset(x, y); }
  float const* pixel(int x, int y) const { return rgb_.data() + offset(x, y); }

  std::vector<float>& data() { return rgb_; }  ///< height x width x 3
  std::vector<float> const& data() const { return rgb_; }

 private:
  std::size_t offset(int x, int y) const { return 3 * (std::size_t(y) * std::size_t(size_.width) + std::size_t(x)); }

  Resolution size_;
  std::vector<float> rgb_;
};

}  // namespace lichtraum
