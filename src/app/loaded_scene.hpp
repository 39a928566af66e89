#pragma once

#include <functional>
#include <variant>

#include "lichtraum/esdf.hpp"
#include "lichtraum/gltf.hpp"

namespace lichtraum::app {

/// How scenes and models are read.
struct LoadOptions {
  EsdfOptions language;  ///< its allowed paths hold for models as well
  GltfOptions model;
};

/// What a scene file or a model file became.
class LoadedScene {
 public:
  explicit LoadedScene(EsdfScript script) : content_(std::move(script)) {}
  explicit LoadedScene(GltfModel model) : content_(std::move(model)) {}

  bool is_model() const { return std::holds_alternative<GltfModel>(content_); }
  std::vector<Diagnostic> const& diagnostics() const;
  /// At the end of the file.
  Scene const& scene() const;

  /// Calls `draw` for each picture that the file asks for, with the scene as it is there and the picture's number; once
  /// at the end for a file that asks for none.
  void play(std::function<void(Scene const&, std::size_t)> const& draw) const;

 private:
  std::variant<EsdfScript, GltfModel> content_;
};

}  // namespace lichtraum::app
