#include "lichtraum/image.hpp"

#include <stdexcept>

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

}  // namespace lichtraum
