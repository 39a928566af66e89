#include "lichtraum/gltf.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_triangles.hpp"
#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using testing::Corners;
using testing::GltfWriter;
using testing::import_model;
using testing::is_same_triangle;
using testing::messages;
using testing::triangle_positions;
using testing::world_triangles;

namespace {

/// A triangle whose normals are +z and whose tangents are +x; -1: the bitangents are -y.
GltfWriter triangle_with_tangents() {
  GltfWriter writer;
  auto& attributes = writer.add_mesh(triangle_positions)["attributes"];
  attributes["NORMAL"] = writer.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  attributes["TANGENT"] = writer.add_accessor("VEC4", 4, std::vector<float>{1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1});
  return writer;
}

/// That of the only mesh.
MeshGeometry const& geometry_of(Scene const& scene) {
  for (auto const& shape : scene.shapes) {
    if (auto const* mesh = dynamic_cast<Mesh const*>(shape.get())) return *mesh->geometry();
  }
  throw std::runtime_error("the scene has no mesh");
}

std::vector<Float4> tangents_of(Scene const& scene) { return geometry_of(scene).tangents; }

bool are_near(std::vector<Float4> const& tangents, Float4 const& expected) {
  return tangents.size() == 3 && std::all_of(tangents.begin(), tangents.end(), [&](Float4 const& tangent) {
           for (std::size_t i = 0; i < 4; ++i) {
             if (std::abs(tangent[i] - expected[i]) > 1e-6f) return false;
           }
           return true;
         });
}

/// Appends a skin of one joint, to which the only mesh is bound, and whose node is `joint`.
void bind_to_joint(GltfWriter& writer, nlohmann::json joint) {
  auto& attributes = writer.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = writer.add_accessor("VEC4", 4, std::vector<std::uint8_t>(12, 0));
  attributes["WEIGHTS_0"] = writer.add_accessor("VEC4", 4, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  writer.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, std::move(joint)};
  writer.json["skins"] = {{{"joints", {1}}}};
}

}  // namespace

TEST_CASE("a triangle in a .gltf and in a .glb", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  for (char const* name : {"model.gltf", "model.glb"}) {
    Model const model = import_model(writer, {}, name);
    CHECK(messages(model) == "");
    auto const triangles = world_triangles(model.scene);
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  }
}

TEST_CASE("a model without camera and lights gets some that show it", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  Model const model = import_model(writer);
  Scene const& scene = model.scene;
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.lights.size() == 3);
  Camera const& camera = scene.cameras.front();
  REQUIRE(camera.resolution());
  auto const root = scene.roots().at(0);
  Resolution const size{40, 30};
  int seen = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Hit hit;
      if (root->closest_hit(camera.generate_ray(x + 0.5, y + 0.5, size), 0, hit)) ++seen;
    }
  }
  CHECK(seen > 0.15 * size.width * size.height);
}

TEST_CASE("a scene has the material for parts that name none only where there are such parts", "[unit][gltf]") {
  auto const names = [](GltfWriter& writer) {
    std::string all;
    for (auto const& material : import_model(writer).scene.materials) all += material->name() + " ";
    return all;
  };
  GltfWriter writer;
  writer.json["materials"] = {{{"name", "red"}}, {{"name", "unused"}}};
  writer.add_mesh(triangle_positions);
  CHECK(names(writer) == "red unused default ");
  writer.json["meshes"][0]["primitives"][0]["material"] = 0;
  CHECK(names(writer) == "red unused ");
}

TEST_CASE("channels of KHR_animation_pointer are named and skipped", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  int const times = writer.add_accessor<float>("SCALAR", 1, {0, 2.5f});
  int const values = writer.add_vec3({0, 0, 0, 4, 0, 0});
  writer.json["animations"] = {
      {{"name", "move"},
       {"samplers", {{{"input", times}, {"output", values}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", nlohmann::json::object()}}}},
         {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  writer.json["extensionsUsed"] = {"KHR_animation_pointer", "KHR_materials_unlit"};
  writer.json["extensionsRequired"] = {"KHR_animation_pointer"};
  ModelOptions options;
  options.time_seconds = 2.5;
  Model const model = import_model(writer, options);
  CHECK_THAT(messages(model), contains_text("/animations/0/channels: 1 channels need KHR_animation_pointer"));
  CHECK(world_triangles(model.scene).at(0)[0] == Vec3(4, 0, 0));
  REQUIRE(model.contents.animations.size() == 1);
  CHECK(model.contents.animations[0].name == "move");
  CHECK(model.contents.animations[0].seconds == 2.5);
  REQUIRE(model.contents.extensions.size() == 2);
  CHECK(model.contents.extensions[0].is_required);
  CHECK(model.contents.extensions[0].support == "");
  CHECK(model.contents.extensions[1].support == "shown in its own colour");
}

TEST_CASE("strips, fans and every width of index", "[unit][gltf]") {
  std::vector<float> const square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  auto const triangles_of = [&](int mode, auto indices) {
    GltfWriter writer;
    auto& primitive = writer.add_mesh(square);
    primitive["mode"] = mode;
    primitive["indices"] = writer.add_accessor("SCALAR", 1, indices);
    return world_triangles(import_model(writer).scene);
  };
  auto const strip = triangles_of(5, std::vector<std::uint8_t>{0, 1, 2, 3});
  REQUIRE(strip.size() == 2);
  CHECK(is_same_triangle(strip[0], {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0));
  CHECK(is_same_triangle(strip[1], {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, 0));
  auto const fan = triangles_of(6, std::vector<std::uint16_t>{0, 1, 3, 2});
  REQUIRE(fan.size() == 2);
  CHECK(is_same_triangle(fan[0], {Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, 0));
  CHECK(is_same_triangle(fan[1], {Vec3(0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, 0));
  CHECK(triangles_of(4, std::vector<std::uint32_t>{0, 1, 2, 1, 3}).size() == 1);
}

TEST_CASE("quantised, strided and sparse positions", "[unit][gltf]") {
  SECTION("normalised") {
    GltfWriter writer;
    auto& primitive = writer.add_mesh(triangle_positions);
    primitive["attributes"]["POSITION"] =
        writer.add_accessor("VEC3", 3, std::vector<std::int8_t>{127, -128, 0, 0, 127, 0, 0, 0, -127}, true);
    auto const triangles = world_triangles(import_model(writer).scene);
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0] == Corners{Vec3(1, -1, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)});
  }
  SECTION("strided") {
    GltfWriter writer;
    auto& primitive = writer.add_mesh({9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0});
    int const accessor = primitive["attributes"]["POSITION"];
    writer.json["accessors"][std::size_t(accessor)]["count"] = 3;
    writer.json["accessors"][std::size_t(accessor)]["byteOffset"] = 4;
    writer.json["bufferViews"][0]["byteStride"] = 16;
    CHECK(world_triangles(import_model(writer).scene) == std::vector<Corners>{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
    writer.json["accessors"][std::size_t(accessor)]["byteOffset"] = 8;  // the last would end after the view
    CHECK_THROWS_WITH(import_model(writer), contains_text("/meshes/0/primitives/0/attributes/POSITION") &&
                                                contains_text("are out of range of buffer view 0 (48 bytes)"));
  }
  SECTION("sparse over zeros") {
    GltfWriter writer;
    auto& primitive = writer.add_mesh(triangle_positions);
    int const indices = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{1, 2, 7});
    int const values = writer.add_vec3({5, 0, 0, 0, 5, 0, 1, 1, 1});
    auto const view = [&](int accessor) { return writer.json["accessors"][std::size_t(accessor)]["bufferView"]; };
    writer.json["accessors"].push_back({{"componentType", 5126},
                                        {"count", 3},
                                        {"type", "VEC3"},
                                        {"sparse",
                                         {{"count", 3},
                                          {"indices", {{"bufferView", view(indices)}, {"componentType", 5123}}},
                                          {"values", {{"bufferView", view(values)}}}}}});
    primitive = writer.json["meshes"][0]["primitives"][0];
    writer.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = writer.json["accessors"].size() - 1;
    Model const model = import_model(writer);
    CHECK(world_triangles(model.scene) == std::vector<Corners>{{Vec3(0), Vec3(5, 0, 0), Vec3(0, 5, 0)}});
    CHECK_THAT(messages(model), contains_text("sparse: 1 indices are out of range (3)"));
  }
}

TEST_CASE("node transforms, mirrored winding, and instances", "[unit][gltf]") {
  GltfWriter writer;
  std::vector<float> positions;
  for (int i = 0; i < 10; ++i) {
    positions.insert(positions.end(), triangle_positions.begin(), triangle_positions.end());
  }
  writer.add_mesh(positions);
  writer.json["nodes"] = {{{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {0, 0, 3}}},
                          {{"children", {0, 2}}, {"rotation", {0, 0, 0.5, 0.5}}},  // not of unit length: 90 degrees
                          {{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 7, 0, 0, 1}}}};
  writer.json["scenes"] = {{{"nodes", {1}}}};
  Model const model = import_model(writer);
  CHECK(messages(model) == "");
  FlatScene const flat = flatten(model.scene.roots());
  CHECK(flat.instances.size() == 2);
  REQUIRE(flat.objects.size() == 2);
  CHECK(flat.objects[1].triangles.size() == 10);
  auto const triangles = world_triangles(model.scene);
  REQUIRE(triangles.size() == 20);
  CHECK(is_same_triangle(triangles[10], {Vec3(0, 7, 0), Vec3(0, 9, 0), Vec3(-2, 7, 0)}, 1e-12));
  CHECK(is_same_triangle(triangles[0], {Vec3(0, 0, 3), Vec3(0, -1, 3), Vec3(-1, 0, 3)}, 1e-12));
}

TEST_CASE("what is broken is named by its JSON pointer, and the rest is drawn", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  auto& broken = writer.add_mesh(triangle_positions);
  auto const expect = [&](char const* message) {
    Model const model = import_model(writer);
    CHECK(world_triangles(model.scene).size() == 1);
    CHECK_THAT(messages(model), contains_text(message));
  };
  SECTION("a reference out of range") {
    broken["attributes"]["POSITION"] = 17;
    expect("/meshes/1/primitives/0/attributes/POSITION: accessor 17 is out of range (2)");
  }
  SECTION("no number") {
    broken["indices"] = "zero";
    expect("/meshes/1/primitives/0/indices: expected a non-negative integer, found \"zero\"");
  }
  SECTION("indices out of range") {
    broken["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint8_t>{0, 1, 9});
    expect("/meshes/1/primitives/0/indices: 1 triangle left out: it has an index that is out of range (3)");
  }
  SECTION("a corner that is not a number") {
    broken["attributes"]["POSITION"] = writer.add_vec3({0, 0, 0, 1, NAN, 0, 0, 1, 0});
    expect("/meshes/1/primitives/0/attributes/POSITION: 1 triangle left out: it has a vertex that is not finite");
  }
  SECTION("an unknown mode") {
    broken["mode"] = 7;
    expect("/meshes/1/primitives/0/mode: glTF has no mode 7");
  }
  SECTION("lines of one end") {
    broken["mode"] = 3;
    broken["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint8_t>{0});
    expect("/meshes/1/primitives/0: it holds no line");
  }
  SECTION("a cycle") {
    writer.json["nodes"][1] = {{"children", {1}}};
    writer.json["scenes"] = {{{"nodes", {0, 1}}}};
    expect("/nodes/1: it occurs twice in the node tree");
  }
  SECTION("a node below several others, which is told once") {
    for (int i = 1; i < 4; ++i) writer.json["nodes"][i] = {{"children", {0}}};
    writer.json["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
    expect("/nodes/0: it occurs twice in the node tree");
    CHECK(import_model(writer).diagnostics.size() == 1);
  }
  SECTION("a required extension") {
    writer.json["nodes"].erase(1);
    writer.json["extensionsRequired"] = {"ACME_fur"};
    expect("the model needs ACME_fur, which is not supported");
  }
  SECTION("a file outside of its folder") {
    writer.json["buffers"] = {
        {{"byteLength", writer.buffer().size()}, {"uri", "data:;base64," + testing::encode_base64(writer.buffer())}},
        {{"byteLength", 12}, {"uri", "..%2Fsecret.bin"}}};
    writer.json["bufferViews"][1]["buffer"] = 1;
    expect("/buffers/1/uri: cannot use '../secret.bin': it contains '..'");
  }
}

TEST_CASE("invalid JSON is refused with its place", "[unit][gltf]") {
  TemporaryFolder const folder;
  auto const error_of = [&](std::string const& text) -> std::string {
    try {
      import_gltf(folder.write("m.gltf", text));
    } catch (SceneError const& error) {
      return error.what();
    }
    return "no error";
  };
  CHECK_THAT(error_of("{\n  \"asset\": }"), contains_text("m.gltf:2:12: error: not JSON"));
  CHECK_THAT(error_of("<!doctype html>\n<html>404</html>"),
             contains_text("m.gltf:1:1: error: this is an HTML document, not a glTF model: was a web page saved"));
  CHECK_THAT(error_of("version https://git-lfs.github.com/spec/v1\noid sha256:0\n"), contains_text("git lfs pull"));
  CHECK_THAT(error_of("Kaydara FBX Binary  \n"), contains_text("this is an FBX model") && contains_text("assimp"));
  CHECK_THAT(error_of("\x89PNG\r\n"),
             contains_text("m.gltf:1:1: error: this is a PNG picture, not a glTF model [E1001]"));
  CHECK_THAT(error_of(std::string(200000, '[')), contains_text("nests deeper than 256 levels"));
  CHECK_THAT(error_of("[]"), contains_text("expected a JSON object, found an array of 0"));
  CHECK_THAT(error_of(R"({"asset":{"version":"1.0"}})"), contains_text("this is glTF 1.0; only glTF 2 is supported"));
  CHECK_THAT(error_of(""), contains_text("the file is empty"));
  CHECK_THAT(error_of("glTF"), contains_text("the GLB header is cut off"));
}

TEST_CASE("a whole number may be written as 1.0", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["accessors"][0]["count"] = 3.0;
  writer.json["nodes"][0]["mesh"] = 0.0;
  CHECK(world_triangles(import_model(writer).scene).size() == 1);
}

TEST_CASE("an animation moves its node to where it is at a time", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{1, 3});
  int const linear = writer.add_vec3({0, 0, 0, 10, 0, 0});
  int const cubic = writer.add_vec3({0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 10, 0, 0, 0, 0, 0});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", linear}}}}}};
  auto const x_at = [&](double time) {
    ModelOptions options;
    options.time_seconds = time;
    return world_triangles(import_model(writer, options).scene).at(0)[0].x;
  };
  CHECK(x_at(0) == 0);
  CHECK(x_at(1.5) == Approx(2.5));
  CHECK(x_at(7) == 10);
  auto& sampler = writer.json["animations"][0]["samplers"][0];
  sampler["interpolation"] = "STEP";
  CHECK(x_at(2.9) == 0);
  sampler["interpolation"] = "CUBICSPLINE";
  sampler["output"] = cubic;
  // Appendix C.4 by hand, t = 1/2: 1/2 * 0 + 2 * 1/8 * 4 + 1/2 * 10
  CHECK(x_at(2) == Approx(6));
}

TEST_CASE("frames of an animation have the warnings of their model once", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  int const times = writer.add_accessor<float>("SCALAR", 1, {0, 1});
  int const places = writer.add_vec3({0, 0, 0, 4, 0, 0});
  // The first channel is warned of in each pose, the extension when the file is read.
  writer.json["animations"] = {{{"channels",
                                 {{{"sampler", 0}, {"target", {{"path", "pointer"}}}},
                                  {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  writer.json["extensionsRequired"] = {"EXT_unknown"};
  GltfAnimation animation(writer.text(), "model.gltf", {}), framed(writer.text(), "model.gltf", {});
  framed.frame_whole_animation();
  std::string const expected = messages(animation.pose(0.5));
  CHECK_THAT(expected, contains_text("EXT_unknown") && contains_text("/animations/0/channels"));
  CHECK(messages(framed.pose(0.5)) == expected);
}

TEST_CASE("what an animation moves as one, or not at all, says so", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 1});
  int const places = writer.add_vec3({0, 0, 0, 1, 0, 0});
  writer.json["nodes"] = {{{"name", "arm"}, {"mesh", 0}, {"children", {1, 2}}},
                          {{"name", "hand"}, {"mesh", 0}},
                          {{"name", "sleeve"}, {"mesh", 0}},
                          {{"name", "stand"}, {"mesh", 0}}};
  writer.json["scenes"] = {{{"nodes", {0, 3}}}};
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  auto const names = [&](std::optional<double> time) {
    ModelOptions options;
    options.time_seconds = time;
    std::string found;
    Scene const scene = import_model(writer, options).scene;
    for (char const* name : {"arm", "hand", "sleeve", "stand"}) {
      auto const* const shape = scene.shapes.find(name);
      REQUIRE(shape);
      auto const* const composite = dynamic_cast<Composite const*>(shape->get());
      REQUIRE(composite);
      if (composite->moves_as_one()) found += std::string(name) + " ";
    }
    return found;
  };
  CHECK(names(std::nullopt) == "");
  CHECK(names(0.5) == "hand sleeve stand ");
  auto& target = writer.json["animations"][0]["channels"][0]["target"];
  target["node"] = 0;
  CHECK(names(0.5) == "arm hand sleeve stand ");
  writer.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", writer.add_vec3({0, 0, 2, 0, 0, 0, 0, 0, 0})}}};
  target = {{"node", 2}, {"path", "weights"}};
  writer.json["animations"][0]["samplers"][0]["output"] = times;
  CHECK(names(0.5) == "hand stand ");
}

TEST_CASE("morph targets are added by their weights", "[unit][gltf]") {
  GltfWriter writer;
  auto& primitive = writer.add_mesh(triangle_positions);
  int const target = writer.add_vec3({0, 0, 2, 0, 0, 0, 0, 0, 0});
  writer.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  (void)primitive;
  writer.json["meshes"][0]["weights"] = {0.5};
  CHECK(world_triangles(import_model(writer).scene).at(0)[0] == Vec3(0, 0, 1));
  writer.json["nodes"][0]["weights"] = {1.5};
  CHECK(world_triangles(import_model(writer).scene).at(0)[0] == Vec3(0, 0, 3));
  writer.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1};  // as well
  CHECK(world_triangles(import_model(writer).scene).at(0)[0] == Vec3(5, 0, 3));
}

TEST_CASE("morph targets move texture coordinates and colours, too", "[unit][gltf]") {
  GltfWriter writer;
  auto& attributes = writer.add_mesh(triangle_positions)["attributes"];
  attributes["TEXCOORD_0"] = writer.add_accessor("VEC2", 2, std::vector<float>{0, 0, 1, 0, 0, 1});
  attributes["TEXCOORD_1"] = writer.add_accessor("VEC2", 2, std::vector<float>{0, 0, 1, 0, 0, 1});
  attributes["COLOR_0"] = writer.add_accessor("VEC4", 4, std::vector<float>{0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 0.5f});
  nlohmann::json first, second;
  first["TEXCOORD_1"] = writer.add_accessor("VEC2", 2, std::vector<float>{0, 0, 2, 4, 0, 0});
  first["COLOR_0"] = writer.add_vec3({0.5f, 0, -1, 1, 0, 0, 0, 0, -0.5f});
  second["COLOR_0"] =
      writer.add_accessor("VEC4", 4, std::vector<std::int8_t>{127, 0, 0, -127, 0, 0, 0, 0, 0, 0, 0, 0}, true);
  second["TEXCOORD_2"] = first["TEXCOORD_1"];  // of no set that there is
  writer.json["meshes"][0]["primitives"][0]["targets"] = {first, second};
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const weights = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 0, 1, 0.5f});
  nlohmann::json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  writer.json["animations"] = {{{"samplers", {{{"input", times}, {"output", weights}}}}, {"channels", {channel}}}};

  Model const at_rest = import_model(writer);
  CHECK(messages(at_rest) == "");
  CHECK(geometry_of(at_rest.scene).colors[2] == Float4{0, 0, 1, 0.5f});
  ModelOptions options;
  options.time_seconds = 1;  // half of the way: weights of 0.5 and 0.25
  Model const model = import_model(writer, options);
  CHECK(messages(model) == "");
  MeshGeometry const& geometry = geometry_of(model.scene);
  CHECK(geometry.texcoords == std::vector<std::vector<Float2>>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {2, 2}, {0, 1}}});
  CHECK(geometry.colors == std::vector<Float4>{{0.5f, 0, 0, 0.75f}, {1, 1, 1, 1}, {0, 0, 0.75f, 0.5f}});

  writer.json["meshes"][0]["primitives"][0]["targets"][0]["COLOR_0"] = times;
  writer.json["meshes"][0]["primitives"][0]["targets"][1]["COLOR_0"] = attributes["TEXCOORD_0"];
  Model const faulty = import_model(writer, options);
  CHECK(messages(faulty).find("/targets/0/COLOR_0: 2 elements for 3 positions") != std::string::npos);
  CHECK(messages(faulty).find("/targets/1/COLOR_0: 2 components where 3 or 4 are expected") != std::string::npos);
  CHECK(geometry_of(faulty.scene).colors[1] == Float4{1, 1, 1, 1});
}

TEST_CASE("tangents turn with what is morphed, and with joints", "[unit][gltf]") {
  GltfWriter morphed = triangle_with_tangents();
  CHECK(are_near(tangents_of(import_model(morphed).scene), {1, 0, 0, -1}));
  int const turn = morphed.add_vec3({-1, 2, 0, -1, 2, 0, -1, 2, 0});  // to twice +y
  morphed.json["meshes"][0]["primitives"][0]["targets"] = {{{"TANGENT", turn}}};
  morphed.json["meshes"][0]["weights"] = {1};
  CHECK(are_near(tangents_of(import_model(morphed).scene), {0, 1, 0, -1}));

  float const half = float(std::sqrt(0.5));
  GltfWriter turned = triangle_with_tangents();
  bind_to_joint(turned, {{"rotation", {0, 0, half, half}}, {"scale", {3, 3, 3}}});  // x becomes y
  CHECK(are_near(tangents_of(import_model(turned).scene), {0, 1, 0, -1}));

  // A mirror turns the triangle over, and its normals with it; from there, the bitangents are where they were.
  GltfWriter mirrored = triangle_with_tangents();
  bind_to_joint(mirrored, {{"scale", {-1, 1, 1}}});
  CHECK(are_near(tangents_of(import_model(mirrored).scene), {-1, 0, 0, -1}));
}

TEST_CASE("what is invisible is not drawn, but its cameras are there and its joints move", "[unit][gltf]") {
  for (bool const is_visible : {true, false}) {
    INFO(is_visible);
    GltfWriter writer;
    writer.add_mesh(triangle_positions);
    bind_to_joint(writer, {{"translation", {0, 0, 2}}});
    writer.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 1}}}}};
    // Above the joint: a node with a camera, and beside it one with another triangle.
    nlohmann::json hidden = {{"translation", {0, 0, 3}}, {"children", {1, 3}}, {"camera", 0}};
    hidden["extensions"]["KHR_node_visibility"]["visible"] = is_visible;
    writer.json["nodes"].push_back(hidden);
    writer.json["nodes"].push_back({{"mesh", 1}});
    writer.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
    Model const model = import_model(writer);
    CHECK(messages(model) == "");
    auto const triangles = world_triangles(model.scene);
    REQUIRE(triangles.size() == (is_visible ? 2 : 1));
    CHECK(std::count(triangles.begin(), triangles.end(), Corners{Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(0, 1, 5)}) == 1);
    REQUIRE(model.scene.has_own_cameras);
    CHECK(model.scene.cameras.front().generate_ray(0, 0, {8, 8}).origin == Vec3(0, 0, 3));
  }
}

TEST_CASE("a skin moves vertices by their joints, and the node's own place does not count", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  int const joints = writer.add_accessor("VEC4", 4, std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
  int const weights = writer.add_accessor("VEC4", 4, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
  auto& attributes = writer.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = joints;
  attributes["WEIGHTS_0"] = weights;
  writer.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                          {{"translation", {0, 0, 4}}, {"children", {2}}},
                          {{"translation", {0, 0, 2}}}};
  writer.json["skins"] = {{{"joints", {1, 2}}}};
  CHECK(world_triangles(import_model(writer).scene) ==
        std::vector<Corners>{{Vec3(0, 0, 4), Vec3(1, 0, 6), Vec3(0, 1, 5)}});
}

TEST_CASE("a mirror above a skinned mesh turns its triangles over, as its vertices' joints cannot", "[unit][gltf]") {
  // Under one armature, as programs write it: the mesh's node, which moves nothing, and the joint.
  auto const armature = [](nlohmann::json scale) {
    GltfWriter writer = triangle_with_tangents();
    auto& primitive = writer.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = writer.add_accessor("VEC2", 2, std::vector<float>{0, 1, 1, 1, 0, 0});
    primitive["targets"] = {{{"POSITION", writer.add_vec3({0, 0, 5, 0, 0, 5, 0, 0, 5})}}};
    writer.json["meshes"][0]["weights"] = {1};
    bind_to_joint(writer, {{"name", "joint"}});
    writer.json["nodes"].push_back({{"children", {0, 1}}, {"scale", std::move(scale)}});
    return writer;
  };
  Scene const plain = import_model(armature({1, 1, 1})).scene;
  CHECK(world_triangles(plain) == std::vector<Corners>{{Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(0, 1, 5)}});
  CHECK(are_near(tangents_of(plain), {1, 0, 0, -1}));

  Scene const mirrored = import_model(armature({-1, 1, 1})).scene;
  REQUIRE(world_triangles(mirrored).size() == 1);
  CHECK(is_same_triangle(world_triangles(mirrored)[0], {Vec3(0, 0, 5), Vec3(0, 1, 5), Vec3(-1, 0, 5)}, 1e-12));
  MeshGeometry const& geometry = geometry_of(mirrored);
  CHECK(geometry.normals == std::vector<Float3>(3, {0, 0, 1}));  // as before: on the side that is seen
  CHECK(are_near(geometry.tangents, {-1, 0, 0, 1}));             // bitangents stay -y
  CHECK(geometry.texcoords == geometry_of(plain).texcoords);     // each vertex keeps its own
  CHECK(geometry.positions[1] == Float3{-1, 0, 5});

  // Two mirrors are a turn.
  Scene const turned = import_model(armature({-1, -1, 1})).scene;
  CHECK(is_same_triangle(world_triangles(turned).at(0), {Vec3(0, 0, 5), Vec3(-1, 0, 5), Vec3(0, -1, 5)}, 1e-12));
  CHECK(are_near(tangents_of(turned), {-1, 0, 0, -1}));
}

TEST_CASE("instances of a skinned mesh are named, and one is drawn", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  bind_to_joint(writer, {{"translation", {0, 0, 2}}});
  writer.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      writer.add_vec3({5, 0, 0, 0, 7, 0});
  Model const model = import_model(writer);
  CHECK_THAT(messages(model), contains_text("/nodes/0/extensions/EXT_mesh_gpu_instancing: "));
  CHECK(world_triangles(model.scene) == std::vector<Corners>{{Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(0, 1, 2)}});
}
