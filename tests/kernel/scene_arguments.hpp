#pragma once

#include <string>
#include <vector>

#include "compile/scene_buffers.hpp"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

/// What SCENE_PARAMETERS of scene.clh takes, before the probe's own arguments.
inline std::vector<ProbeArgument> scene_arguments(SceneBuffers const& scene) {
  std::vector<ProbeArgument> arguments;
  auto const add = [&](auto const& array) { arguments.push_back(in(array)); };
  for_each_array(scene, add);
  for_each_array(scene.shading, add);
  arguments.push_back(value(scene_constants(scene, scene.shading)));
  return arguments;
}

/// What its program is compiled with. Probes take one ray a work-item unless they say otherwise.
inline std::string scene_options(SceneBuffers const& scene, int lanes = 1) {
  return (scene.layout == TreeLayout::wide ? "-D LAYOUT_WIDE" : "") + (" -D LANES=" + std::to_string(lanes)) +
         " -D TRAVERSAL_STACK_SIZE=" + std::to_string(std::max<std::size_t>(scene.stack_size, 1));
}

/// With packets where they are asked for.
inline std::string scene_options(SceneBuffers const& scene, Traversal const& traversal) {
  return traversal == Traversal::packet ? scene_options(scene, 16) + " -D TRACE_PACKETS" : scene_options(scene);
}

}  // namespace lichtraum::test
