#include "view/freed_memory.hpp"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace lichtraum::view {

void give_back_freed_memory() {
  // A threshold of its own for what is mapped (M_MMAP_THRESHOLD) would keep memory even flatter, but a turning view has
  // a fifth fewer pictures a second then, as the pages of each are new.
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace lichtraum::view
