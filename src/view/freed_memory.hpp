#pragma once

namespace lichtraum::view {

/// Gives the system back what the C library keeps of freed memory, where that can be asked for. What pictures of one
/// size leave is in pieces that those of another do not fit into, so that a window would hold more with each new size.
void give_back_freed_memory();

}  // namespace lichtraum::view
