#pragma once

#include <string>
#include <vector>

#include "compile/scene_buffers.hpp"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

/// What layout_arguments.clh takes, before the probe's own arguments.
inline std::vector<ProbeArgument> layout_arguments(SceneBuffers const& scene) {
  std::vector<ProbeArgument> arguments;
  if (scene.traversal == Traversal::scalar) {
    arguments = {in(scene.nodes), in(scene.references), in(scene.triangles), in(scene.spheres)};
  } else {
    arguments = {in(scene.wide_nodes), in(scene.triangle_blocks), in(scene.triangle_tags), in(scene.sphere_blocks)};
  }
  for (auto const& argument :
       {in(scene.ellipsoids), in(scene.boxes), in(scene.instances), in(scene.materials), in(scene.pbr_materials),
        in(scene.textures), in(scene.texels), in(scene.triangle_attributes), in(scene.vertex_data),
        value(scene.root_node), value(scene.features)}) {
    arguments.push_back(argument);
  }
  return arguments;
}

/// What its program is compiled with.
inline std::string layout_options(SceneBuffers const& scene) {
  char const* const names[] = {"", "SCALAR", "WIDE", "PACKET"};
  return std::string("-D TRAVERSAL_") + names[int(scene.traversal)] +
         " -D TRAVERSAL_STACK_SIZE=" + std::to_string(std::max<std::size_t>(scene.stack_size, 1));
}

}  // namespace lichtraum::test
