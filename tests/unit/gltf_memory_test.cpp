#include <algorithm>

#include "lichtraum/gltf.hpp"
#include "support/catch.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_triangles.hpp"
#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using testing::Corners;
using testing::GltfWriter;
using testing::import_model;
using testing::messages;
using testing::world_triangles;

namespace {

/// `element(i)` for each of `count` vertices, one after the other.
template <class Element>
auto for_each_vertex(std::size_t count, Element const& element) {
  auto list = element(0);
  list.clear();
  for (std::size_t i = 0; i < count; ++i) {
    auto const values = element(float(i));
    list.insert(list.end(), values.begin(), values.end());
  }
  return list;
}

using Floats = std::vector<float>;
using Bytes = std::vector<std::uint8_t>;

std::vector<std::shared_ptr<MeshGeometry const>> geometries_of(Scene const& scene) {
  std::vector<std::shared_ptr<MeshGeometry const>> found;
  for (auto const& shape : scene.shapes) {
    if (auto const* mesh = dynamic_cast<Mesh const*>(shape.get())) found.push_back(mesh->geometry());
  }
  return found;
}

}  // namespace

TEST_CASE("of the vertices that primitives share, each keeps those that its indices name", "[unit][gltf]") {
  constexpr std::size_t count = 12;
  GltfWriter writer;
  auto& attributes = writer.add_mesh(for_each_vertex(count, [](float i) { return Floats{i, i * i, 0}; }))["attributes"];
  attributes["NORMAL"] = writer.add_vec3(for_each_vertex(count, [](float i) { return Floats{i, 0, 1}; }));
  auto const tangents = for_each_vertex(count, [](float i) { return Floats{i, 1, 0, -1}; });
  attributes["TANGENT"] = writer.add_accessor("VEC4", 4, tangents);
  auto const texcoords = for_each_vertex(count, [](float i) { return Floats{i, -i}; });
  attributes["TEXCOORD_0"] = writer.add_accessor("VEC2", 2, texcoords);
  auto const colors = for_each_vertex(count, [](float i) { return Floats{i, 0, 0}; });
  attributes["COLOR_0"] = writer.add_accessor("VEC3", 3, colors);
  auto& primitive = writer.json["meshes"][0]["primitives"][0];
  primitive["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{9, 4, 11});

  Model const model = import_model(writer);
  CHECK(messages(model) == "");
  auto const all = geometries_of(model.scene);
  REQUIRE(all.size() == 1);
  MeshGeometry const& geometry = *all[0];
  CHECK(geometry.positions == std::vector<Float3>{{4, 16, 0}, {9, 81, 0}, {11, 121, 0}});
  CHECK(geometry.indices == std::vector<std::uint32_t>{1, 0, 2});
  CHECK(geometry.normals == std::vector<Float3>{{4, 0, 1}, {9, 0, 1}, {11, 0, 1}});
  CHECK(geometry.tangents == std::vector<Float4>{{4, 1, 0, -1}, {9, 1, 0, -1}, {11, 1, 0, -1}});
  CHECK(geometry.texcoords == std::vector<std::vector<Float2>>{{{4, -4}, {9, -9}, {11, -11}}});
  CHECK(geometry.colors == std::vector<Float4>{{4, 0, 0, 1}, {9, 0, 0, 1}, {11, 0, 0, 1}});

  SECTION("morph targets and joints go with them, also of geometry that was read before") {
    int const deltas = writer.add_vec3({0, 0, 1, 0, 0, 2, 0, 0, 3});
    int const vertices = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{4, 5, 11});
    auto& accessors = writer.json["accessors"];
    nlohmann::json const sparse = {
        {"count", 3},
        {"indices", {{"bufferView", accessors[std::size_t(vertices)]["bufferView"]}, {"componentType", 5123}}},
        {"values", {{"bufferView", accessors[std::size_t(deltas)]["bufferView"]}}}};
    accessors.push_back({{"componentType", 5126}, {"count", count}, {"type", "VEC3"}, {"sparse", sparse}});
    auto const target = accessors.size() - 1;
    nlohmann::json mesh = writer.json["meshes"][0];
    mesh["primitives"][0]["targets"] = {{{"POSITION", target}}};
    mesh["weights"] = {1};
    writer.json["meshes"].push_back(mesh);
    writer.json["nodes"].push_back({{"mesh", 1}});
    auto const joints = for_each_vertex(count, [](float i) { return Bytes{std::uint8_t(int(i) % 2), 0, 0, 0}; });
    auto const weights = for_each_vertex(count, [](float) { return Floats{1, 0, 0, 0}; });
    auto& skinned = writer.json["meshes"][1]["primitives"][0]["attributes"];
    skinned["JOINTS_0"] = writer.add_accessor("VEC4", 4, joints);
    skinned["WEIGHTS_0"] = writer.add_accessor("VEC4", 4, weights);
    writer.json["skins"] = {{{"joints", {2, 3}}}};
    writer.json["nodes"][1]["skin"] = 0;
    writer.json["nodes"].push_back({{"translation", {0, 0, 0}}});
    writer.json["nodes"].push_back({{"translation", {0, 0, 10}}});  // of the odd vertices
    // Once more, morphed alone: the geometry is known by then.
    nlohmann::json again = writer.json["meshes"][0];
    again["primitives"][0]["targets"] = {{{"POSITION", target}}};
    again["weights"] = {1};
    writer.json["meshes"].push_back(again);
    writer.json["nodes"].push_back({{"mesh", 2}});

    Model const moved = import_model(writer);
    CHECK(messages(moved) == "");
    auto triangles = world_triangles(moved.scene);
    REQUIRE(triangles.size() == 3);
    auto const has = [&](Corners const& corners) {
      return std::count(triangles.begin(), triangles.end(), corners) == 1;
    };
    CHECK(has({Vec3(9, 81, 0), Vec3(4, 16, 0), Vec3(11, 121, 0)}));
    CHECK(has({Vec3(9, 81, 10), Vec3(4, 16, 1), Vec3(11, 121, 13)}));
    CHECK(has({Vec3(9, 81, 0), Vec3(4, 16, 1), Vec3(11, 121, 3)}));
  }
  SECTION("an index out of range is told as before") {
    primitive["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{9, 4, 11, 0, 1, 12});
    Model const cut = import_model(writer);
    CHECK(messages(cut).find("an index that is out of range (12)") != std::string::npos);
    CHECK(world_triangles(cut.scene) == world_triangles(model.scene));
  }
  SECTION("an attribute with too few elements is told as before") {
    attributes["NORMAL"] = writer.add_vec3({0, 0, 1, 0, 0, 1});
    Model const flat = import_model(writer);
    CHECK(messages(flat).find("2 elements for 12 positions") != std::string::npos);
    CHECK(geometries_of(flat.scene).at(0)->normals.empty());
  }
}

TEST_CASE("many primitives may share one large vertex buffer", "[unit][gltf]") {
  constexpr std::size_t count = 100'000;
  GltfWriter writer;
  writer.add_mesh(for_each_vertex(count, [](float i) { return Floats{i, i * i, 0}; }));
  auto& primitives = writer.json["meshes"][0]["primitives"];
  nlohmann::json const primitive = primitives[0];
  primitives.clear();
  for (std::uint16_t i = 0; i < 1000; ++i) {
    primitives.push_back(primitive);
    std::vector<std::uint16_t> const corners{i, std::uint16_t(i + 1), std::uint16_t(i + 2)};
    primitives.back()["indices"] = writer.add_accessor("SCALAR", 1, corners);
  }
  Model const model = import_model(writer, {}, "model.glb");  // 1.2 GB if each kept all
  CHECK(messages(model) == "");
  CHECK(world_triangles(model.scene).size() == 1000);
}

namespace {

/// Why it cannot be imported; "" where it can.
std::string error_of(GltfWriter const& writer) {
  try {
    import_model(writer);
    return "";
  } catch (SceneError const& error) {
    return error.what();
  }
}

constexpr char const* unfolds = "the model unfolds to more than";

/// A mesh of `count` vertices that take no bytes, with a target that moves nothing.
void add_zeros(GltfWriter& writer, std::size_t count) {
  writer.json["accessors"].push_back({{"componentType", 5126}, {"count", count}, {"type", "VEC3"}});
  auto const zeros = writer.json["accessors"].size() - 1;
  nlohmann::json const attributes = {{"POSITION", zeros}};
  writer.json["meshes"].push_back({{"primitives", {{{"attributes", attributes}, {"targets", {attributes}}}}}});
}

}  // namespace

TEST_CASE("copies that nodes deform take no more memory than the file may ask for", "[unit][gltf]") {
  GltfWriter writer;
  add_zeros(writer, 1'000'000);
  auto const import_with = [&](std::size_t nodes, nlohmann::json const& node) {
    writer.json["nodes"] = std::vector<nlohmann::json>(nodes, node);
    return error_of(writer);
  };
  CHECK(import_with(2, {{"mesh", 0}, {"weights", {1}}}) == "");
  CHECK(import_with(50, {{"mesh", 0}}) == "");  // one shape
  CHECK(import_with(50, {{"mesh", 0}, {"weights", {0}}}) == "");
  CHECK(import_with(50, {{"mesh", 0}, {"weights", {1}}}).find(unfolds) != std::string::npos);
}

TEST_CASE("copies that joints move take no more memory than the file may ask for", "[unit][gltf]") {
  GltfWriter writer;
  add_zeros(writer, 1'000'000);
  writer.json["accessors"].push_back({{"componentType", 5121}, {"count", 1'000'000}, {"type", "VEC4"}});
  auto& attributes = writer.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = attributes["WEIGHTS_0"] = 1;
  writer.json["skins"] = {{{"joints", {0}}}};
  auto const import_with = [&](std::size_t nodes) {
    writer.json["nodes"] = std::vector<nlohmann::json>(nodes, {{"mesh", 0}, {"skin", 0}});
    return error_of(writer);
  };
  CHECK(import_with(2) == "");
  CHECK(import_with(50).find(unfolds) != std::string::npos);
}

TEST_CASE("instances take no more memory than the file may ask for", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  auto const import_with = [&](std::size_t count, std::string const& name) {
    writer.json["accessors"][1] = {{"componentType", 5126}, {"count", count}, {"type", "VEC3"}};
    writer.json["nodes"][0]["name"] = name;
    writer.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 1;
    return error_of(writer);
  };
  CHECK(import_with(1000, "node") == "");
  CHECK(import_with(1'048'576, "node").find(unfolds) != std::string::npos);
  CHECK(import_with(10'000, std::string(100'000, 'n')).find(unfolds) != std::string::npos);
}

TEST_CASE("long names of primitives take no more memory than the file may ask for", "[unit][gltf]") {
  GltfWriter writer;
  nlohmann::json const primitive = writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  writer.json["meshes"][0]["primitives"] = std::vector<nlohmann::json>(10'000, primitive);
  CHECK(error_of(writer) == "");
  writer.json["meshes"][0]["name"] = std::string(100'000, 'n');
  CHECK(error_of(writer).find(unfolds) != std::string::npos);
}

TEST_CASE("poses made one after the other share no budget", "[unit][gltf]") {
  GltfWriter writer;
  add_zeros(writer, 1'000'000);
  writer.json["nodes"] = {{{"mesh", 0}, {"weights", {1}}}};
  TemporaryFolder const folder;
  GltfAnimation animation(folder.write("model.gltf", writer.text()), {});
  for (int i = 0; i < 50; ++i) CHECK_NOTHROW(animation.pose(std::nullopt));
}

TEST_CASE("files that are named again and again are read once", "[unit][gltf]") {
  constexpr std::size_t count = 300;
  TemporaryFolder const folder;
  GltfWriter triangle;
  triangle.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  folder.write("shared.bin", triangle.buffer() + std::string(4'000'000, '\0'));
  nlohmann::json model = triangle.json;
  model["buffers"] = model["bufferViews"] = model["accessors"] = nlohmann::json::array();
  auto& primitives = model["meshes"][0]["primitives"];
  primitives.clear();
  for (std::size_t i = 0; i < count; ++i) {  // by names that differ
    std::string name = "shared.bin";
    for (std::size_t k = 0; k < i; ++k) name.insert(0, "./");
    model["buffers"].push_back({{"byteLength", 36}, {"uri", name}});
    model["bufferViews"].push_back({{"buffer", i}, {"byteLength", 36}});
    model["accessors"].push_back({{"bufferView", i}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    primitives.push_back({{"attributes", {{"POSITION", i}}}});
  }
  // What files hold, zeros without a view may take: 1,048,576 and one for each byte.
  auto const import_with_zeros = [&](std::size_t zeros) {
    model["accessors"].push_back({{"componentType", 5126}, {"count", zeros}, {"type", "VEC3"}});
    primitives.push_back({{"attributes", {{"POSITION", count}}}});
    std::string const found = messages(import_gltf(folder.write("model.gltf", model.dump())));
    model["accessors"].erase(count);
    primitives.erase(count);
    return found;
  };
  CHECK(import_with_zeros(4'000'000) == "");
  CHECK(import_with_zeros(8'000'000).find("declares 8000000 zeros") != std::string::npos);
}
