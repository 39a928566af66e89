#include "mesh_file.hpp"

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace lichtraum::bench {

TriangleMesh read_mesh(std::string const& path) {
  // Positions, then indices, as they are in the binary chunk of the two measured files.
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::stringstream text;
  text << in.rdbuf();
  std::string const all = text.str();
  std::uint32_t json_length;
  std::memcpy(&json_length, all.data() + 12, 4);
  std::string const json = all.substr(20, json_length);
  auto const number_after = [&](std::string const& key, std::size_t from) {
    return std::stoul(json.substr(json.find(key, from) + key.size()));
  };
  std::size_t const accessors = json.find("\"accessors\"");
  std::size_t const first = json.find("\"count\":", accessors);
  std::size_t const vertex_count = number_after("\"count\":", accessors);
  std::size_t const index_count = number_after("\"count\":", first + 8);
  TriangleMesh mesh;
  mesh.positions.resize(vertex_count);
  mesh.triangles.resize(index_count / 3);
  char const* data = all.data() + 20 + json_length + 8;
  std::memcpy(mesh.positions.data(), data, vertex_count * 12);
  std::memcpy(mesh.triangles.data(), data + vertex_count * 12, index_count * 4);
  return mesh;
}

}  // namespace lichtraum::bench
