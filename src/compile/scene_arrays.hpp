#pragma once

#include "core/big_vector.hpp"
#include "shared/scene_arrays.h"

namespace lichtraum::device {

#define LICHTRAUM_VECTOR(type, name) BigVector<type> name;

/// The arrays of shared/scene_arrays.h on the host, all but the shading. Of the two trees one is filled.
struct GeometryArrays {
  BINARY_TREE_ARRAYS(LICHTRAUM_VECTOR)
  WIDE_TREE_ARRAYS(LICHTRAUM_VECTOR)
  SHAPE_ARRAYS(LICHTRAUM_VECTOR)
  TEXTURE_ARRAYS(LICHTRAUM_VECTOR)
};

struct ShadingArrays {
  SHADING_ARRAYS(LICHTRAUM_VECTOR)
};

struct EnvironmentArrays {
  ENVIRONMENT_ARRAYS(LICHTRAUM_VECTOR)
};

#undef LICHTRAUM_VECTOR

/// Calls f(array) for each array that kernels of the layout take, in the order of their parameters: these first ...
template <class F>
void for_each_array(GeometryArrays const& arrays, bool is_binary, F const& f) {
#define LICHTRAUM_VISIT(type, name) f(arrays.name);
  if (is_binary) {
    BINARY_TREE_ARRAYS(LICHTRAUM_VISIT)
  } else {
    WIDE_TREE_ARRAYS(LICHTRAUM_VISIT)
  }
  SHAPE_ARRAYS(LICHTRAUM_VISIT)
  TEXTURE_ARRAYS(LICHTRAUM_VISIT)
}
/// ... then these ...
template <class F>
void for_each_array(ShadingArrays const& arrays, F const& f) {
  SHADING_ARRAYS(LICHTRAUM_VISIT)
}
/// ... and these.
template <class F>
void for_each_array(EnvironmentArrays const& arrays, F const& f) {
  ENVIRONMENT_ARRAYS(LICHTRAUM_VISIT)
#undef LICHTRAUM_VISIT
}

}  // namespace lichtraum::device
