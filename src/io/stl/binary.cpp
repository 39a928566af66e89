#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/float3.hpp"
#include "io/faulty_geometry.hpp"
#include "io/stl/facets.hpp"

namespace lichtraum::stl {
namespace {

// A header that nobody reads, the number of facets; for each a normal, three corners and two bytes of attributes.
constexpr std::size_t count_at = 80;
constexpr std::size_t data_at = 84;
constexpr std::size_t facet_bytes = 50;
constexpr std::size_t corners_at = 12;

std::uint32_t uint32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

Float3 corner_at(std::string_view bytes, std::size_t at) {
  Float3 corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = std::bit_cast<float>(uint32_at(bytes, at + 4 * i));
  return corner;
}

}  // namespace

bool has_binary_size(std::string_view bytes) {
  return bytes.size() > data_at && bytes.size() - data_at == std::uint64_t(uint32_at(bytes, count_at)) * facet_bytes;
}

bool is_binary(std::string_view bytes) {
  constexpr std::size_t examined_bytes = 4096;
  return has_binary_size(bytes) || bytes.substr(0, examined_bytes).find('\0') != std::string_view::npos;
}

Solids read_binary(std::string_view bytes, Diagnostics& diagnostics, Vec3 const& origin) {
  auto const warn = [&](std::size_t at, std::string const& what) {
    diagnostics.add(Severity::warning, DiagnosticCode::stl_bytes, {}, fmt::format("byte {}: {}", at, what));
  };
  if (bytes.size() < data_at) {
    diagnostics.add(Severity::error, DiagnosticCode::not_stl, {},
                    fmt::format("byte {}: the file ends in the header, which has {} bytes", bytes.size(), data_at));
    return {};
  }
  std::size_t const declared = uint32_at(bytes, count_at);
  std::size_t const count = std::min(declared, (bytes.size() - data_at) / facet_bytes);
  std::size_t const end = data_at + count * facet_bytes;
  if (count < declared) {
    warn(bytes.size(), fmt::format("the data ends in facet {} of {}", count, declared));
  } else if (end < bytes.size()) {
    warn(end, fmt::format("{} bytes follow the last facet that the file declares ({}): left out", bytes.size() - end,
                          declared));
  }

  Solids result;
  Solid& solid = result.solids.emplace_back();
  solid.corners.reserve(3 * count);
  std::size_t non_finite = 0;
  std::size_t first_at = 0;
  for (std::size_t at = data_at; at < end; at += facet_bytes) {
    Float3 corners[3];
    for (std::size_t i = 0; i < 3; ++i) corners[i] = corner_at(bytes, at + corners_at + i * sizeof(Float3));
    if (std::ranges::all_of(corners, [](Float3 const& corner) { return is_finite(corner); })) {
      for (Float3 const& corner : corners) {
        result.extent.add(to_vec3(corner));
        solid.corners.push_back(to_float3(to_vec3(corner) - origin));
      }
    } else if (++non_finite == 1) {
      first_at = at;
    }
  }
  if (non_finite > 0) warn(first_at, left_out_message(non_finite, "a vertex that is not finite"));
  return result;
}

}  // namespace lichtraum::stl
