#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/console.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

using Tell = std::function<void(std::string const&)>;

/// A renderer for what --device says; for an empty selector the best device that works, with a warning for each better
/// one that does not.
/// `note` gets what matters less: of other devices than the chosen one. Throws Error{no_device}.
std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Tell const& warn, Tell const& note);
std::unique_ptr<Renderer> choose_renderer(std::string const& selector, std::optional<Traversal> const& traversal,
                                          Console const& console);

}  // namespace lichtraum::app
