#pragma once

#include <memory>
#include <string>

#include "app/console.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// A renderer for what --device says; for an empty selector the best device that works, with a warning for each better
/// one that does not. Throws Error{no_device}.
std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Console const& console);

}  // namespace lichtraum::app
