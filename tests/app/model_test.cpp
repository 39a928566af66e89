#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"

using lichtraum::testing::GltfWriter;

namespace {

/// A white square of 2 x 2 in the plane z = 0, seen by two cameras: "near" sees nothing else, "far" also what is
/// around.
GltfWriter square() {
  GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0})["material"] = 0;
  writer.json["materials"] = {{{"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}},
                               {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}}}}};
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"aspectRatio", 1}, {"znear", 1}}}}};
  writer.json["nodes"].push_back({{"name", "near"}, {"camera", 0}, {"translation", {0, 0, 1}}});
  writer.json["nodes"].push_back({{"name", "far"}, {"camera", 0}, {"translation", {0, 0, 10}}});
  return writer;
}

}  // namespace

TEST_CASE("a model is drawn, and its picture is stored in sRGB", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  auto const picture = [&](std::string const& words) {
    auto const result = lichtraum.render("square.glb --size 16x16 " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return decode(lichtraum.folder.read("square.png"));
  };
  // Half the light is 188 of 255 in sRGB (IEC 61966-2-1), 128 without.
  auto const near = picture("");
  CHECK(near.at(0, 0, 0) == 188);
  CHECK(near.at(8, 8, 1) == 188);
  CHECK(picture("--transfer linear").at(8, 8, 0) == 128);
  auto const far = picture("--camera far");
  CHECK(far.at(0, 0, 0) == 0);
  CHECK(far.at(8, 8, 0) == 188);
  CHECK(picture("--camera 1").values == far.values);
  CHECK(lichtraum.render("square.glb --camera 2").exit_code == 64);
  CHECK(lichtraum.render("square.glb --scene nowhere").exit_code == 64);
  CHECK(lichtraum.render("square.glb --time noon").exit_code == 64);
}

TEST_CASE("a model in a scene, several times and in its material", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.gltf", square().text());
  lichtraum.folder.write("two.sdf",
                         "define material red 1 0 0 0 0 0 0 0 0 1\n"
                         "define light ambient all 1 1 1\n"
                         "define camera eye 90\n"
                         "define shape mesh left square.gltf\n"
                         "define shape mesh right square.gltf red\n"
                         "transform left translate -1.5 0 -4\n"
                         "transform right translate 1.5 0 -4\n"
                         "render eye two.png 32 32\n");
  auto const result = lichtraum.render("two.sdf");
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  auto const image = decode(lichtraum.folder.read("two.png"));
  CHECK(image.at(10, 16, 0) == 128);
  CHECK(image.at(10, 16, 2) == 128);
  CHECK(image.at(22, 16, 0) == 255);
  CHECK(image.at(22, 16, 2) == 0);
}

TEST_CASE("check and info read models", "[app][gltf]") {
  Lichtraum const lichtraum;
  auto writer = square();
  lichtraum.folder.write("good.gltf", writer.text());
  writer.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 7}}}});
  lichtraum.folder.write("flawed.gltf", writer.text());
  lichtraum.folder.write("broken.gltf", "{");
  CHECK(lichtraum("check good.gltf").out == "good.gltf: good\n");
  auto const flawed = lichtraum("check flawed.gltf");
  CHECK(flawed.exit_code == 0);
  CHECK_THAT(flawed.err, contains_text("/meshes/0/primitives/1/attributes/POSITION: accessor 7 is out of range (1)"));
  CHECK(lichtraum("check broken.gltf").exit_code == 65);
  CHECK_THAT(lichtraum("info good.gltf").out, contains_text("  mesh triangles           2               2\n"));
  CHECK(nlohmann::json::parse(lichtraum("info good.gltf --json").out).is_object());
}
