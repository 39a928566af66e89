#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "support/catch.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_triangles.hpp"

// Buffers that the libraries' own encoders wrote, and instances. What damaged ones do is in the fuzzers and the corpus.

using namespace lichtraum;
using testing::Corners;
using testing::GltfWriter;
using testing::import_model;
using testing::is_same_triangle;
using testing::messages;
using testing::world_triangles;
using Json = nlohmann::json;

namespace {

std::vector<float> const square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
std::vector<unsigned> const square_indices = {0, 1, 2, 0, 2, 3};
std::vector<Corners> const square_triangles = {{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)},
                                               {Vec3(0), Vec3(1, 1, 0), Vec3(0, 1, 0)}};

void check_square(Model const& model) {
  CHECK(messages(model) == "");
  auto const found = world_triangles(model.scene);
  REQUIRE(found.size() == 2);
  for (Corners const& expected : square_triangles) {
    CHECK((is_same_triangle(found[0], expected, 1e-6) || is_same_triangle(found[1], expected, 1e-6)));
  }
}

/// What is said of a model that has nothing else to draw.
std::string refusal(GltfWriter const& writer) {
  try {
    import_model(writer);
  } catch (SceneError const& error) {
    std::string all;
    for (auto const& d : error.diagnostics()) all += d.message + '\n';
    return all;
  }
  FAIL("the model was read");
  return {};
}

template <class T>
std::string bytes_of(std::vector<T> const& values) {
  return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}

/// A view that holds `count` elements of `stride` bytes, as meshoptimizer packed them.
int add_packed_view(GltfWriter& writer, std::string const& packed, std::string const& mode, std::size_t count,
                    std::size_t stride, std::string const& filter = "NONE") {
  int const number = writer.add_view(packed);
  Json& view = writer.json["bufferViews"][std::size_t(number)];
  Json const parameters = {{"buffer", 0},
                           {"byteOffset", view["byteOffset"]},
                           {"byteLength", packed.size()},
                           {"mode", mode},
                           {"count", count},
                           {"byteStride", stride},
                           {"filter", filter}};
  view = {{"buffer", 0},
          {"byteOffset", 0},
          {"byteLength", count * stride},
          {"extensions", {{"EXT_meshopt_compression", parameters}}}};
  if (mode == "ATTRIBUTES") view["byteStride"] = stride;
  return number;
}

std::string packed_vertices(std::string const& bytes, std::size_t stride) {
  std::size_t const count = bytes.size() / stride;
  std::string packed(meshopt_encodeVertexBufferBound(count, stride), '\0');
  packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(), bytes.data(),
                                           count, stride));
  return packed;
}

std::string packed_indices(bool is_sequence) {
  std::size_t const count = square_indices.size();
  std::string packed(
      is_sequence ? meshopt_encodeIndexSequenceBound(count, 4) : meshopt_encodeIndexBufferBound(count, 4), '\0');
  auto* const out = reinterpret_cast<unsigned char*>(packed.data());
  packed.resize(is_sequence ? meshopt_encodeIndexSequence(out, packed.size(), square_indices.data(), count)
                            : meshopt_encodeIndexBuffer(out, packed.size(), square_indices.data(), count));
  return packed;
}

/// A mesh of the square whose positions and indices are those of the views.
void add_mesh(GltfWriter& writer, int position_view, Json positions, int index_view) {
  positions.update({{"bufferView", position_view}, {"count", 4}, {"type", "VEC3"}});
  writer.json["accessors"] = {positions,
                              {{"bufferView", index_view}, {"componentType", 5125}, {"count", 6}, {"type", "SCALAR"}}};
  writer.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  writer.json["nodes"] = {{{"mesh", 0}}};
}

}  // namespace

TEST_CASE("meshoptimizer's vertices, triangles and sequences of indices are unpacked", "[unit][gltf]") {
  for (bool const is_sequence : {false, true}) {
    GltfWriter writer;
    int const positions = add_packed_view(writer, packed_vertices(bytes_of(square), 12), "ATTRIBUTES", 4, 12);
    int const indices =
        add_packed_view(writer, packed_indices(is_sequence), is_sequence ? "INDICES" : "TRIANGLES", 6, 4);
    add_mesh(writer, positions, {{"componentType", 5126}}, indices);
    check_square(import_model(writer));
  }
}

TEST_CASE("meshoptimizer's filters are taken off", "[unit][gltf]") {
  int const scale = GENERATE(0, 1, -1);
  // A number is a signed mantissa of 24 bits and an exponent of 2 above it.
  std::vector<std::uint32_t> exponential;
  for (float const value : square) {
    auto const mantissa = std::uint32_t(int(value) * (scale < 0 ? 2 : 1));
    exponential.push_back(mantissa | std::uint32_t(scale < 0 ? -1 : 0) << 24);
  }
  if (scale <= 0) {
    GltfWriter writer;
    int const positions =
        add_packed_view(writer, packed_vertices(bytes_of(exponential), 12), "ATTRIBUTES", 4, 12, "EXPONENTIAL");
    int const indices = add_packed_view(writer, packed_indices(false), "TRIANGLES", 6, 4);
    add_mesh(writer, positions, {{"componentType", 5126}}, indices);
    check_square(import_model(writer));
    return;
  }
  // Directions as x and y on an octahedron, z being what is left of 127: z, x, y, and between x and y.
  std::vector<std::int8_t> const directions = {0, 0, 127, 0, 127, 0, 127, 0, 0, 127, 127, 0, 64, 63, 127, 0};
  GltfWriter writer;
  int const positions =
      add_packed_view(writer, packed_vertices(bytes_of(directions), 4), "ATTRIBUTES", 4, 4, "OCTAHEDRAL");
  int const indices = add_packed_view(writer, packed_indices(false), "TRIANGLES", 6, 4);
  add_mesh(writer, positions, {{"componentType", 5120}, {"normalized", true}}, indices);
  Model const model = import_model(writer);
  auto const found = world_triangles(model.scene);
  REQUIRE(found.size() == 2);
  double const half = std::sqrt(0.5);
  CHECK(is_same_triangle(found[0], {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.01));
  CHECK(is_same_triangle(found[1], {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(half, half, 0)}, 0.02));
}

TEST_CASE("what meshoptimizer cannot have packed is named", "[unit][gltf]") {
  struct Case {
    char const *mode, *filter, *message;
    std::size_t count, stride;
  };
  for (Case const& c : {Case{"POINTS", "NONE", "unknown mode 'POINTS'", 4, 12},
                        Case{"INDICES", "NONE", "mode INDICES with count 4 and byteStride 3", 4, 3},
                        Case{"TRIANGLES", "NONE", "mode TRIANGLES with count 4 and byteStride 4", 4, 4},
                        Case{"ATTRIBUTES", "OCTAHEDRAL", "filter 'OCTAHEDRAL' does not go with", 4, 12},
                        Case{"ATTRIBUTES", "NONE", "cannot hold 1000000000 elements", 1000000000, 12},
                        Case{"ATTRIBUTES", "NONE", "the compressed data is damaged", 5, 12}}) {
    GltfWriter writer;
    std::string packed = packed_vertices(bytes_of(square), 12);
    packed[0] = '\0';  // no version of theirs
    int const positions = add_packed_view(writer, packed, c.mode, c.count, c.stride, c.filter);
    int const indices = add_packed_view(writer, packed_indices(false), "TRIANGLES", 6, 4);
    add_mesh(writer, positions, {{"componentType", 5126}}, indices);
    CHECK_THAT(refusal(writer), contains_text(c.message));
  }
}

TEST_CASE("views that unpack one piece of data again and again are refused", "[unit][gltf]") {
  constexpr std::size_t count = 500'000, stride = 16;
  GltfWriter writer;
  int const first =
      add_packed_view(writer, packed_vertices(std::string(count * stride, '\0'), stride), "ATTRIBUTES", count, stride);
  auto& model = writer.json;
  Json const view = model["bufferViews"][std::size_t(first)];
  auto const import_with = [&](std::size_t views) {
    model["bufferViews"] = model["accessors"] = Json::array();
    model["meshes"] = {{{"primitives", Json::array()}}};
    model["nodes"] = {{{"mesh", 0}}};
    for (std::size_t i = 0; i < views; ++i) {
      model["bufferViews"].push_back(view);
      model["accessors"].push_back({{"bufferView", i}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
      model["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", i}}}});
    }
  };
  import_with(2);
  CHECK(messages(import_model(writer)) == "");
  import_with(100);  // of 8 MB each
  CHECK_THAT(refusal(writer), contains_text("the model unfolds to more than"));
}

TEST_CASE("Draco's triangles are unpacked", "[unit][gltf]") {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  int const attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (unsigned face = 0; face < 2; ++face) {
    auto const corner = [&](unsigned i) { return square.data() + 3 * square_indices[3 * face + i]; };
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(face), corner(0), corner(1), corner(2));
  }
  auto const mesh = builder.Finalize();
  REQUIRE(mesh);
  draco::Encoder encoder;
  draco::EncoderBuffer packed;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &packed).ok());

  GltfWriter writer;
  int const view = writer.add_view({packed.data(), packed.size()});
  writer.json["accessors"] = {{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                              {{"componentType", 5125}, {"count", 6}, {"type", "SCALAR"}}};
  Json& extension = (writer.json["meshes"] = {
                         {{"primitives",
                           {{{"attributes", {{"POSITION", 0}}},
                             {"indices", 1}}}}}})[0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  extension = {{"bufferView", view}, {"attributes", {{"POSITION", mesh->attribute(attribute)->unique_id()}}}};
  writer.json["nodes"] = {{{"mesh", 0}}};
  check_square(import_model(writer));

  extension["attributes"]["POSITION"] = 99;
  CHECK_THAT(refusal(writer), contains_text("attribute POSITION (id 99) cannot be read"));
  extension["attributes"]["POSITION"] = 0;
  writer.buffer()[0] = 'x';
  CHECK_THAT(refusal(writer), contains_text("Draco: "));
  extension["bufferView"] = 7;
  CHECK_THAT(refusal(writer), contains_text("bufferView or attributes are missing or out of range"));
}

TEST_CASE("whether Draco's integers are fractions is for the accessor to say", "[unit][gltf]") {
  for (bool const is_flagged : {true, false}) {
    for (bool const is_normalized : {true, false}) {
      INFO(is_flagged << ' ' << is_normalized);
      draco::TriangleSoupMeshBuilder builder;
      builder.Start(1);
      int const position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
      int const color = builder.AddAttribute(draco::GeometryAttribute::COLOR, 3, draco::DT_UINT8, is_flagged);
      std::vector<std::uint8_t> const half = {51, 51, 51};
      builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), square.data(), square.data() + 3,
                                        square.data() + 6);
      builder.SetAttributeValuesForFace(color, draco::FaceIndex(0), half.data(), half.data(), half.data());
      auto const mesh = builder.Finalize();
      REQUIRE(mesh);
      draco::Encoder encoder;
      draco::EncoderBuffer packed;
      REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &packed).ok());

      GltfWriter writer;
      int const view = writer.add_view({packed.data(), packed.size()});
      writer.json["accessors"] = {
          {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
          {{"componentType", 5121}, {"count", 3}, {"type", "VEC3"}, {"normalized", is_normalized}}};
      Json const attributes = {{"POSITION", mesh->attribute(position)->unique_id()},
                               {"COLOR_0", mesh->attribute(color)->unique_id()}};
      Json primitive = {{"attributes", {{"POSITION", 0}, {"COLOR_0", 1}}}};
      primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", attributes}};
      writer.json["meshes"] = {{{"primitives", {primitive}}}};
      writer.json["nodes"] = {{{"mesh", 0}}};
      Model const model = import_model(writer);
      CHECK(messages(model) == "");
      for (auto const& shape : model.scene.shapes) {
        auto const* shown = dynamic_cast<Mesh const*>(shape.get());
        if (shown) CHECK(shown->geometry()->colors.at(0)[0] == Approx(is_normalized ? 0.2 : 51));
      }
    }
  }
}

TEST_CASE("a node's instances are moved, turned and scaled", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  float const half = float(std::sqrt(0.5));
  int const translations = writer.add_vec3({5, 0, 0, 0, 7, 0, 0, 0, 0});
  int const scales = writer.add_vec3({2, 2, 2, 1, 1, 1, 0, 0, 0});
  int const rotations = writer.add_accessor<float>("VEC4", 4, {half, 0, 0, half, 0, 0, half, half, 0, 0, 0, 1});
  Json& attributes = writer.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", translations}, {"SCALE", scales}, {"ROTATION", rotations}};
  Model const model = import_model(writer);
  CHECK_THAT(messages(model), contains_text("1 of 3 instances have no size: left out"));
  auto const found = world_triangles(model.scene);
  REQUIRE(found.size() == 2);
  Corners const scaled = {Vec3(5, 0, 0), Vec3(7, 0, 0), Vec3(5, 0, 2)};   // and turned by a quarter, about x
  Corners const turned = {Vec3(0, 7, 0), Vec3(0, 8, 0), Vec3(-1, 7, 0)};  // by a quarter, about z
  std::size_t const first = is_same_triangle(found[0], scaled, 1e-6) ? 0 : 1;
  CHECK(is_same_triangle(found[first], scaled, 1e-6));
  CHECK(is_same_triangle(found[1 - first], turned, 1e-6));

  attributes["SCALE"] = writer.add_vec3({1, 1, 1});
  Model const inconsistent = import_model(writer);
  CHECK_THAT(messages(inconsistent), contains_text("the instances cannot be read; one is drawn"));
  CHECK(world_triangles(inconsistent.scene).size() == 1);
}
