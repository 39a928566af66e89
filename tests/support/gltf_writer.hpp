#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lichtraum::testing {

/// Builds small glTF models: one buffer that grows with each accessor, and JSON that a test changes as it likes.
class GltfWriter {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};

  enum Component { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

  /// Appends a view with these bytes; returns its number.
  int add_view(std::string const& bytes) {
    while (buffer_.size() % 4 != 0) buffer_.push_back('\0');
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_ += bytes;
    return int(json["bufferViews"].size()) - 1;
  }

  /// Appends an accessor with a view of its own; returns its number. `type`: "SCALAR", "VEC3", ...
  template <class T>
  int add_accessor(char const* type, std::size_t components, std::vector<T> const& values, bool normalized = false) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    nlohmann::json accessor = {{"bufferView", add_view(bytes)},
                               {"componentType", component<T>()},
                               {"count", values.size() / components},
                               {"type", type}};
    if (normalized) accessor["normalized"] = true;
    json["accessors"].push_back(accessor);
    return int(json["accessors"].size()) - 1;
  }
  int add_vec3(std::vector<float> const& values) { return add_accessor("VEC3", 3, values); }

  /// Appends a mesh with one primitive and a node that shows it; returns the primitive.
  nlohmann::json& add_mesh(std::vector<float> const& positions) {
    int const accessor = add_vec3(positions);
    json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    return json["meshes"].back()["primitives"][0];
  }

  /// The buffer's bytes, to be damaged.
  std::string& buffer() { return buffer_; }

  std::string text() const;  ///< a .gltf with the buffer as a data URI
  std::string glb() const;

 private:
  template <class T>
  static int component() {
    if constexpr (std::is_same_v<T, float>) return float32;
    if constexpr (std::is_same_v<T, std::int8_t>) return int8;
    if constexpr (std::is_same_v<T, std::uint8_t>) return uint8;
    if constexpr (std::is_same_v<T, std::int16_t>) return int16;
    if constexpr (std::is_same_v<T, std::uint16_t>) return uint16;
    if constexpr (std::is_same_v<T, std::uint32_t>) return uint32;
  }

  std::string buffer_;
};

std::string encode_base64(std::string const& bytes);

}  // namespace lichtraum::testing
