#include "support/catch.hpp"
#include "support/encode_png.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_triangles.hpp"

// What the specification does not allow and is clear all the same.

using namespace lichtraum;
using testing::Corners;
using testing::GltfWriter;
using testing::import_model;
using testing::messages;
using testing::triangle_positions;
using testing::world_triangles;

namespace {

std::vector<Corners> const the_triangle = {{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};

/// Moves node 0 to (10, 0, 0) in a second.
void add_motion(GltfWriter& writer) {
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 1});
  int const places = writer.add_vec3({0, 0, 0, 10, 0, 0});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
}

}  // namespace

TEST_CASE("strides that glTF does not allow say where elements are", "[unit][gltf]") {
  GltfWriter writer;
  auto& primitive = writer.add_mesh(triangle_positions);
  int const indices = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{0, 1, 2});
  primitive["indices"] = indices;
  auto& view =
      writer.json["bufferViews"][writer.json["accessors"][std::size_t(indices)]["bufferView"].get<std::size_t>()];
  view["byteStride"] = 2;  // old versions of three.js write that
  Model const model = import_model(writer);
  CHECK(world_triangles(model.scene) == the_triangle);
  CHECK(messages(model) == "/bufferViews/1/byteStride: expected a multiple of 4 in 4..252, found 2\n");

  view["byteStride"] = 1;
  CHECK_THROWS_WITH(import_model(writer), contains_text("elements of 2 bytes lie 1 bytes apart"));
  view["byteStride"] = 0xFFFFFFFFFFFFFFFFu;
  CHECK_THROWS_AS(import_model(writer), SceneError);
}

TEST_CASE("numbers that no double can hold spoil nothing that they do not say", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["meshes"][0]["name"] = "1e999 \\\" -1e999";
  writer.json["accessors"][0]["max"] = {"LARGE", "SMALL", 1e-320};
  std::string text = writer.text();
  auto const replace = [&](std::string const& what, std::string const& by) {
    std::size_t const at = text.find(what);
    REQUIRE(at != std::string::npos);
    text.replace(at, what.size(), by);
  };
  replace("\"LARGE\"", "1.797693134862316e+308");
  replace("\"SMALL\"", "-2E400");
  TemporaryFolder const folder;
  Model const model = import_gltf(folder.write("model.gltf", text), {});
  CHECK(world_triangles(model.scene) == the_triangle);
  CHECK(messages(model) == "2 numbers beyond 1.8e308, the largest that can be read: read as that\n");
  CHECK(model.scene.shapes.find("1e999 \\\" -1e999"));
  text.pop_back();
  CHECK_THROWS_WITH(import_gltf(folder.write("model.gltf", text), {}), contains_text("not JSON"));
}

TEST_CASE("an animated node that has a matrix moves from where that puts it", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  add_motion(writer);
  // Turned by a quarter about z, mirrored along x, twice as large, at (0, 0, 5).
  writer.json["nodes"][0]["matrix"] = {0, -2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0, 0, 5, 1};
  std::vector<Corners> const turned = {{Vec3(0, 0, 5), Vec3(0, -2, 5), Vec3(-2, 0, 5)}};
  auto const at = [&](std::optional<double> seconds) {
    ModelOptions options;
    options.time_seconds = seconds;
    return import_model(writer, options);
  };
  auto const is_near = [](Corners const& found, Corners const& expected) {
    return testing::is_same_triangle(found, expected, 1e-12) ||
           testing::is_same_triangle({found[0], found[2], found[1]}, expected, 1e-12);  // it is mirrored
  };
  Model const still = at(std::nullopt);
  CHECK(messages(still) == "");
  REQUIRE(world_triangles(still.scene).size() == 1);
  CHECK(is_near(world_triangles(still.scene)[0], turned[0]));
  Model const moved = at(1);
  CHECK_THAT(messages(moved), contains_text("/nodes/0/matrix: a node that moves must have no matrix"));
  Corners const expected = {Vec3(10, 0, 0), Vec3(10, -2, 0), Vec3(8, 0, 0)};
  REQUIRE(world_triangles(moved.scene).size() == 1);
  CHECK(is_near(world_triangles(moved.scene)[0], expected));
}

TEST_CASE("a camera is left out for what is wrong with it, or with its node", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}}};
  writer.json["nodes"].push_back({{"camera", 0}, {"scale", {0, 0, 0}}});
  writer.json["nodes"].push_back({{"camera", 1}});
  CHECK(messages(import_model(writer)) ==
        "/nodes/1: its transform leaves no directions: its camera is left out\n"
        "/cameras/1: it shows no width and height: left out\n");
}

TEST_CASE("what a node of no size holds is not there", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 1, 0}}});
  writer.json["nodes"][0]["translation"] = {7, 0, 0};
  auto const drawn = [&] { return world_triangles(import_model(writer).scene).size(); };
  CHECK(drawn() == 2);
  SECTION("itself") {
    writer.json["nodes"][0]["scale"] = {0, 0, 0};
    CHECK_THAT(messages(import_model(writer)), contains_text("/nodes/0: its transform has no inverse"));
    CHECK(drawn() == 1);
  }
  SECTION("and below") {
    writer.json["nodes"].push_back({{"children", {1}}, {"scale", {1, 0, 1}}});
    CHECK(drawn() == 1);
  }
  SECTION("nor its only instance") {
    int const scales = writer.add_vec3({0, 0, 0});
    writer.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"SCALE", scales}};
    CHECK(drawn() == 1);
  }
  SECTION("all of it") {
    for (auto& node : writer.json["nodes"]) node["scale"] = {0, 0, 0};
    Model const model = import_model(writer);
    CHECK(model.scene.shapes.empty());
    CHECK(model.scene.cameras.size() == 1);
  }
}

TEST_CASE("pictures are halved as what they are used for: colours, or data", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions)["material"] = 0;
  std::vector<std::array<std::uint8_t, 4>> const pixels = {{0, 0, 0, 255}, {255, 255, 255, 255}};
  int const view = writer.add_view(test::encode_png(2, 1, pixels));
  for (int i = 0; i < 4; ++i) {
    writer.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    writer.json["textures"].push_back({{"source", i}});
  }
  writer.json["materials"] = {
      {{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}},
       {"emissiveTexture", {{"index", 1}}},
       {"extensions",
        {{"KHR_materials_sheen",
          {{"sheenColorTexture", {{"index", 2}}}, {"sheenRoughnessTexture", {{"index", 3}}}}}}}}};
  ModelOptions options;
  options.max_texture = 1;
  Model const model = import_model(writer, options);
  PbrModel const& pbr = *(*model.scene.materials.begin())->pbr();
  auto const red = [](TextureSlot const& slot) { return int(slot.texture->image->rgba.at(0)); };
  CHECK(red(pbr.metallic_roughness_texture) == 128);
  CHECK(red(pbr.emissive_texture) == 188);
  CHECK(red(pbr.sheen_color_texture) == 188);
  CHECK(red(pbr.sheen_roughness_texture) == 128);
}
