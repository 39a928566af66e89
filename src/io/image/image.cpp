#include "lichtraum/image.hpp"

#include "core/huge_pages.hpp"

namespace lichtraum {

Image::Image(Resolution size) : size_(size) {
  std::size_t const count = 3 * std::size_t(size.width) * std::size_t(size.height);
  reserve_in_huge_pages(rgb_, count);
  rgb_.resize(count);
}

}  // namespace lichtraum
