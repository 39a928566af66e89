#include "core/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace lichtraum {

struct ContentHasher::State {
  XXH3_state_t* xxh3 = XXH3_createState();
  State() {
    if (!xxh3) throw std::bad_alloc();
    XXH3_128bits_reset(xxh3);
  }
  State(State const&) = delete;
  State& operator=(State const&) = delete;
  ~State() { XXH3_freeState(xxh3); }
};

std::string ContentHash::text() const { return fmt::format("{:016x}{:016x}", words[0], words[1]); }

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) {}
ContentHasher::~ContentHasher() = default;

void ContentHasher::add_bytes(void const* bytes, std::size_t count) {
  if (count > 0) XXH3_128bits_update(state_->xxh3, bytes, count);
}

ContentHash ContentHasher::finish() const {
  XXH128_hash_t const hash = XXH3_128bits_digest(state_->xxh3);
  return {{hash.high64, hash.low64}};
}

}  // namespace lichtraum
