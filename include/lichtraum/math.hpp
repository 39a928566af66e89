#pragma once

/// Host mathematics: GLM in double precision. Device code has its own float types in kernels/shared/types.h.

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

/// Linear red, green, blue; 1 is full intensity, larger values are allowed.
using Rgb = glm::dvec3;

}  // namespace lichtraum
