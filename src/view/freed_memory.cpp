#include "view/freed_memory.hpp"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace lichtraum::view {

void give_back_freed_memory() {
  // Mapping each picture by itself (a fixed M_MMAP_THRESHOLD) would keep memory flatter still, but costs a turning view
  // a fifth of its pictures per second, as each one faults in new pages.
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace lichtraum::view
