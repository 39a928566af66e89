#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "lichtraum/gltf.hpp"
#include "scene/flatten.hpp"

// Any bytes are read as a glTF file, with its animation at a time; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static std::filesystem::path const path =
      std::filesystem::temp_directory_path() / ("lichtraum-fuzz-" + std::to_string(::getpid()) + ".gltf");
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<char const*>(data), std::streamsize(size));
  try {
    lichtraum::ModelOptions options;
    options.time_seconds = 0.5;
    options.max_texture = 256;
    lichtraum::flatten(lichtraum::load_gltf(path, options).roots());
  } catch (lichtraum::Error const&) {  // what a faulty model must end in; anything else is a finding
  }
  return 0;
}
