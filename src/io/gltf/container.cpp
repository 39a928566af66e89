#include "io/gltf/container.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace lichtraum::gltf {
namespace {

constexpr std::size_t header_bytes = 12;
constexpr std::size_t chunk_header_bytes = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;

/// Little-endian. The caller has checked that four bytes are there.
std::uint32_t read_uint32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

}  // namespace

Container open_container(std::string_view file, Findings& findings) {
  if (file.substr(0, 4) != "glTF") {
    if (file.empty()) findings.fail(DiagnosticCode::not_gltf, "", "the file is empty");
    return {file, {}, false};
  }
  if (file.size() < header_bytes) findings.fail(DiagnosticCode::broken_glb, "", "the GLB header is cut off");
  std::uint32_t const version = read_uint32(file, 4);
  if (version != 2)
    findings.fail(DiagnosticCode::gltf_version, "",
                  fmt::format("this is GLB version {}; only version 2 is supported", version));
  std::uint32_t const length = read_uint32(file, 8);
  if (length > file.size()) {
    findings.warn(DiagnosticCode::cut_glb, "",
                  fmt::format("the GLB header declares {} bytes, the file has {}", length, file.size()));
  } else if (length >= header_bytes) {
    file = file.substr(0, length);
  }

  Container container{{}, {}, true};
  std::size_t at = header_bytes;
  for (int chunk = 0; file.size() - at >= chunk_header_bytes; ++chunk) {
    std::uint32_t const chunk_length = read_uint32(file, at);
    std::uint32_t const type = read_uint32(file, at + 4);
    at += chunk_header_bytes;
    std::size_t const available = file.size() - at;
    bool const is_cut_off = chunk_length > available;
    if (chunk == 0) {
      if (type != json_chunk) findings.fail(DiagnosticCode::broken_glb, "", "the first chunk of the GLB is not JSON");
      if (is_cut_off) {
        findings.fail(DiagnosticCode::broken_glb, "",
                      fmt::format("the JSON chunk has {} bytes, {} are left in the file", chunk_length, available));
      }
      container.json = file.substr(at, chunk_length);
    } else if (type == binary_chunk && container.binary.empty()) {
      if (is_cut_off) {
        findings.warn(DiagnosticCode::cut_glb, "",
                      fmt::format("the BIN chunk has {} bytes, {} are left in the file", chunk_length, available));
      }
      container.binary = file.substr(at, chunk_length);  // cut at the end of the file
    }
    if (is_cut_off) break;
    at += chunk_length;
  }
  if (container.json.empty()) findings.fail(DiagnosticCode::broken_glb, "", "the GLB has no JSON chunk");
  return container;
}

}  // namespace lichtraum::gltf
