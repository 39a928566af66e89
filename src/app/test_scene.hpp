#pragma once

#include "lichtraum/renderer.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum::app {

struct TestScene {
  Scene scene;
  RenderRequest request;
};

/// A small scene with something of everything: sphere, box, triangle, a composite drawn twice, a mirror, glass,
/// shadows.
TestScene make_test_scene();

}  // namespace lichtraum::app
