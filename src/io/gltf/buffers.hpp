#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/document.hpp"

namespace lichtraum::gltf {

/// Reads a file that a model names, from the model's folder, below it, or one of the allowed folders. Nothing when it
/// may not or cannot be read; `reason` then says why.
std::optional<std::string> read_external_file(Document const& document, std::string_view uri, std::string& reason);

/// The bytes of buffers and buffer views, read or decoded when they are first asked for. Each failure is a finding,
/// once.
class Buffers {
 public:
  Buffers(Document const& document, Findings& findings);

  /// The bytes of a view; fewer than it declares when its buffer is too short. Nothing when there are none.
  std::optional<std::string_view> view(int index);

  /// How many bytes the model's files hold in all that has been read: what it may ask memory for depends on it.
  std::size_t bytes_read() const { return bytes_read_; }

 private:
  struct Entry {
    bool is_loaded = false;
    bool is_usable = false;
    std::string owned;
    std::string_view bytes;
  };

  Entry const& buffer(int index);
  void load_buffer(int index, Entry& entry);
  void load_view(int index, Entry& entry);
  std::optional<std::string_view> slice(int buffer, std::uint64_t offset, std::uint64_t length,
                                        std::string const& pointer);
  void decompress(int index, char const* extension, tinygltf::Value const& parameters, Entry& entry);

  Document const& document_;
  Findings& findings_;
  std::vector<Entry> buffers_;
  std::vector<Entry> views_;
  std::size_t bytes_read_;
};

}  // namespace lichtraum::gltf
