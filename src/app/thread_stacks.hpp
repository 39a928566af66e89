#pragma once

namespace lichtraum::app {

/// Threads that start from now on, those of OpenCL drivers too, have a stack of 8 MiB, which the deepest rays (--depth)
/// take most of, also where ulimit -s allows less. The thread that calls keeps the stack that it has.
void ensure_thread_stacks();

}  // namespace lichtraum::app
