#include <cstdint>
#include <string_view>

#include "io/image/environment_decoders.hpp"
#include "lichtraum/error.hpp"

// Any bytes are read as an OpenEXR environment; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  try {
    lichtraum::decode_exr({bytes, "fuzz.exr", 1 << 16});
  } catch (lichtraum::Error const&) {  // what a faulty file must end in; anything else is a finding
  }
  return 0;
}
