#pragma once

#include <optional>
#include <string>

#include "lichtraum/esdf.hpp"
#include "lichtraum/renderer.hpp"

/// Explains a picture in which no camera ray met anything.

namespace lichtraum::app {

/// "the scene is 71 degrees to the left of where the camera looks": where the box lies for a picture of that size.
std::string describe_direction(Camera const& camera, Resolution const& size, Bounds const& bounds);

/// A reading of the same file under another convention, and the options that choose it: "--rotation left".
struct Convention {
  EsdfDialect dialect;
  std::string arguments;
};
std::vector<Convention> other_conventions(EsdfDialect const& dialect);

}  // namespace lichtraum::app
