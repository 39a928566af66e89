#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/image/decode.hpp"

// Any bytes are read as a texture's picture; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  constexpr int largest = 64;
  std::string reason;
  auto const image = lichtraum::decode_image({reinterpret_cast<char const*>(data), size}, largest,
                                             lichtraum::TexelContent::data, reason);
  if (!image && reason.empty()) std::abort();
  if (image && (image->width > largest || image->height > largest)) std::abort();
  return 0;
}
