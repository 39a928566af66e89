#include "io/gltf/contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/gltf/extensions.hpp"
#include "io/gltf/variants.hpp"

namespace lichtraum::gltf {
double animation_seconds(tinygltf::Animation const& animation, Accessors& accessors, std::string const& pointer) {
  double last = 0;
  std::set<int> known;
  for (std::size_t i = 0; i < animation.samplers.size(); ++i) {
    int const input = animation.samplers[i].input;
    if (!known.insert(input).second) continue;
    auto const times = accessors.floats(input, 1, fmt::format("{}/samplers/{}/input", pointer, i));
    for (float const time : times ? times->values : std::vector<float>()) {
      if (std::isfinite(time)) last = std::max(last, double(time));
    }
  }
  return last;
}

ModelContents describe_contents(tinygltf::Model const& model, Accessors& accessors) {
  ModelContents contents;
  std::set<std::string> const required(model.extensionsRequired.begin(), model.extensionsRequired.end());
  std::set<std::string> used(model.extensionsUsed.begin(), model.extensionsUsed.end());
  used.insert(required.begin(), required.end());
  for (std::string const& name : used) {
    auto const* support = find_extension_support(name);
    contents.extensions.push_back({name, required.contains(name), support ? std::string(support->support) : ""});
  }
  for (auto const& animation : model.animations) {
    contents.animations.push_back({animation.name, 0});
    try {
      contents.animations.back().seconds = animation_seconds(animation, accessors, "");
    } catch (SceneError const&) {  // more data than the files may ask for
    }
  }
  for (auto const& scene : model.scenes) contents.scenes.push_back(scene.name);
  contents.variants = variant_names(model);
  return contents;
}

}  // namespace lichtraum::gltf
