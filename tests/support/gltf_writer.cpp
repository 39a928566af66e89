#include "support/gltf_writer.hpp"

namespace lichtraum::testing {
namespace {

void append_uint32(std::string& out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(char(value >> (8 * i) & 0xFF));
}

void append_chunk(std::string& out, std::string content, std::size_t type, char padding) {
  while (content.size() % 4 != 0) content.push_back(padding);
  append_uint32(out, content.size());
  append_uint32(out, type);
  out += content;
}

}  // namespace

std::string encode_base64(std::string const& bytes) {
  static char const digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out.push_back(i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=');
  }
  return out;
}

std::string GltfWriter::text() const {
  nlohmann::json model = json;
  if (!buffer_.empty() && !model.contains("buffers")) {
    model["buffers"] = {
        {{"byteLength", buffer_.size()}, {"uri", "data:application/octet-stream;base64," + encode_base64(buffer_)}}};
  }
  return model.dump();
}

std::string GltfWriter::glb() const {
  nlohmann::json model = json;
  if (!model.contains("buffers")) model["buffers"] = {{{"byteLength", buffer_.size()}}};
  std::string chunks;
  append_chunk(chunks, model.dump(), 0x4E4F534A, ' ');
  append_chunk(chunks, buffer_, 0x004E4942, '\0');
  std::string file = "glTF";
  append_uint32(file, 2);
  append_uint32(file, 12 + chunks.size());
  return file + chunks;
}

}  // namespace lichtraum::testing
