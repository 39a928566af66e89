#pragma once

#include <string>
#include <vector>

#include "session.hpp"

namespace lichtraum::python {

/// What the lines of an eSDF text define, move and ask for. `path` stands for it in messages; files that it reads are
/// looked up beside that. Exceptions as read_scene.
std::vector<EsdfStatement> statements_of(std::string text, std::string const& path, app::RenderOptions const& options);

/// The same of two scenes whose pictures have the same bytes, whichever camera of theirs sees them.
std::string identity_of(ReadScene& read);

}  // namespace lichtraum::python
