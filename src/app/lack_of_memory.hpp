#pragma once

namespace lichtraum::app {

/// From now on, where memory is lacking even for what follows from its lack (destructors, a message), the process ends
/// with the status for that, and a message, instead of std::abort.
void handle_lack_of_memory();

}  // namespace lichtraum::app
