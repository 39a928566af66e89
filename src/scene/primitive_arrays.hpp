#pragma once

#include "core/big_vector.hpp"
#include "shared/scene_arrays.h"

namespace lichtraum::device {

/// A list for each kind of primitive, and functions of all of them.
struct PrimitiveArrays {
#define LICHTRAUM_VECTOR(type, name) BigVector<type> name;
  PRIMITIVE_ARRAYS(LICHTRAUM_VECTOR)
#undef LICHTRAUM_VECTOR
};

/// Calls f(array) for each kind; `arrays` has a member for each, like PrimitiveArrays.
template <class Arrays, class F>
void for_each_kind(Arrays& arrays, F const& f) {
#define LICHTRAUM_VISIT(type, name) f(arrays.name);
  PRIMITIVE_ARRAYS(LICHTRAUM_VISIT)
#undef LICHTRAUM_VISIT
}

/// Calls f(array, other's array) for each kind.
template <class Arrays, class Others, class F>
void for_each_kind(Arrays& arrays, Others& others, F const& f) {
#define LICHTRAUM_VISIT(type, name) f(arrays.name, others.name);
  PRIMITIVE_ARRAYS(LICHTRAUM_VISIT)
#undef LICHTRAUM_VISIT
}

}  // namespace lichtraum::device
