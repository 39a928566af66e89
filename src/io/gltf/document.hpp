#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/file_stamp.hpp"

#include "io/gltf/findings.hpp"

namespace lichtraum::gltf {

/// A buffer as the model describes it; its bytes are read when something needs them (see Buffers).
struct BufferSource {
  std::optional<std::string> uri;
  std::uint64_t byte_length = 0;
};

/// An image as the model describes it; nothing is read or decoded yet.
struct ImageSource {
  std::string name;  ///< its own, or its file's; may be empty
  std::optional<std::string> uri;
  int buffer_view = -1;
};

/// A parsed model. tinygltf turned the JSON into structs; buffers and images never reach it, so it opens no file and
/// decodes nothing; nor do nodes, of which there may be many. Every index in `model` is -1 or within its list.
struct Document {
  std::filesystem::path path;
  std::optional<std::filesystem::path> folder;       ///< of files that the model names; it may name none without
  std::vector<std::filesystem::path> allowed_paths;  ///< folders outside the model's that may be read
  FileObserver on_read;
  std::string bytes;        ///< of the file
  std::string_view binary;  ///< the GLB's BIN chunk, a view of `bytes`
  bool is_glb = false;
  tinygltf::Model model;
  std::vector<BufferSource> buffers;
  std::vector<ImageSource> images;

  Document() = default;
  Document(Document const&) = delete;  // `binary` points into `bytes`
  Document& operator=(Document const&) = delete;
};

/// Parses `document.bytes`, the content of `document.path`. Fails when it is not glTF 2.
void parse_document(Document& document, Findings& findings);

}  // namespace lichtraum::gltf
