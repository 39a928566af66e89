#pragma once

#include <cstddef>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/camera.hpp"

namespace LICHTRAUM_API lichtraum {

/// A picture of float RGB pixels, first row at the top; it may have an alpha beside each.
class Image {
 public:
  Image() = default;
  /// Black.
  explicit Image(Resolution size);
  /// Of these pixels: size.height x size.width x 3.
  Image(Resolution size, std::vector<float> rgb);

  /// One that was moved from has no pixels.
  Image(Image&& other) noexcept;
  Image& operator=(Image&& other) noexcept;
  Image(Image const&) = default;
  Image& operator=(Image const&) = default;
  ~Image() = default;

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  Resolution size() const { return size_; }

  /// Three floats: red, green, blue.
  float* pixel(int x, int y) { return rgb_.data() + offset(x, y); }
  float const* pixel(int x, int y) const { return rgb_.data() + offset(x, y); }

  std::vector<float>& data() { return rgb_; }  ///< height x width x 3
  std::vector<float> const& data() const { return rgb_; }

  /// height x width, 0 (nothing) to 1 (covered); empty: all is covered.
  std::vector<float>& alpha() { return alpha_; }
  std::vector<float> const& alpha() const { return alpha_; }

 private:
  std::size_t offset(int x, int y) const { return 3 * (std::size_t(y) * std::size_t(size_.width) + std::size_t(x)); }

  Resolution size_;
  std::vector<float> rgb_;
  std::vector<float> alpha_;
};

}  // namespace lichtraum
