#pragma once

namespace lichtraum {

/// Half the surface of a box with these edges: floats, doubles, or vectors of several boxes.
template <class Number>
Number half_area(Number x, Number y, Number z) {
  return x * y + y * z + z * x;
}

}  // namespace lichtraum
