#include "node_model.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace lichtraum::bench {
namespace {

constexpr int sides = 40;

/// A closed ring of triangles between two circles.
std::string ring() {
  std::vector<float> positions;
  std::vector<std::uint16_t> indices;
  for (int i = 0; i < sides; ++i) {
    float const angle = 6.2831853f * float(i) / sides;
    for (float const y : {-0.3f, 0.3f})
      positions.insert(positions.end(), {0.4f * std::cos(angle), y, 0.4f * std::sin(angle)});
    auto const corner = [&](int n) { return std::uint16_t((2 * i + n) % (2 * sides)); };
    indices.insert(indices.end(), {corner(0), corner(1), corner(2), corner(2), corner(1), corner(3)});
  }
  std::string bytes(reinterpret_cast<char const*>(positions.data()), positions.size() * sizeof(float));
  bytes.append(reinterpret_cast<char const*>(indices.data()), indices.size() * sizeof(std::uint16_t));
  return bytes;
}

void write_chunk(std::ofstream& out, std::uint32_t type, std::string const& bytes) {
  auto const length = std::uint32_t(bytes.size());
  out.write(reinterpret_cast<char const*>(&length), 4).write(reinterpret_cast<char const*>(&type), 4);
  out.write(bytes.data(), std::streamsize(bytes.size()));
}

}  // namespace

void write_node_model(std::filesystem::path const& path, int nodes) {
  std::string const binary = ring();
  std::size_t const position_bytes = 2 * sides * 12;
  nlohmann::json model = {
      {"asset", {{"version", "2.0"}}},
      {"buffers", {{{"byteLength", binary.size()}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", position_bytes}},
        {{"buffer", 0}, {"byteOffset", position_bytes}, {"byteLength", binary.size() - position_bytes}}}},
      {"accessors",
       {{{"bufferView", 0}, {"componentType", 5126}, {"count", 2 * sides}, {"type", "VEC3"}},
        {{"bufferView", 1}, {"componentType", 5123}, {"count", 6 * sides}, {"type", "SCALAR"}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}}};
  int const row = int(std::ceil(std::sqrt(double(nodes))));
  for (int i = 0; i < nodes; ++i) {
    model["nodes"].push_back({{"name", "ring " + std::to_string(i)},
                              {"mesh", 0},
                              {"translation", {i % row, 0, i / row}},
                              {"rotation", {0, std::sin(0.01 * i), 0, std::cos(0.01 * i)}},
                              {"scale", {1, 1 + 0.0001 * i, 1}}});
    model["scenes"][0]["nodes"].push_back(i);
  }
  std::string json = model.dump();
  json.append((4 - json.size() % 4) % 4, ' ');
  std::ofstream out(path, std::ios::binary);
  std::uint32_t const header[] = {0x46546C67, 2, std::uint32_t(12 + 8 + json.size() + 8 + binary.size())};
  out.write(reinterpret_cast<char const*>(header), sizeof header);
  write_chunk(out, 0x4E4F534A, json);
  write_chunk(out, 0x004E4942, binary);
}

}  // namespace lichtraum::bench
