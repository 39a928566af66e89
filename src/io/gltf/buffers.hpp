#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/budget.hpp"
#include "io/gltf/document.hpp"

namespace lichtraum::gltf {

/// The bytes of files, buffers and buffer views, read or decoded when they are first asked for. Each failure is a
/// finding, once.
class Buffers {
 public:
  using Bytes = std::shared_ptr<std::string const>;

  Buffers(Document const& document, Budget& budget, Findings& findings);

  /// A file that the model names, from the model's folder, below it, or one of the allowed folders. There once however
  /// often it is named, for as long as anyone holds it. Null when it may not or cannot be read; `reason` then says why.
  Bytes file(std::string_view uri, std::string& reason);

  /// The bytes of a view; fewer than it declares when its buffer is too short. Nothing when there are none.
  std::optional<std::string_view> view(int index);

 private:
  struct Entry {
    bool is_loaded = false;
    bool is_usable = false;
    Bytes owned;
    std::string_view bytes;
  };

  Entry const& buffer(int index);
  void load_buffer(int index, Entry& entry);
  void load_view(int index, Entry& entry);
  std::optional<std::string_view> slice(int buffer, std::uint64_t offset, std::uint64_t length,
                                        std::string const& pointer);
  void decompress(int index, char const* extension, tinygltf::Value const& parameters, Entry& entry);

  Document const& document_;
  Budget& budget_;
  Findings& findings_;
  std::vector<Entry> buffers_;
  std::vector<Entry> views_;
  std::map<std::filesystem::path, std::weak_ptr<std::string const>> files_;
};

}  // namespace lichtraum::gltf
