#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/skip.hpp"

using Json = nlohmann::json;

TEST_CASE("info counts shapes, defined and drawn, and bounds them", "[app][info]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf",
                         "define material m 1 1 1 1 1 1 0 0 0 1\n"
                         "define shape sphere s 0 0 0 1 m\n"
                         "define shape box b 0 0 0 1 2 3 m\n"
                         "define shape triangle t 0 0 0 1 0 0 0 1 0 m\n"
                         "define shape composite pair s b\n"
                         "define shape composite left pair t\n"
                         "define shape composite right pair pair\n"
                         "transform right translate 10 0 0\n"
                         "define light ambient sky 0.1 0.2 0.3\n"
                         "define light sun 1 2 3 0.1 0.1 0.1 1 1 1\n"
                         "define camera eye 60 4 3\n"
                         "define background 0.5 0.25 0\n"
                         "render eye a.ppm\n"
                         "render eye b.ppm 8 6\n");
  Json const json = Json::parse(lichtraum("info a.sdf --json").out);
  Json const& shapes = json["shapes"];
  CHECK(shapes["defined"]["spheres"] == 1);
  CHECK(shapes["defined"]["composites"] == 3);
  CHECK(shapes["drawn"]["spheres"] == 3);
  CHECK(shapes["drawn"]["boxes"] == 3);
  CHECK(shapes["drawn"]["triangles"] == 1);
  CHECK(json["materials"] == 1);
  CHECK(json["lights"].size() == 2);
  CHECK(json["lights"][1]["position"] == Json({1, 2, 3}));
  CHECK(json["cameras"][0]["size"] == Json({4, 3}));
  CHECK(json["renders"][1]["file"] == "b.ppm");
  CHECK(json["background"] == Json({0.5, 0.25, 0}));
  CHECK(double(json["ambient"][0]) == Approx(0.2));
  CHECK(json["bounds"]["min"] == Json({-1, -1, -1}));
  CHECK(json["bounds"]["max"] == Json({11, 2, 3}));
  auto const text = lichtraum("info a.sdf").out;
  CHECK_THAT(text, contains_text("spheres") && contains_text("eye, 60 degrees wide, 4x3") && contains_text("11 2 3"));
}

TEST_CASE("info counts what a mesh in a scene has of materials and textures", "[app][info]") {
  Lichtraum const lichtraum;
  // One pixel: BMP's headers, and a red of three bytes.
  std::string dot = "BM";
  for (std::uint32_t const word : {58u, 0u, 54u, 40u, 1u, 1u, (24u << 16) | 1u, 0u, 4u, 0u, 0u, 0u, 0u}) {
    for (int shift = 0; shift < 32; shift += 8) dot += char((word >> shift) & 255);
  }
  lichtraum.folder.write("dot.bmp", dot + std::string("\0\0\xFF\0", 4));
  lichtraum.folder.write("mesh.mtl", "newmtl red\nKd 0.5 0 0\nmap_Kd dot.bmp\nnewmtl blue\nKd 0 0 1\n");
  lichtraum.folder.write("mesh.obj",
                         "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                         "usemtl red\nf 1/1 2/2 3/3\nusemtl blue\nf 3/3 2/2 1/1\n");
  std::string const scene =
      "define material red 1 1 1  1 1 1  0 0 0  1\ndefine shape mesh m mesh.obj\ndefine shape composite twice m m\n";
  lichtraum.folder.write("scene.sdf", scene);
  Json const json = Json::parse(lichtraum("info scene.sdf --json").out);
  CHECK(json["materials"] == 3);
  REQUIRE(json["textures"].size() == 1);
  CHECK(json["textures"][0]["size"] == Json({1, 1}));
  CHECK_THAT(lichtraum("info scene.sdf").out, contains_text("texture         dot"));
}

TEST_CASE("info says what draws each picture, and why", "[app][info]") {
  Lichtraum const lichtraum;
  std::string const scene = "define camera eye 60 4 3\nrender eye a.ppm\nrender eye b.ppm integrator=path\n";
  Json const renders = Json::parse(lichtraum("info - --json", scene).out)["renders"];
  CHECK(renders[0]["integrator"]["name"] == "whitted");
  CHECK(renders[1]["integrator"] == Json({{"name", "path"}, {"reason", "the scene's render asks for it"}}));
  CHECK_THAT(lichtraum("info -", scene).out,
             contains_text("a.ppm through eye, by whitted, as that is the default for scenes\n"));
  std::string const no_picture = "define camera eye 60 4 3\n";
  CHECK_THAT(lichtraum("info -", no_picture).out, contains_text("drawn           by whitted, as "));
  CHECK(Json::parse(lichtraum("info - --json", no_picture).out)["integrator"]["name"] == "whitted");
}

TEST_CASE("info tells of the environment", "[app][info]") {
  Lichtraum const lichtraum;
  std::string const scene =
      "define camera eye 60 4 3\ndefine light environment sky 1 2 3 rotation=30\nrender eye a.ppm\n";
  Json const json = Json::parse(lichtraum("info - --json", scene).out);
  CHECK(json["environment"] ==
        Json({{"name", "sky"}, {"source", "1 2 3"}, {"size", {1, 1}}, {"rotation_degrees", 30}, {"brightness", 1}}));
  CHECK(json["renders"][0]["integrator"]["name"] == "path");
  CHECK_THAT(lichtraum("info -", scene).out,
             contains_text("environment     1 2 3, 1x1, turned by 30 degrees, brightness 1\n"));
  CHECK(Json::parse(lichtraum("info - --json", "define camera eye 60\n").out)["environment"].is_null());
}

TEST_CASE("info says by what numbers a model's scenes and animations are chosen, and what is behind it",
          "[app][info][gltf]") {
  Lichtraum const lichtraum;
  lichtraum::testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0});
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const places = writer.add_vec3({0, 0, 0, 2, 0, 0});
  Json const animation = {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                          {"samplers", {{{"input", times}, {"output", places}}}}};
  Json named = animation;
  named["name"] = "walk";
  writer.json["animations"] = {animation, named};
  lichtraum.folder.write("model.glb", writer.glb());
  std::string const text = lichtraum("info model.glb").out;
  CHECK_THAT(text, contains_text("  animation       0, 2 s\n") && contains_text("  animation       1, walk, 2 s\n") &&
                       contains_text("  background      from 0.45 0.45 0.45 above to 0.18 0.18 0.18\n"));
  Json const json = Json::parse(lichtraum("info model.glb --json").out);
  CHECK(json["background"] == Json({0.45, 0.45, 0.45}));
  CHECK(json["background_below"] == Json({0.18, 0.18, 0.18}));
}

TEST_CASE("info does not unfold a graph of 2^200 spheres, nor recurse down 100,000 composites", "[app][info]") {
  Lichtraum const lichtraum;
  std::string const start = "define material m 1 1 1 1 1 1 0 0 0 1\ndefine shape sphere s0 0 0 0 1 m\n";
  std::string wide = start;
  for (int i = 1; i <= 200; ++i) {
    std::string const below = std::to_string(i - 1);
    wide += "define shape composite s" + std::to_string(i) + " s" + below + " s" + below + "\n";
  }
  auto const doubled = lichtraum("info -", wide);
  CHECK(doubled.exit_code == 0);
  CHECK_THAT(doubled.out, contains_text("more than 4e18"));
  std::string deep = start;
  for (int i = 1; i <= 100'000; ++i) {
    deep += "define shape composite s" + std::to_string(i) + " s" + std::to_string(i - 1) + "\n";
  }
  Json const chain = Json::parse(lichtraum("info - --json", deep).out);
  CHECK(chain["shapes"]["drawn"]["spheres"] == 1);
  CHECK(chain["shapes"]["drawn"]["composites"] == 100'000);
  CHECK(chain["bounds"]["max"] == Json({1, 1, 1}));
}

TEST_CASE("check reports without drawing", "[app][check]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const good = lichtraum("check a.sdf");
  CHECK(good.exit_code == 0);
  CHECK(good.out == "a.sdf: good\n  would write ball.ppm, 32x24, camera 'eye'\n");
  CHECK(lichtraum("check a.sdf -q").out.empty());
  CHECK(lichtraum("check -", ball_scene).out == "-: good\n  would write ball.ppm, 32x24, camera 'eye'\n");
  auto const warned = lichtraum("check -", "define camera eye 60 4 3\nrender nose a.ppm\n");
  CHECK(warned.exit_code == 0);
  CHECK(warned.out == "-: good, 2 warnings\n  would write a.ppm, 4x3, camera 'eye'\n");
  CHECK_THAT(warned.err, contains_text("<stdin>:2:8: warning:"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf"});
}

TEST_CASE("devices lists the reference tracer last", "[app][devices]") {
  Lichtraum const lichtraum;
  Json const devices = Json::parse(lichtraum("devices --json").out)["devices"];
  REQUIRE(!devices.empty());
  CHECK(devices.back()["kind"] == "reference");
  CHECK(devices.back()["compute_units"] >= 1);
  for (std::size_t i = 0; i < devices.size(); ++i) CHECK(devices[i]["index"] == i);
  CHECK_THAT(lichtraum("devices").out, contains_text(std::string(devices.back()["name"])));
}

TEST_CASE("without any OpenCL platform: a warning, the reference tracer, and what to install", "[app][devices]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const without_opencl = [&](std::string const& words) {
    Process process = lichtraum.process(words);
    process.environment = {{"OCL_ICD_VENDORS", lichtraum.folder.path().string()}};
    return run_process(process);
  };
  auto const rendered = without_opencl("render a.sdf");
  CHECK(rendered.exit_code == 0);
  CHECK_THAT(rendered.err, contains_text("reference tracer"));
  CHECK(std::filesystem::exists(lichtraum.folder / "ball.ppm"));
  auto const doctor = without_opencl("doctor");
  CHECK(doctor.exit_code == 69);
  CHECK_THAT(doctor.err, contains_text("pocl-opencl-icd"));
  CHECK(without_opencl("render a.sdf --device cpu").exit_code == 69);
}

TEST_CASE("doctor finds a working device where there is one", "[app][devices]") {
  Lichtraum const lichtraum;
  auto const result = lichtraum("doctor");
  Json const devices = Json::parse(lichtraum("devices --json").out)["devices"];
  if (devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  INFO(result.out + result.err);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.out, contains_text("good: ") && contains_text("differ from the reference"));
}
