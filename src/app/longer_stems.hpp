#pragma once

#include <map>
#include <string>
#include <vector>

namespace lichtraum::app {

/// Names for the pictures of files that share one, by what the command line calls each file. The folders that tell them
/// apart come before the name, as few as are enough: chair_scene and table_scene for chair/scene.gltf and
/// table/scene.gltf. Where no folders do, the extension comes after it: chair_glb and chair_obj.
std::map<std::string, std::string> longer_stems(std::vector<std::string> const& inputs);

}  // namespace lichtraum::app
