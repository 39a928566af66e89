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

Buffers::Buffers(Document const& document, Budget& budget, Findings& findings)
    : document_(document),
      budget_(budget),
      findings_(findings),
      buffers_(document.buffers.size()),
      views_(document.model.bufferViews.size()) {
  budget_.add_file(document.bytes.size());
}

Buffers::Bytes Buffers::file(std::string_view uri, std::string& reason) {
  if (has_scheme(uri)) {
    reason = fmt::format("cannot use {}: only files beside the model are read", in_quotes(uri));
    return nullptr;
  }
  auto const path =
      find_model_file(document_.folder, document_.allowed_paths, document_.on_read, decode_percent(uri), reason);
  if (!path) return nullptr;
  auto& known = files_[*path];
  if (auto bytes = known.lock()) return bytes;
  auto content = read_found_file(*path, reason);
  if (!content) return nullptr;
  budget_.add_file(content->size());
  auto bytes = std::make_shared<std::string const>(std::move(*content));
  known = bytes;
  return bytes;
}

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
    entry.owned = std::make_shared<std::string const>(std::move(*decoded));
    entry.bytes = *entry.owned;
  } else {
    std::string reason;
    entry.owned = file(*source.uri, reason);
    if (!entry.owned) {
      findings_.warn(DiagnosticCode::unreadable_buffer, pointer + "/uri", reason);
      return;
    }
    entry.bytes = *entry.owned;
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
  auto const take = [&](std::uint64_t bytes) { budget_.charge_for_good(bytes, pointer); };
  std::string decoded = decode_meshopt(parameters, *compressed, take, reason);
  if (!reason.empty()) {
    findings_.warn(DiagnosticCode::unreadable_buffer, pointer, reason);
    return;
  }
  entry.owned = std::make_shared<std::string const>(std::move(decoded));
  entry.bytes = *entry.owned;
  entry.is_usable = true;
}

}  // namespace lichtraum::gltf
