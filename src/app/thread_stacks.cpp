#include "app/thread_stacks.hpp"

#include <pthread.h>

#include <cstddef>

namespace lichtraum::app {

void ensure_thread_stacks() {
  constexpr std::size_t wanted = std::size_t(8) << 20;
  pthread_attr_t attributes;
  std::size_t size = 0;
  if (::pthread_getattr_default_np(&attributes) != 0) return;
  ::pthread_attr_getstacksize(&attributes, &size);
  if (size < wanted && ::pthread_attr_setstacksize(&attributes, wanted) == 0) {
    ::pthread_setattr_default_np(&attributes);
  }
  ::pthread_attr_destroy(&attributes);
}

}  // namespace lichtraum::app
