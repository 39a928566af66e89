#include <filesystem>
#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "lichtraum/device.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

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

TEST_CASE("an up vector of no direction is refused before the model is lit from above", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  for (char const* const command : {"render", "check", "preview", "job plan -o shared"}) {
    INFO(command);
    auto const result = lichtraum(std::string(command) + " square.glb --device reference --up 0,0,0");
    CHECK(result.exit_code == 64);
    CHECK_THAT(result.err, contains_text("--up 0,0,0: it has no direction"));
  }
  auto const picture = [&](std::string const& up) {
    auto const result = lichtraum.render("square.glb -q --size 16x16 --orbit 35,20 -o up.png --up " + up);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return decode(lichtraum.folder.read("up.png")).values;
  };
  auto const sideways = picture("1,0,0");
  CHECK(picture("1e300,0,0") == sideways);
  CHECK(picture("1e-300,0,0") == sideways);
}

TEST_CASE("a picture of nothing but hidden backs is warned about", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  for (std::string const command : {"check", "render"}) {
    auto const said = [&](std::string const& words) {
      return lichtraum(command + " square.glb --device reference --integrator path --samples 1 --denoise builtin " +
                       "--size 16x16 " + words)
          .err;
    };
    CHECK_THAT(said("--orbit 180,0"), contains_text("meets the backs of surfaces only, which glTF hides [W0816]") &&
                                          contains_text("--both-sides shows them"));
    CHECK(said("--orbit 180,0 --both-sides").find("W0816") == std::string::npos);
    CHECK(said("--orbit 0,0").find("W0816") == std::string::npos);
  }
}

TEST_CASE("models are drawn by paths unless asked otherwise, or by the reference tracer", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  auto const figures = [&](std::string const& words) {
    auto const result = lichtraum("render square.glb -q --json --size 16x16 " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    auto const picture = nlohmann::json::parse(result.out)["scenes"][0]["pictures"][0];
    return std::tuple(std::string(picture["integrator"]), int(picture["samples"]), int(picture["depth"]),
                      picture["denoiser"].is_null());
  };
  CHECK(figures("--device reference") == std::tuple("whitted", 1, 5, true));
  CHECK(figures("--device reference --integrator path --samples 2 --depth 2") == std::tuple("path", 2, 2, false));
  if (lichtraum("devices --json").out.find("\"cpu\"") == std::string::npos) SKIP_TEST("no OpenCL device");
  CHECK(figures("") == std::tuple("path", 16, 64, false));
  CHECK(figures("--denoise off --samples 3") == std::tuple("path", 3, 64, true));
  CHECK(figures("--integrator whitted") == std::tuple("whitted", 1, 5, true));

  REQUIRE(lichtraum("render square.glb --size 16x16 --integrator path").exit_code == 0);
  auto const by_name = lichtraum.folder.read("square.png");
  REQUIRE(lichtraum("render square.glb --size 16x16").exit_code == 0);
  CHECK(lichtraum.folder.read("square.png") == by_name);
  // Its camera is close to it; from the side its picture shows the studio's grey, from light at the top to dark.
  REQUIRE(lichtraum("render square.glb --size 16x16 --orbit 35,20").exit_code == 0);
  auto const beside = decode(lichtraum.folder.read("square.png"));
  CHECK(beside.at(0, 0, 0) > beside.at(0, 15, 0) + 20);
  CHECK(beside.at(0, 15, 0) > 80);

  // Through a lens: out of focus the edge is soft.
  auto const soft_edge = [&](std::string const& words) {
    auto const result =
        lichtraum("render square.glb --size 32x32 --camera far --background 0,0,0 --denoise builtin " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("sees nothing") == std::string::npos);
    auto const image = decode(lichtraum.folder.read("square.png"));
    int between = 0;
    for (int x = 0; x < 32; ++x) between += image.at(x, 16, 0) > 20 && image.at(x, 16, 0) < 0.8f * image.at(16, 16, 0);
    return between;
  };
  CHECK(soft_edge("--aperture 2") <= 2);
  CHECK(soft_edge("--aperture 2 --focus 4") > 4);
  CHECK_THAT(lichtraum("render square.glb --focus 4").err, contains_text("without a lens everything is sharp"));

  auto const preview = [&](std::string const& words) {
    auto const result = lichtraum("preview square.glb --size 12x6 --orbit 35,20 " + words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return result.out;
  };
  CHECK(preview("") == preview("--samples 16"));
  CHECK(preview("") != preview("--device reference"));
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
  CHECK(lichtraum("check good.gltf").out == "good.gltf: good\n  would write good.png, 720x720, camera 'near'\n");
  auto const flawed = lichtraum("check flawed.gltf");
  CHECK(flawed.exit_code == 0);
  CHECK_THAT(flawed.err, contains_text("/meshes/0/primitives/1/attributes/POSITION: accessor 7 is out of range (1)"));
  CHECK(lichtraum("check broken.gltf").exit_code == 65);
  CHECK_THAT(lichtraum("info good.gltf").out, contains_text("  mesh triangles           2               2\n"));
  CHECK(nlohmann::json::parse(lichtraum("info good.gltf --json").out).is_object());
}

TEST_CASE("info tells textures, animations, extensions and scenes of a model", "[app][gltf][info]") {
  Lichtraum const lichtraum;
  auto writer = square();
  lichtraum.folder.write("square.glb", writer.glb());
  REQUIRE(lichtraum.render("square.glb --size 4x2 -o dot.png").exit_code == 0);
  std::string const png = lichtraum::testing::encode_base64(lichtraum.folder.read("dot.png"));
  writer.json["images"] = {{{"name", "dot"}, {"uri", "data:image/png;base64," + png}}};
  writer.json["textures"] = {{{"source", 0}}};
  writer.json["materials"][0]["emissiveTexture"] = {{"index", 0}};
  writer.json["scenes"] = {{{"name", "all"}, {"nodes", {0, 1, 2}}}};
  int const times = writer.add_accessor<float>("SCALAR", 1, {0, 1.5f});
  writer.json["animations"] = {
      {{"name", "spin"}, {"samplers", {{{"input", times}, {"output", times}}}}, {"channels", nlohmann::json::array()}}};
  writer.json["extensionsUsed"] = {"KHR_materials_unlit", "VENDOR_magic"};
  writer.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "beach"}}, {{"name", "street"}}};
  lichtraum.folder.write("all.gltf", writer.text());
  auto const text = lichtraum("info all.gltf").out;
  CHECK_THAT(text, contains_text("  texture         dot, 4x2, 3.2e-05 MB\n") &&
                       contains_text("  animation       0, spin, 1.5 s\n") &&
                       contains_text("  scene           0, all\n") &&
                       contains_text("  variant         0, beach\n  variant         1, street\n") &&
                       contains_text("  extension       KHR_materials_unlit: shown in its own colour\n") &&
                       contains_text("  extension       VENDOR_magic: not supported\n"));
  auto const json = nlohmann::json::parse(lichtraum("info all.gltf --json").out);
  CHECK(json["textures"] == nlohmann::json::parse(R"([{"name":"dot","size":[4,2],"bytes":32}])"));
  CHECK(json["model"]["animations"] == nlohmann::json::parse(R"([{"name":"spin","seconds":1.5}])"));
  CHECK(json["model"]["variants"] == nlohmann::json::parse(R"(["beach","street"])"));
  auto const unknown = lichtraum("info all.gltf --variant moon");
  CHECK(unknown.exit_code == 64);
  CHECK_THAT(unknown.err, contains_text("there is no variant 'moon' in the model; it has: 0 'beach', 1 'street'"));
  CHECK(lichtraum("info all.gltf --variant street").exit_code == 0);
  CHECK(json["model"]["scenes"] == nlohmann::json::parse(R"(["all"])"));
  CHECK(json["model"]["extensions"][1]["name"] == "VENDOR_magic");
  CHECK(json["model"]["extensions"][1]["supported"] == false);
  CHECK(json["shapes"]["drawn"]["mesh_triangles"] == 2);
}

TEST_CASE("OBJ and PLY models are drawn, checked, described, and shapes of scenes", "[app][obj][ply]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.mtl", "newmtl paint\nKd 0 0 0\nKe 0.5 0.5 0.5\n");
  lichtraum.folder.write("square.obj",
                         "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl paint\nf 1 2 3 4\n");
  lichtraum.folder.write(
      "square.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "-1 -1 0 1 -1 0 1 1 0 -1 1 0 4 0 1 2 3\n");
  lichtraum.folder.write("two.sdf",
                         "define material red 1 0 0 0 0 0 0 0 0 1\n"
                         "define light ambient all 1 1 1\n"
                         "define camera eye 90\n"
                         "define shape mesh left square.obj\n"
                         "define shape mesh right square.ply red\n"
                         "transform left translate -1.5 0 -4\n"
                         "transform right translate 1.5 0 -4\n"
                         "render eye two.png 32 32\n");
  for (char const* name : {"square.obj", "square.ply"}) {
    auto const result = lichtraum.render(std::string(name) + " --size 32x24 -o one.png");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(decode(lichtraum.folder.read("one.png")).at(16, 12, 0) > 100);
    CHECK(lichtraum(std::string("check ") + name).out.rfind(std::string(name) + ": good\n", 0) == 0);
    CHECK_THAT(lichtraum(std::string("info ") + name).out,
               contains_text("  mesh triangles           2               2\n"));
  }
  REQUIRE(lichtraum.render("two.sdf").exit_code == 0);
  auto const image = decode(lichtraum.folder.read("two.png"));
  CHECK(image.at(10, 16, 1) == 128);
  CHECK(image.at(22, 16, 0) == 255);
  CHECK(image.at(22, 16, 1) == 0);
  lichtraum.folder.write("flawed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 x\n");
  auto const flawed = lichtraum("check flawed.obj");
  CHECK(flawed.exit_code == 0);
  CHECK_THAT(flawed.err, contains_text("flawed.obj:5:7: warning: expected vertex/texture/normal, found 'x'"));
  lichtraum.folder.write("empty.ply", "ply\n");
  CHECK(lichtraum("check empty.ply").exit_code == 65);
}

TEST_CASE("a PLY file without faces is drawn as points, as large as asked", "[app][ply][points]") {
  Lichtraum const lichtraum;
  std::string const start =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  lichtraum.folder.write("two.ply", start + "-1 0 0 255 0 0\n1 0 0 0 0 255\n");
  CHECK(lichtraum("check two.ply").exit_code == 0);
  CHECK_THAT(lichtraum("info two.ply").out, contains_text("points") && contains_text("-1.01 -0.01 -0.01 to 1.01"));
  auto const json = nlohmann::json::parse(lichtraum("info two.ply --json --point-size 500").out);
  CHECK(json["shapes"]["drawn"]["points"] == 2);
  CHECK(json["bounds"]["max"][0] == 1.5);
  CHECK(lichtraum("render two.ply --point-size 500 --size 64x32 --orbit 0,0 --denoise off -o two.ppm").exit_code == 0);
  CHECK(std::filesystem::exists(lichtraum.folder / "two.ppm"));
  for (char const* size : {"0", "-1", "1001", "nan", "big"}) {
    auto const refused = lichtraum(std::string("render two.ply -o no.png --point-size ") + size);
    CHECK(refused.exit_code == 64);
    CHECK_THAT(refused.err, contains_text("--point-size: expected thousandths of the model's diagonal"));
    CHECK_FALSE(std::filesystem::exists(lichtraum.folder / "no.png"));
  }
}

TEST_CASE("the camera sees both sides of OBJ and PLY, and of glTF's surfaces as they say or as asked", "[app][gltf]") {
  Lichtraum const lichtraum;
  std::string const header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  std::string const faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  lichtraum.folder.write("colored.ply", header + "property float red\nproperty float green\nproperty float blue\n" +
                                            faces + "-9 -9 0 1 0 0 9 -9 0 1 0 0 0 9 0 1 0 0 3 0 1 2\n");
  lichtraum.folder.write("colored.obj", "v -9 -9 0 1 0 0\nv 9 -9 0 1 0 0\nv 0 9 0 1 0 0\nf 1 2 3\n");
  GltfWriter writer;
  writer.add_mesh({-9, -9, 0, 9, -9, 0, 0, 9, 0})["material"] = 0;
  writer.add_mesh({-9, -9, 0, 9, -9, 0, 0, 9, 0});
  writer.json["materials"] = {{{"name", "plain"}}};
  writer.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  lichtraum.folder.write("single.gltf", writer.text());
  writer.json["materials"][0]["doubleSided"] = true;
  lichtraum.folder.write("double.gltf", writer.text());
  auto const is_seen = [&](std::string const& words) {
    auto const result =
        lichtraum.render(words + " --size 8x8 --integrator path --look-at 0,0,0 --background 0,1,0 -o a.png");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    auto const image = decode(lichtraum.folder.read("a.png"));
    return image.at(4, 4, 0) > 0.25f * image.at(4, 4, 1);  // the background is green
  };
  std::string const behind = " --eye 0,0,-5", before = " --eye 0,0,5";
  for (char const* const name : {"colored.ply", "colored.obj", "double.gltf", "single.gltf --both-sides",
                                 "single.gltf --scene 1 --both-sides"}) {
    INFO(name);
    CHECK(is_seen(name + behind));
  }
  for (char const* const name : {"single.gltf", "single.gltf --scene 1"}) {
    INFO(name);
    CHECK(is_seen(name + before));
    CHECK(!is_seen(name + behind));
  }
}

TEST_CASE("a model whose up is elsewhere is lit and stands as one that is upright", "[app][obj][ground]") {
  Lichtraum const lichtraum;
  if (lichtraum("devices --json").out.find("\"cpu\"") == std::string::npos) SKIP_TEST("no OpenCL device");
  lichtraum.folder.write("y.obj", "v -1 0 1\nv 1 0 1\nv 0 0 -1\nv 0.3 2 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  lichtraum.folder.write("z.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0.3 0 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  auto const picture = [&](std::string const& words) {
    auto const result = lichtraum("render " + words + " --size 48x36 --denoise off -o picture.png");
    INFO(words << ": " << result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("no effect") == std::string::npos);
    return decode(lichtraum.folder.read("picture.png"));
  };
  auto const difference = [](auto const& a, auto const& b) {
    double sum = 0;
    for (int y = 0; y < 36; ++y) {
      for (int x = 0; x < 48; ++x) {
        for (int c = 0; c < 3; ++c) sum += std::abs(a.at(x, y, c) - b.at(x, y, c));
      }
    }
    return sum / (36 * 48 * 3);
  };
  for (std::string const options : {"", " --ground", " --ground=glossy", " --integrator whitted"}) {
    INFO(options);
    auto const upright = picture("y.obj" + options);
    CHECK(difference(picture("z.obj --up 0,0,1" + options), upright) < 1);
    CHECK(difference(picture("z.obj" + options), upright) > 5);
  }
  CHECK(difference(picture("y.obj --ground"), picture("y.obj")) > 1);
  // So it is where machines share the work.
  REQUIRE(lichtraum("job plan z.obj --up 0,0,1 --ground --size 48x36 --denoise off -o plan").exit_code == 0);
  REQUIRE(lichtraum("job work plan").exit_code == 0);
  REQUIRE(lichtraum("job merge plan -o merged.png").exit_code == 0);
  CHECK(lichtraum.folder.read("merged.png") ==
        (picture("z.obj --up 0,0,1 --ground"), lichtraum.folder.read("picture.png")));
}

TEST_CASE("an STL model is drawn like the same triangles in a PLY file, with +z up", "[app][stl]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1 0 0 0 1 0 0 0 1 3 0 1 3 3 1 2 3 3 2 0 3\n");
  auto const facet = [](std::string const& a, std::string const& b) {
    return "facet normal 0 0 0 outer loop vertex " + a + " vertex " + b + " vertex 0 0 1 endloop endfacet\n";
  };
  std::string const solid =
      "solid tent\n" + facet("0 0 0", "1 0 0") + facet("1 0 0", "0 1 0") + facet("0 1 0", "0 0 0");
  lichtraum.folder.write("b.stl", solid + "endsolid tent\n");
  auto const drawn = [&](std::string const& arguments) {
    auto const result = lichtraum.render(arguments + " --size 32x24 -o drawn.ppm");
    INFO(arguments << result.err);
    REQUIRE(result.exit_code == 0);
    return lichtraum.folder.read("drawn.ppm");
  };
  for (std::string const how : {"", " --ground", " --orbit 20,30", " --eye 3,-4,2", " --integrator whitted"}) {
    INFO(how);
    std::string const upright = drawn("b.stl" + how);
    CHECK(upright == drawn("a.ply --up 0,0,1" + how));
    CHECK(upright != drawn("a.ply" + how));
    CHECK(drawn("a.ply" + how) == drawn("b.stl --up 0,1,0" + how));
  }
  lichtraum.folder.write("scene.sdf",
                         "define shape mesh tent b.stl\ndefine camera eye 60\ntransform eye translate 0.3 0.3 3\n"
                         "define light diffuse sun 1 5 3 1 1 1\n");
  std::string const in_scene = drawn("scene.sdf --orbit 20,30");  // where +y is up as ever
  CHECK(drawn("scene.sdf --orbit 20,30 --up 0,1,0") == in_scene);
  CHECK(drawn("scene.sdf --orbit 20,30 --up 0,0,1") != in_scene);
  CHECK(lichtraum("check b.stl").out.rfind("b.stl: good\n", 0) == 0);
  CHECK_THAT(lichtraum("info b.stl").out, contains_text("  mesh triangles           3               3\n"));
  CHECK(lichtraum.render("b.stl --root tent -o c.ppm").exit_code == 0);
  lichtraum.folder.write("cut.stl", solid + "facet normal 0 0 1\nouter loop\n");
  auto const cut = lichtraum("check cut.stl");
  CHECK(cut.exit_code == 0);
  CHECK_THAT(cut.err, contains_text("cut.stl:6:11: warning: the file ends where 'vertex' is missing"));
  lichtraum.folder.write("none.stl", "solid\nendsolid\n");
  CHECK(lichtraum.render("none.stl").exit_code == 65);
  CHECK(!std::filesystem::exists(lichtraum.folder / "none.png"));
}

TEST_CASE("models in formats that are not read are refused with what converts them", "[app]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("robot.fbx", "; FBX 7.3.0 project file\n; facet\nObjects: {\n}\n");
  for (std::string const command : {"render", "check", "info"}) {
    auto const result = lichtraum(command + " robot.fbx");
    CHECK(result.exit_code == 65);
    CHECK(result.err ==
          "robot.fbx:1: error: this is an FBX model, which lichtraum does not read [E0204]\n"
          "  hint: make a .glb of it: assimp export in.fbx out.glb -fglb2\n");
  }
  CHECK(!std::filesystem::exists(lichtraum.folder / "robot.png"));
  CHECK(lichtraum("check missing.fbx").exit_code == 66);
}

TEST_CASE("what only scenes have, or chance, is said to have no effect on models", "[app][gltf]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  auto const said = [&](std::string const& words) {
    auto const result = lichtraum("check square.glb --device reference --camera far " + words);
    INFO(result.err);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  for (std::string const option : {"--strict", "--keep-going", "--rotation left", "--transform-order local",
                                   "--material-extras ior", "--both-sides", "--seed 7"}) {
    std::string const name = option.substr(0, option.find(' '));
    CHECK_THAT(said(option), contains_text("warning: " + name + " has no effect on 'square.png'"));
  }
  for (char const* const words : {"--rotation right", "--seed 7 --samples 16", "--seed 7 --aperture 1 --samples 1",
                                  "--seed 7 --integrator path", "--both-sides --integrator path"}) {
    INFO(words);
    CHECK(said(words).find("no effect") == std::string::npos);
  }
}

TEST_CASE("models come through standard input, as files do", "[app][stdin]") {
  Lichtraum const lichtraum;
  std::string const obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
  std::string const ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2\n";
  std::string const stl =
      "solid a\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid a\n";
  struct Input {
    std::string format;
    std::string bytes;
    bool is_recognised;
  };
  for (Input const& input : {Input{"glb", square().glb(), true},
                             {"gltf", square().text(), false},
                             {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true},
                             {"ply", ply, true},
                             {"stl", stl, true},
                             {"sdf", std::string(ball_scene), true}}) {
    INFO(input.format);
    std::string const file = "model." + input.format;
    lichtraum.folder.write(file, input.bytes);
    std::string const words = "render -q --size 16x12 -o ";
    auto const by_file = lichtraum(words + "file.ppm " + file);
    INFO(by_file.err);
    REQUIRE(by_file.exit_code == 0);
    REQUIRE(lichtraum(words + "piped.ppm - --format-in " + input.format, input.bytes).exit_code == 0);
    CHECK(lichtraum.folder.read("piped.ppm") == lichtraum.folder.read("file.ppm"));
    CHECK(lichtraum("check - --format-in " + input.format, input.bytes).out.rfind("-: good\n", 0) == 0);
    CHECK(lichtraum("check -", input.bytes).exit_code == (input.is_recognised ? 0 : 65));
    std::string const of_file = lichtraum("info " + file).out;
    std::string const of_pipe = lichtraum("info - --format-in " + input.format, input.bytes).out;
    CHECK(of_pipe.substr(of_pipe.find('\n')) == of_file.substr(of_file.find('\n')));
    CHECK(lichtraum("preview - --size 9x5 --graphics blocks --format-in " + input.format, input.bytes).out ==
          lichtraum("preview --size 9x5 --graphics blocks " + file).out);
  }
  std::string binary_stl(84 + 50, '\0');
  binary_stl[80] = 1;
  CHECK(lichtraum("check -", binary_stl).err.find("eSDF") == std::string::npos);
  CHECK(lichtraum("check - --format-in obj", ply).exit_code == 65);

  // There is no folder for the files that a model names, whatever lies in the current one.
  lichtraum.folder.write("a.mtl", "newmtl m\n");
  auto const alone = lichtraum("check - --format-in obj", obj);
  CHECK(alone.exit_code == 0);
  CHECK_THAT(alone.err, contains_text("<stdin>.obj:1:8: warning: cannot use 'a.mtl': the model comes from no file"));
  auto model = nlohmann::json::parse(square().text());
  model["buffers"][0]["uri"] = "buffer.bin";
  lichtraum.folder.write("buffer.bin", std::string(std::size_t(model["buffers"][0]["byteLength"]), '\0'));
  auto const external = lichtraum("render - --format-in gltf -o external.png", model.dump());
  CHECK(external.exit_code == 65);
  CHECK_THAT(external.err, contains_text("/buffers/0/uri: cannot use 'buffer.bin': the model comes from no file"));
  CHECK(!std::filesystem::exists(lichtraum.folder / "external.png"));

  auto const refused = [&](std::string const& words, std::string const& why) {
    auto const result = lichtraum(words, ply);
    CHECK(result.exit_code == 64);
    CHECK_THAT(result.err, contains_text(why));
  };
  refused("render - --format-in fbx", "expected sdf, gltf, glb, obj, ply or stl, not 'fbx'");
  refused("render model.ply --format-in ply", "--format-in is for standard input");
  refused("check model.ply --format-in ply", "--format-in is for standard input");
  refused("info model.ply --format-in ply", "--format-in is for standard input");
  refused("preview model.ply --format-in ply", "--format-in is for standard input");
  refused("render - --frames 0..1 -o %d.png", "--frames is for one animated glTF model");
}

TEST_CASE("programs compiled with lichtraum draw the same bytes as their source", "[app][gltf]") {
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  Lichtraum const lichtraum;
  lichtraum.folder.write("square.glb", square().glb());
  lichtraum.folder.write("ball.sdf", ball_scene);
  auto const picture = [&](std::string const& words, bool from_source) {
    Process process = lichtraum.process("render -q -o a.pfm " + words);
    if (from_source) process.environment = {{"LICHTRAUM_KERNEL_DIR", project_path("kernels")}};
    auto const result = run_process(process);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return lichtraum.folder.read("a.pfm");
  };
  for (std::string const words : {"ball.sdf --samples 4", "square.glb --camera far --size 40x30",
                                  "ball.sdf --planes depth", "square.glb --planes normal --size 40x30"}) {
    INFO(words);
    CHECK(picture(words, false) == picture(words, true));
  }
}
