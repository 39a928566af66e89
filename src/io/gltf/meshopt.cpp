#include "io/gltf/meshopt.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <memory>

#include "io/gltf/values.hpp"

namespace lichtraum::gltf {
namespace {

/// No encoder packs denser: an attribute's best case is two bits for sixteen zero bytes of it, a triangle takes a byte.
constexpr std::uint64_t max_ratio = 128;

bool decode(std::string const& mode, std::size_t count, std::size_t stride, std::string_view compressed, void* out) {
  auto const* bytes = reinterpret_cast<unsigned char const*>(compressed.data());
  if (mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer(out, count, stride, bytes, compressed.size()) == 0;
  if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer(out, count, stride, bytes, compressed.size()) == 0;
  return meshopt_decodeIndexSequence(out, count, stride, bytes, compressed.size()) == 0;
}

}  // namespace

std::string decode_meshopt(tinygltf::Value const& parameters, std::string_view compressed,
                           std::function<void(std::uint64_t)> const& take, std::string& reason) {
  std::string const mode = string_of(parameters, "mode");
  std::string const filter = string_of(parameters, "filter");
  auto const count = integer_of(parameters, "count");
  auto const stride = integer_of(parameters, "byteStride");
  if (!count || !stride) {
    reason = "count or byteStride is missing";
    return {};
  }
  bool const is_attributes = mode == "ATTRIBUTES";
  bool const is_triangles = mode == "TRIANGLES";
  if (!is_attributes && !is_triangles && mode != "INDICES") {
    reason = fmt::format("unknown mode '{}'", mode);
    return {};
  }
  // What the decoder asserts, and with it what the extension's specification demands.
  bool const stride_fits =
      is_attributes ? *stride > 0 && *stride <= 256 && *stride % 4 == 0 : *stride == 2 || *stride == 4;
  if (!stride_fits || (is_triangles && *count % 3 != 0)) {
    reason = fmt::format("mode {} with count {} and byteStride {}", mode, *count, *stride);
    return {};
  }
  bool const filter_fits = filter.empty() || filter == "NONE" ||
                           (is_attributes && ((filter == "OCTAHEDRAL" && (*stride == 4 || *stride == 8)) ||
                                              (filter == "QUATERNION" && *stride == 8) || filter == "EXPONENTIAL"));
  if (!filter_fits) {
    reason = fmt::format("filter '{}' does not go with mode {} and byteStride {}", filter, mode, *stride);
    return {};
  }
  if (*count > max_ratio * compressed.size() / *stride + 256) {
    reason = fmt::format("{} bytes cannot hold {} elements of {} bytes", compressed.size(), *count, *stride);
    return {};
  }

  // As std::string is not aligned for the filters, which read whole words.
  std::size_t const size = std::size_t(*count) * std::size_t(*stride);
  take(size);
  auto const words = std::make_unique<std::uint64_t[]>(size / sizeof(std::uint64_t) + 1);
  if (!decode(mode, std::size_t(*count), std::size_t(*stride), compressed, words.get())) {
    reason = "the compressed data is damaged";
    return {};
  }
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(words.get(), std::size_t(*count), std::size_t(*stride));
  if (filter == "QUATERNION") meshopt_decodeFilterQuat(words.get(), std::size_t(*count), std::size_t(*stride));
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(words.get(), std::size_t(*count), std::size_t(*stride));
  return std::string(reinterpret_cast<char const*>(words.get()), size);
}

}  // namespace lichtraum::gltf
