#pragma once

#include <nanobind/nanobind.h>

#include <functional>

#include "lichtraum/renderer.hpp"

namespace lichtraum::python {

/// Does `work` in a thread of its own while others run Python, and shows how far it is: `show` is called with a
/// fraction from 0 to 1 (None: it is not called). What `work` is given is to be called by it now and then; it tells to
/// stop when a signal came (Ctrl-C) or `show` threw, which is thrown on once `work` has returned. Throws what `work`
/// throws.
void wait_for(std::function<void(ProgressFunction const&)> const& work, nanobind::object const& show);

}  // namespace lichtraum::python
