#pragma once

#include <string>

namespace lichtraum::app {

/// The path in a file URI (RFC 8089: file:/a, file:///a, file://localhost/a, with %20 for a blank); any other text as
/// it is. Throws Error{no_input} for a file of another machine and for what cannot be a path.
std::string path_of(std::string const& path_or_uri);

}  // namespace lichtraum::app
