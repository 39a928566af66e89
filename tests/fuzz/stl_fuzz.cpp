#include <cstdint>
#include <string_view>

#include "lichtraum/stl.hpp"
#include "scene/flatten.hpp"

// Any bytes are read as an STL file; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  try {
    lichtraum::flatten(lichtraum::import_stl_bytes(bytes, "fuzz.stl").scene.roots());
  } catch (lichtraum::Error const&) {  // what a faulty model must end in; anything else is a finding
  }
  return 0;
}
