#pragma once

namespace lichtraum::app {

/// Bounds what a thumbnail may cost, as file managers ask for those of files that nobody has chosen: after 20 s this
/// process ends with a message and the exit code of ErrorKind::internal; allocations beyond 4 GiB throw std::bad_alloc.
void limit_thumbnail();

}  // namespace lichtraum::app
