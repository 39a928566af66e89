#include "io/gltf/buffers.hpp"

#include <fmt/format.h>

#include "core/percent.hpp"
#include "io/gltf/meshopt.hpp"
#include "io/gltf/uri.hpp"
#include "io/gltf/values.hpp"
#include "io/model_file.hpp"
#include "io/text/diagnostics.hpp"

namespace lichtraum::gltf {
namespace {

constexpr char const* meshopt_extensions[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

}  // namespace

std::optional<std::string> read_external_file(Document const& document, std::string_view uri, std::string& reason) {
  if (has_scheme(uri)) {
    reason = fmt::format("cannot use {}: only files beside the model are read", in_quotes(uri));
    return std::nullopt;
  }
  return read_model_file(document.folder, document.allowed_paths, document.on_read, decode_percent(uri), reason);
}

Buffers::Buffers(Document const& document, Findings& findings)
    : document_(document),
      findings_(findings),
      buffers_(document.buffers.size()),
      views_(document.model.bufferViews.size()),
      bytes_read_(document.bytes.size()) {}

std::optional<std::string_view> Buffers::view(int index) {
  if (index < 0 || std::size_t(index) >= views_.size()) return std::nullopt;
  Entry& entry = views_[std::size_t(index)];
  if (!entry.is_loaded) {
    entry.is_loaded = true;
    load_view(index, entry);
  }
  if (!entry.is_usable) return std::nullopt;
  return entry.bytes;
}

Buffers::Entry const& Buffers::buffer(int index) {
  Entry& entry = buffers_[std::size_t(index)];
  if (!entry.is_loaded) {
    entry.is_loaded = true;
    load_buffer(index, entry);
  }
  return entry;
}

void Buffers::load_buffer(int index, Entry& entry) {
  BufferSource const& source = document_.buffers[std::size_t(index)];
  std::string const pointer = fmt::format("/buffers/{}", index);
  if (!source.uri) {
    if (index != 0 || !document_.is_glb) {
      findings_.warn(DiagnosticCode::unreadable_buffer, pointer, "it has no uri");
      return;
    }
    entry.bytes = document_.binary;
  } else if (is_data_uri(*source.uri)) {
    auto decoded = decode_data_uri(*source.uri);
    if (!decoded) {
      findings_.warn(DiagnosticCode::unreadable_buffer, pointer + "/uri", "the data URI is malformed");
      return;
    }
    entry.owned = std::move(*decoded);
    entry.bytes = entry.owned;
  } else {
    std::string reason;
    auto content = read_external_file(document_, *source.uri, reason);
    if (!content) {
      findings_.warn(DiagnosticCode::unreadable_buffer, pointer + "/uri", reason);
      return;
    }
    entry.owned = std::move(*content);
    entry.bytes = entry.owned;
    bytes_read_ += entry.owned.size();
  }
  entry.is_usable = true;
  if (entry.bytes.size() < source.byte_length) {
    findings_.warn(DiagnosticCode::unreadable_buffer, pointer + "/byteLength",
                   fmt::format("{} bytes are declared, {} are there", source.byte_length, entry.bytes.size()));
  } else {
    entry.bytes = entry.bytes.substr(0, std::size_t(source.byte_length));
  }
}

std::optional<std::string_view> Buffers::slice(int buffer_index, std::uint64_t offset, std::uint64_t length,
                                               std::string const& pointer) {
  if (buffer_index < 0 || std::size_t(buffer_index) >= buffers_.size()) return std::nullopt;  // told already
  Entry const& whole = buffer(buffer_index);
  if (!whole.is_usable) return std::nullopt;
  std::uint64_t const size = whole.bytes.size();
  if (offset > size || length > size - offset) {
    findings_.warn(DiagnosticCode::unreadable_buffer, pointer,
                   fmt::format("bytes {} to {} are out of range of buffer {} ({} bytes)", offset, offset + length,
                               buffer_index, size));
    if (offset >= size) return std::nullopt;
  }
  return whole.bytes.substr(std::size_t(offset), std::size_t(length));
}

void Buffers::load_view(int index, Entry& entry) {
  tinygltf::BufferView const& view = document_.model.bufferViews[std::size_t(index)];
  for (char const* extension : meshopt_extensions) {
    if (auto const* parameters = find_extension(view.extensions, extension)) {
      decompress(index, extension, *parameters, entry);
      return;
    }
  }
  if (view.byteLength == 0) return;
  if (auto const bytes = slice(view.buffer, view.byteOffset, view.byteLength, fmt::format("/bufferViews/{}", index))) {
    entry.bytes = *bytes;
    entry.is_usable = true;
  }
}

void Buffers::decompress(int index, char const* extension, tinygltf::Value const& parameters, Entry& entry) {
  std::string const pointer = fmt::format("/bufferViews/{}/extensions/{}", index, extension);
  auto const buffer_index = index_of(parameters, "buffer", buffers_.size());
  auto const length = integer_of(parameters, "byteLength");
  if (!buffer_index || !length) {
    findings_.warn(DiagnosticCode::unreadable_buffer, pointer, "buffer or byteLength is missing or out of range");
    return;
  }
  auto const compressed = slice(*buffer_index, integer_of(parameters, "byteOffset").value_or(0), *length, pointer);
  if (!compressed) return;
  std::string reason;
  entry.owned = decode_meshopt(parameters, *compressed, reason);
  if (!reason.empty()) {
    findings_.warn(DiagnosticCode::unreadable_buffer, pointer, reason);
    return;
  }
  entry.bytes = entry.owned;
  entry.is_usable = true;
}

}  // namespace lichtraum::gltf
