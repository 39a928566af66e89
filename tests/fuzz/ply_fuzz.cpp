#include <cstdint>
#include <string_view>

#include "lichtraum/ply.hpp"
#include "scene/flatten.hpp"

// Any bytes are read as a PLY file; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  try {
    lichtraum::flatten(lichtraum::import_ply_bytes(bytes, "fuzz.ply", "/nonexistent").scene.roots());
  } catch (lichtraum::Error const&) {  // what a faulty model must end in; anything else is a finding
  }
  return 0;
}
