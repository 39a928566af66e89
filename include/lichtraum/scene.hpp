#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/camera.hpp"
#include "lichtraum/environment.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/integrator.hpp"
#include "lichtraum/light.hpp"
#include "lichtraum/material.hpp"
#include "lichtraum/registry.hpp"
#include "lichtraum/shapes.hpp"
#include "lichtraum/tone_map.hpp"

namespace LICHTRAUM_API lichtraum {

/// A picture that a scene file asks for (eSDF `render`).
struct RenderCommand {
  std::string camera;
  std::string file;
  std::optional<Resolution> resolution;  ///< else the camera's
  std::optional<Integrator> integrator;  ///< else see chosen_integrator (lichtraum/job.hpp)
  std::optional<int> samples;            ///< per pixel
  std::optional<int> depth;              ///< of the tree of mirror and glass rays, or of paths
  SourceLocation location;
};

/// Everything a loader reads.
struct Scene {
  Registry<std::shared_ptr<Material>> materials;
  Registry<std::shared_ptr<Shape>> shapes;
  Registry<Light> lights;
  bool has_own_lights = true;  ///< false: a model without any, which was given some to be seen by
  Registry<Camera> cameras;
  bool has_own_cameras = true;  ///< false: a model without any, which was given one that shows all of it
  std::optional<EnvironmentLight> environment;
  /// Of the environment, of RenderRequest::ground, and of views that do not say it; of any length but 0. An STL model's
  /// is +z.
  Vec3 up{0, 1, 0};
  Rgb background{0};                     ///< what a ray sees that hits nothing
  ToneMap tone_map = ToneMap::none;      ///< what `automatic` means for this scene
  std::optional<Resolution> resolution;  ///< for cameras and renders that give none
  std::string filename;                  ///< for renders that give none; may be empty
  std::vector<RenderCommand> renders;    ///< in the order written

  /// What is drawn: every shape that no composite of this scene names, in the order of definition.
  std::vector<std::shared_ptr<Shape const>> roots() const;
  /// The sum of all lights' La.
  Rgb ambient() const;
};

}  // namespace lichtraum
