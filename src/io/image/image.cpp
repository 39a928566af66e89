#include "lichtraum/image.hpp"

#include <stdexcept>
#include <utility>

#include "core/huge_pages.hpp"

namespace lichtraum {

Image::Image(Resolution size) : size_(size) {
  if (size.width < 0 || size.height < 0) throw std::invalid_argument("an image's sides must not be negative");
  std::size_t const count = 3 * std::size_t(size.width) * std::size_t(size.height);
  reserve_in_huge_pages(rgb_, count);
  rgb_.resize(count);
}

Image::Image(Resolution size, std::vector<float> rgb) : size_(size), rgb_(std::move(rgb)) {
  if (rgb_.size() != 3 * std::size_t(size.width) * std::size_t(size.height)) {
    throw std::invalid_argument("an image needs three numbers a pixel");
  }
}

Image::Image(Image&& other) noexcept { *this = std::move(other); }

Image& Image::operator=(Image&& other) noexcept {
  size_ = std::exchange(other.size_, {});
  rgb_ = std::exchange(other.rgb_, {});
  alpha_ = std::exchange(other.alpha_, {});
  return *this;
}

}  // namespace lichtraum
