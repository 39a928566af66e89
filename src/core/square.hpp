#pragma once

namespace lichtraum {

constexpr double square(double x) { return x * x; }

}  // namespace lichtraum
