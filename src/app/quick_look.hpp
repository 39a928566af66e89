#pragma once

#include <memory>

#include "app/console.hpp"
#include "app/render_options.hpp"

namespace lichtraum::app {

/// A small picture of a scene, drawn with few samples and without the noise that these leave.
class QuickLook {
 public:
  /// Reads the only one of the options' scenes and prepares what `lichtraum render` would draw of it first. Says on the
  /// console what was found in it. Same exceptions as SceneSource::load, choose_renderer and view_of.
  QuickLook(RenderOptions const& options, Console const& console);

  /// Of the whole picture, as the options or the scene ask for it.
  Resolution const& size() const { return request_.resolution; }
  /// Developed; `size` should have the proportions of the whole picture. Throws what Renderer::render throws.
  Image draw(Resolution const& size) const;

 private:
  std::unique_ptr<Renderer> renderer_;
  RenderRequest request_;
  Development development_;
};

/// The largest size with the proportions of `picture` that fits into width x height pixels; at least one pixel each
/// way.
Resolution fitted(Resolution const& picture, double width, double height);

}  // namespace lichtraum::app
