#pragma once

#include <span>
#include <string_view>

namespace lichtraum {

/// A device program as one string, made from kernels/<name>.cl when lichtraum was built.
struct EmbeddedKernel {
  std::string_view name;
  std::string_view source;
};

/// Defined in a file that tools/embed_kernels.cmake generates.
std::span<EmbeddedKernel const> embedded_kernels();

}  // namespace lichtraum
