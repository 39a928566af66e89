#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/scene_loader.hpp"

namespace lichtraum::app {

/// What the user may not have meant by the pictures that are planned: a name in use, an option without effect.
class PlanFindings {
 public:
  /// `inputs`: how many scenes there are.
  PlanFindings(RenderOptions const& options, std::size_t inputs) : options_(options), inputs_(inputs) {}

  /// Warnings about the pictures of the next scene.
  std::vector<Diagnostic> next(SceneOpened const& scene);

 private:
  std::optional<Diagnostic> film_of_one_picture(SceneOpened const& scene) const;
  std::optional<Diagnostic> outside_animation(SceneOpened const& scene) const;
  std::optional<Diagnostic> background_of_bytes();

  RenderOptions const& options_;
  std::size_t inputs_;
  bool has_told_of_background_ = false;
  std::map<std::filesystem::path, int> uses_;             // pictures of that name
  std::set<std::pair<std::string, std::string>> warned_;  // option and extension
};

}  // namespace lichtraum::app
