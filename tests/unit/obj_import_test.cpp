#include "lichtraum/obj.hpp"

#include <filesystem>

#include "io/obj/made_pictures.hpp"
#include "support/catch.hpp"
#include "support/encode_png.hpp"
#include "support/gltf_triangles.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using testing::Corners;
using testing::world_triangles;

namespace {

Model import_text(std::string const& text, ModelOptions const& options = {}) {
  return import_obj_text(text, "m.obj", ".", options);
}

std::string shown(std::vector<Diagnostic> const& diagnostics) {
  std::string all;
  for (auto const& d : diagnostics) {
    all += d.location.file + ":" + std::to_string(d.location.line) + ":" + std::to_string(d.location.column) + ": " +
           d.message + "\n";
  }
  return all;
}

std::string const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Mesh const& mesh_of(Scene const& scene, std::string const& name) {
  auto const* shape = scene.shapes.find(name);
  REQUIRE(shape);
  return dynamic_cast<Mesh const&>(**shape);
}

using Pixels = std::vector<std::array<std::uint8_t, 4>>;

void write_png(TemporaryFolder const& folder, char const* name, int width, Pixels const& pixels) {
  folder.write(name, test::encode_png(width, int(pixels.size()) / width, pixels));
}

/// A triangle of each of these materials of m.mtl.
std::string triangle_of_each(std::initializer_list<char const*> materials) {
  std::string text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (char const* material : materials) text += std::string("usemtl ") + material + "\nf 1 2 3\n";
  return text;
}

}  // namespace

TEST_CASE("OBJ: a triangle, with a camera and lights that show it", "[unit][obj]") {
  Model const model = import_text("# a comment\r\n\r\n" + triangle);
  CHECK(shown(model.diagnostics) == "");
  auto const triangles = world_triangles(model.scene);
  REQUIRE(triangles.size() == 1);
  CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  CHECK(model.scene.cameras.size() == 1);
  CHECK(model.scene.lights.size() == 3);
  CHECK(model.scene.roots().at(0)->name() == "m");
}

TEST_CASE("OBJ: corners with texture coordinates and normals share vertices; missing ones are zeros", "[unit][obj]") {
  Model const model = import_text(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvn 0 0 2\nvn 0 3 4\n"
      "f 1/1/1 2/2/1 3/2/1 4/1/1\nf 1/1/1 2/2/1 3//2\nf -4/-2 -3/-1/-1 -2\n");
  CHECK(shown(model.diagnostics) == "");
  MeshGeometry const& g = *mesh_of(model.scene, "mesh").geometry();
  CHECK(g.triangle_count() == 4);
  CHECK(g.positions.size() == 4 + 1 + 3);  // a corner each of the second face, and all of the third, is another
  REQUIRE(g.texcoords.size() == 1);
  CHECK(g.texcoords[0][0] == Float2{0, 1});  // from above
  CHECK(g.texcoords[0][1] == Float2{1, 0.75f});
  CHECK(g.normals[0] == Float3{0, 0, 1});
  CHECK(g.normals[4] == Float3{0, 0.6f, 0.8f});
  CHECK(g.normals.back() == Float3{0, 0, 0});
  CHECK(g.texcoords[0].back() == Float2{0, 0});
}

TEST_CASE("OBJ: smoothing groups have normals where the file has none", "[unit][obj]") {
  // Three sides of a cube. Around the corner 1 there is one triangle of a side, or two: their angles count.
  std::string const cube = "v 0 0 0\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\nv 0 -1 -1\nv 0 0 -1\nv -1 0 -1\nvn 0 0 9\n";
  auto const normals_of_corner = [&](std::string const& faces) {
    MeshGeometry const geometry = *mesh_of(import_text(cube + faces).scene, "mesh").geometry();
    std::vector<Float3> normals;  // in the order of the faces
    for (std::uint32_t const i : geometry.indices) {
      if (geometry.positions[i] == Float3{0, 0, 0} && !geometry.normals.empty()) normals.push_back(geometry.normals[i]);
    }
    return normals;
  };
  auto const is_near = [](Float3 const& a, Vec3 const& b) {
    return glm::length(Vec3(a[0], a[1], a[2]) - glm::normalize(b)) < 1e-6;
  };
  auto const smooth = normals_of_corner("s 7\nf 1 2 3\nf 1 3 4\nf 1 4 5 6\nf 6 7 2 1\n");
  REQUIRE(smooth.size() == 5);
  for (Float3 const& n : smooth) CHECK(is_near(n, {1, 1, 1}));

  auto const creased = normals_of_corner("s 1\nf 1 2 3 4\ns 2\nf 1 4 5 6\ns 1\nf 6 7 2 1\ns off\nf 1 2 3\n");
  REQUIRE(creased.size() == 6);
  for (std::size_t const i : {0u, 1u, 4u}) CHECK(is_near(creased[i], {0, 1, 1}));
  CHECK(is_near(creased[2], {1, 0, 0}));
  CHECK(creased[5] == Float3{0, 0, 0});  // its triangle's own

  auto const given = normals_of_corner("s on\nf 1//1 2//1 3//1 4//1\nf 1 4 5 6\n");
  REQUIRE(given.size() == 4);
  CHECK(given[0] == Float3{0, 0, 1});
  CHECK(given[2] == Float3{1, 0, 0});

  CHECK(normals_of_corner("f 1 2 3 4\nf 1 4 5 6\n").empty());
  CHECK(normals_of_corner("s 0\nf 1 2 3 4\n").empty());
  // Triangles that are left out take no other's group with them.
  auto const faulty = normals_of_corner("s 1\nf 1 2 99\ns 0\nf 1 2 3 4\ns 1\nf 1 4 5 6\n");
  REQUIRE(faulty.size() == 4);
  CHECK(faulty[0] == Float3{0, 0, 0});
  CHECK(is_near(faulty[2], {1, 0, 0}));
}

TEST_CASE("OBJ: a mesh for each material of each object and group, however they alternate", "[unit][obj]") {
  Model const model = import_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\no car\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n"
      "g wheel left\nf 1 2 3\no car\nf 1 2 3\n");
  CHECK(mesh_of(model.scene, "car.red").geometry()->triangle_count() == 3);
  CHECK(mesh_of(model.scene, "car.blue").geometry()->triangle_count() == 1);
  CHECK(mesh_of(model.scene, "car.wheel left.red").geometry()->triangle_count() == 1);
  CHECK(shown(model.diagnostics) == "m.obj:5:8: there is no material 'red' nor 1 other: no mtllib names an MTL file\n");
}

TEST_CASE("OBJ: colours of vertices become linear", "[unit][obj]") {
  Model const model = import_text("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
  auto const& colors = mesh_of(model.scene, "mesh").geometry()->colors;
  REQUIRE(colors.size() == 3);
  CHECK(colors[0] == Float4{1, 1, 1, 1});
  CHECK(colors[1][0] == 1);
  CHECK(colors[1][1] == Approx(0.2140411));  // IEC 61966-2-1
  CHECK(colors[1][2] == 0);
  CHECK(mesh_of(model.scene, "mesh").material()->pbr());  // they change its base colour
}

TEST_CASE("OBJ: what is wrong is told with its place and left out", "[unit][obj]") {
  struct Case {
    std::string text;
    std::string expected;
  };
  Case const cases[] = {
      {triangle + "v 1 x 3\n", "m.obj:5:5: 'x' is not a number\n"},
      {triangle + "v 1 2\n", "m.obj:5:6: expected 3 numbers, found 2\n"},
      {triangle + "v 1 1e99 nan\n", "m.obj:5:5: '1e99' is too large\n"},
      {triangle + "v nan 1 1\nf 1 2 4\nf 4 2 3 1\n",
       "m.obj:0:0: 3 triangles left out: they have a vertex that is not finite\n"
       "m.obj:5:3: 'nan' is not a finite number\n"},
      {triangle + "f 1 2 9\n",
       "m.obj:0:0: 1 triangle left out: it has a vertex that is not there\n"
       "m.obj:5:7: there is no vertex 9; the file has 3\n"},
      {triangle + "f 1 2 -4\n", "m.obj:5:7: expected vertex/texture/normal, found '-4': the face is left out\n"},
      {triangle + "f 1 2 0\n", "m.obj:5:7: expected vertex/texture/normal, found '0': the face is left out\n"},
      {triangle + "f 1 2 99999999999999999999\n",
       "m.obj:5:7: expected vertex/texture/normal, found '99999999999999999999': the face is left out\n"},
      {triangle + "f 1 2\n", "m.obj:5:1: a face of 2 corners is left out\n"},
      {triangle + "f 1/5 2 3\n", "m.obj:0:0: 1 corners name a texture coordinate or normal that is not there\n"},
      {triangle + "l 1 2\np 1\n",
       "m.obj:5:0: points and lines are not drawn\nm.obj:6:0: points and lines are not drawn\n"},
      {triangle + "curv 0 1 1 2\nsurf 0 1\n", "m.obj:5:0: free-form curves and surfaces are not drawn\n"},
      {"vx 1 2 3\n" + triangle, "m.obj:1:1: unknown OBJ keyword 'vx': the line is left out\n"},
      {triangle + "s 1x\n", "m.obj:5:3: expected a smoothing group's number or off, found '1x'\n"},
      {triangle + "s -1\n", "m.obj:5:3: expected a smoothing group's number or off, found '-1'\n"},
      {"mtllib nowhere.mtl\n" + triangle, "m.obj:1:8: cannot open '" +
                                              (std::filesystem::current_path() / "nowhere.mtl").string() +
                                              "': No such file or directory\n"},
  };
  for (Case const& c : cases) {
    INFO(c.text);
    CHECK(shown(import_text(c.text).diagnostics) == c.expected);
  }
}

TEST_CASE("OBJ: nothing to draw is an error; faces may come before their vertices; lines may go on", "[unit][obj]") {
  for (char const* text : {"", "v 0 0 0\n", "garbage", "\x01\x02\xFF", "f 1 2 3\n"}) {
    CHECK_THROWS_AS(import_text(text), SceneError);
  }
  CHECK(world_triangles(import_text("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0").scene).size() == 1);
  Model const model = import_text("v 0 0 \\\n0\nv 1 0 0\nv 0 \\\r\n 1 0\nf 1 2 \\\n3\nl 1 2\n");
  CHECK(shown(model.diagnostics) == "m.obj:8:0: points and lines are not drawn\n");
  CHECK(world_triangles(model.scene)[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
}

TEST_CASE("MTL: Phong's coefficients, mirrors and glass", "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("m.mtl",
               "newmtl plain\nKd 0.1 0.2 0.3\nKs 0.5 0.5 0.4\nNs 20\nKa 0.01 0.02 0.03\nKe 0 0 2\n"
               "newmtl blender\nKa 1 1 1\nKd 0.5 0 0\n"
               "newmtl mirror\nKd 0 0 0\nKs 0.75 0.5 0.5\nillum 3\n"
               "newmtl glass\nKs 1 1 1\nillum 7\nd 0.25\nTr 0.5\nNi 1.5\n"
               "newmtl thin\nTr 0.5\nNi 1.5\nillum 4\n"
               "newmtl matt\nKs 1 1 1\nillum 1\n"
               "newmtl meshlab\nTr 1.000000\nillum 2\n"
               "newmtl filter\nKs 0.3 0.3 0.3\nillum 7\nNi 2.5\nTf 0.1 0.2 0.1\n"
               "newmtl clear\nd 1\nillum 6\nNi 1.5\n"
               "newmtl unbent\nillum 7\nNi 1\n");
  folder.write("m.obj", triangle_of_each({"plain", "blender", "mirror", "glass", "thin", "matt", "meshlab", "filter",
                                          "clear", "unbent"}));
  Model const model = import_obj(folder / "m.obj");
  CHECK(shown(model.diagnostics) == "");
  auto const& material = [&](char const* name) -> Material const& { return **model.scene.materials.find(name); };
  CHECK(material("plain").ka() == Rgb(0.01, 0.02, 0.03));
  CHECK(material("plain").kd() == Rgb(0.1, 0.2, 0.3));
  CHECK(material("plain").ks() == Rgb(0.5, 0.5, 0.4));
  CHECK(material("plain").m() == 20);
  CHECK(material("plain").emission() == Rgb(0, 0, 2));
  CHECK(!material("plain").pbr());  // nothing changes from point to point
  CHECK(material("blender").ka() == Rgb(0.5, 0, 0));
  CHECK(material("mirror").reflect() == 0.75);
  CHECK(material("glass").transmit() == 0.75);
  CHECK(material("glass").reflect() == 0.25);
  CHECK(material("glass").ior() == 1.5);
  CHECK(material("thin").transmit() == 0.5);
  CHECK(material("thin").ior() == 1);
  CHECK(material("matt").ks() == Rgb(0));
  CHECK(!material("meshlab").pbr());  // neither invisible
  CHECK(material("meshlab").transmit() == 0);
  CHECK(material("filter").transmit() == Approx(0.2));
  CHECK(material("filter").reflect() == 0.3);
  CHECK(material("clear").transmit() == 1);
  CHECK(material("unbent").transmit() == 0);
}

TEST_CASE("MTL: with a picture, materials keep highlights and mirrors, and zeros beside it are not meant",
          "[unit][obj]") {
  TemporaryFolder const folder;
  write_png(folder, "a.png", 1, {{50, 60, 70, 255}});
  folder.write("m.mtl",
               "newmtl maya\nillum 4\nKd 0 0 0\nmap_Kd a.png\nNi 1.00\nKs .5 .5 .5\nNs 18\n"
               "newmtl dense\nmap_Kd a.png\nNi 1.8\nKs 1 1 1\n"
               "newmtl mirror\nillum 3\nmap_Kd a.png\nKs 0.25 0.1 0.1\n"
               "newmtl air\nillum 7\nmap_Kd a.png\nNi 1\nd 0.5\n"
               "newmtl glow\nmap_Ke a.png\nKd 0 0 0\n"
               "newmtl dim\nmap_Ke a.png\nKe 0.5 0.5 0.5\n");
  folder.write("m.obj", triangle_of_each({"maya", "dense", "mirror", "air", "glow", "dim"}));
  Model const model = import_obj(folder / "m.obj");
  CHECK(shown(model.diagnostics) == "");
  auto const pbr = [&](char const* name) { return *(*model.scene.materials.find(name))->pbr(); };
  CHECK(pbr("maya").base_color == Rgb(1));
  CHECK(pbr("maya").ior == 1.5);
  CHECK(pbr("maya").specular == 1);
  CHECK(pbr("dense").ior == 1.8);
  CHECK(pbr("mirror").ior == Approx(3));  // ((3 - 1) / (3 + 1))^2
  CHECK(pbr("air").ior == 1);
  CHECK(pbr("glow").emissive == Rgb(1));
  CHECK(pbr("glow").base_color == Rgb(0));
  CHECK(pbr("dim").emissive == Rgb(0.5));
}

TEST_CASE("OBJ: colours of vertices count where no picture gives them", "[unit][obj]") {
  TemporaryFolder const folder;
  write_png(folder, "a.png", 1, {{50, 60, 70, 255}});
  folder.write("m.mtl", "newmtl scan\nmap_Kd a.png\nnewmtl plain\nnewmtl cut\nmap_d a.png\n");
  folder.write("m.obj",
               "mtllib m.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\n"
               "usemtl scan\nf 1/1 2/1 3/1\no bare\nusemtl scan\nf 1 2 3\n"
               "o other\nusemtl plain\nf 1/1 2/1 3/1\nusemtl cut\nf 1/1 2/1 3/1\n");
  Model const model = import_obj(folder / "m.obj");
  auto const has_colors = [&](char const* name) { return !mesh_of(model.scene, name).geometry()->colors.empty(); };
  CHECK(!has_colors("scan"));
  CHECK(has_colors("bare.scan"));  // without texture coordinates
  CHECK(has_colors("other.plain"));
  CHECK(has_colors("other.cut"));
}

TEST_CASE("MTL: pictures keep their place and options; what is wrong is told in its own file", "[unit][obj]") {
  TemporaryFolder const folder;
  std::filesystem::create_directories(folder / "materials");
  folder.write("materials/red.ppm", "P6 1 1 255 \xFF");
  folder.write("materials/my stuff.mtl",
               "Kd 1 1 1\nnewmtl a\nKd 1 x 1\nmap_Kd -s 2 3 -o 0.25 0.5 -clamp on red.ppm\nmap_Ke ..\\..\\secret.png\n"
               "wibble 1\nnorm nowhere.png\n");
  folder.write("m.obj", "mtllib materials\\my stuff.mtl\nusemtl a\n" + triangle);
  Model const model = import_obj(folder / "m.obj");
  std::string all = shown(model.diagnostics);
  std::string const mtl = (folder / "materials/my stuff.mtl").string();
  CHECK_THAT(all, contains_text(mtl + ":1:1: a property before the first newmtl is left out\n"));
  CHECK_THAT(all, contains_text(mtl + ":3:6: 'x' is not a number\n"));
  CHECK_THAT(all, contains_text(mtl + ":4:0: the picture is left out: it is not a PNG, JPEG, WebP, BMP or TGA file\n"));
  CHECK_THAT(all, contains_text(mtl + ":5:0: the picture is left out: cannot use 'materials/../../secret.png'"));
  CHECK_THAT(all, contains_text(mtl + ":6:1: unknown MTL keyword 'wibble': the line is left out\n"));
  CHECK_THAT(all, contains_text(mtl + ":7:0: the picture is left out: cannot open"));
}

TEST_CASE("MTL: physically based coefficients and their pictures", "[unit][obj]") {
  TemporaryFolder const folder;
  auto const write = [&](char const* name, int width, Pixels const& pixels) { write_png(folder, name, width, pixels); };
  write("color.png", 1, {{10, 20, 30, 255}});
  write("holes.png", 2, {{255, 255, 255, 255}, {0, 0, 0, 255}});
  write("leaf.png", 2, {{40, 50, 60, 255}, {40, 50, 60, 128}});
  write("rough.png", 1, {{100, 100, 100, 7}});
  write("metal.png", 1, {{200, 200, 200, 255}, {0, 0, 0, 255}});
  folder.write("m.mtl",
               "newmtl car\nKd 0.5 0 0\nNs 7\nPr 0.25\nPm 0.75\nPc 1\nPcr 0.125\n"
               "newmtl fence\nmap_Kd color.png\nmap_d holes.png\n"
               "newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\n"
               "newmtl net\nKd 0 1 0\nd 0.5\nmap_opacity -s 2 2 holes.png\n"
               "newmtl worn\nPr 0\nPm 0\nmap_Pr rough.png\nmap_Pm -s 5 5 metal.png\n"
               "newmtl metal\nPr 0.5\nmap_Pm -s 5 5 metal.png\n");
  folder.write("m.obj", triangle_of_each({"car", "fence", "leaf", "net", "worn", "metal"}));
  Model const model = import_obj(folder / "m.obj");
  CHECK(shown(model.diagnostics) == "");
  auto const pbr = [&](char const* name) { return *(*model.scene.materials.find(name))->pbr(); };
  auto const pixels = [](TextureSlot const& slot) { return slot.texture->image->rgba; };
  using Bytes = std::vector<std::uint8_t>;

  PbrModel const car = pbr("car");
  CHECK(car.base_color == Rgb(0.5, 0, 0));
  CHECK(car.roughness == 0.25);
  CHECK(car.metallic == 0.75);
  CHECK(car.clearcoat == 1);
  CHECK(car.clearcoat_roughness == 0.125);
  CHECK(car.alpha_mode == AlphaMode::opaque);

  CHECK(pbr("fence").alpha_mode == AlphaMode::blend);
  CHECK(pixels(pbr("fence").base_color_texture) == Bytes{10, 20, 30, 255, 10, 20, 30, 0});
  CHECK(pixels(pbr("leaf").base_color_texture) == Bytes{40, 50, 60, 255, 40, 50, 60, 128});
  PbrModel const net = pbr("net");
  CHECK(pixels(net.base_color_texture) == Bytes{255, 255, 255, 255, 255, 255, 255, 0});
  CHECK(net.base_color_texture.scale == glm::dvec2(2));
  CHECK(net.base_color == Rgb(0, 1, 0));
  CHECK(net.alpha == 0.5);

  PbrModel const worn = pbr("worn");  // one picture of the size of both
  CHECK(pixels(worn.metallic_roughness_texture) == Bytes{255, 100, 200, 255, 255, 100, 0, 255});
  CHECK(worn.metallic_roughness_texture.scale == glm::dvec2(1));
  CHECK(worn.roughness == 1);
  CHECK(worn.metallic == 1);
  PbrModel const metal = pbr("metal");
  CHECK(pixels(metal.metallic_roughness_texture) == Bytes{255, 255, 200, 255, 255, 255, 0, 255});
  CHECK(metal.metallic_roughness_texture.scale == glm::dvec2(5));
  CHECK(metal.roughness == 0.5);
}

TEST_CASE("MTL: bump maps are heights, or normals where they are blue", "[unit][obj]") {
  TemporaryFolder const folder;
  auto const write = [&](char const* name, int width, Pixels const& pixels) { write_png(folder, name, width, pixels); };
  std::array<std::uint8_t, 4> const black{0, 0, 0, 255}, white{255, 255, 255, 255}, blue{120, 130, 250, 255};
  write("right.png", 4, {black, black, white, white});  // higher on the right
  write("up.png", 1, {white, white, black, black});
  write("blue.png", 1, {blue});
  folder.write("m.mtl",
               "newmtl right\nmap_Bump -bm 25 -clamp on right.png\n"  // 2 % of 4 pixels for each 255: a slope of 1
               "newmtl up\nbump -bm 25 -s 3 3 -clamp on up.png\n"
               "newmtl deep\nbump -bm -25 -clamp on up.png\n"
               "newmtl around\nbump -bm 25 right.png\n"
               "newmtl slight\nbump right.png\n"
               "newmtl normals\nmap_bump -bm 0.5 blue.png\n"
               "newmtl both\nmap_bump right.png\nnorm blue.png\n"
               "newmtl no_number\nmap_bump -bm x right.png\n");
  folder.write("m.obj", triangle_of_each({"right", "up", "deep", "around", "slight", "normals", "both", "no_number"}));
  Model const model = import_obj(folder / "m.obj");
  CHECK(shown(model.diagnostics) == (folder / "m.mtl").string() + ":17:14: 'x' is not a number\n");
  auto const pbr = [&](char const* name) { return *(*model.scene.materials.find(name))->pbr(); };
  auto const normals = [&](char const* name) { return pbr(name).normal_texture.texture->image->rgba; };
  using Bytes = std::vector<std::uint8_t>;

  // An upright normal is 128 128 255; one that leans by 45 degrees has 128 -+ 90.
  CHECK(normals("right") == Bytes{128, 128, 255, 255, 37, 128, 218, 255, 37, 128, 218, 255, 128, 128, 255, 255});
  CHECK(normals("up") == Bytes{128, 128, 255, 255, 128, 37, 218, 255, 128, 37, 218, 255, 128, 128, 255, 255});
  CHECK(pbr("up").normal_texture.scale == glm::dvec2(3));
  CHECK(normals("deep") == Bytes{128, 128, 255, 255, 128, 218, 218, 255, 128, 218, 218, 255, 128, 128, 255, 255});
  CHECK(normals("around") == Bytes{218, 128, 218, 255, 37, 128, 218, 255, 37, 128, 218, 255, 218, 128, 218, 255});
  CHECK(normals("slight") == Bytes{133, 128, 255, 255, 122, 128, 255, 255, 122, 128, 255, 255, 133, 128, 255, 255});
  CHECK(normals("normals") == Bytes{120, 130, 250, 255});
  CHECK(pbr("normals").normal_scale == 0.5);
  CHECK(normals("both") == Bytes{120, 130, 250, 255});
  CHECK(normals("no_number") == normals("slight"));
}

TEST_CASE("MTL: pictures made of others take no more memory than half a gigabyte", "[unit][obj]") {
  auto const picture = [](int width, int height) {
    auto image = std::make_shared<TextureImage>();
    image->width = width;
    image->height = height;
    image->rgba.resize(4 * std::size_t(width) * std::size_t(height));
    return image;
  };
  obj::MadePictures made;
  auto const wide = picture(8192, 1);
  auto const high = picture(1, 8192);
  auto const first = made.with_channel(wide, obj::Channel::alpha, high);
  CHECK(first->height == 8192);
  CHECK(made.with_channel(wide, obj::Channel::alpha, high) == first);
  CHECK(made.with_channel(nullptr, obj::Channel::alpha, high)->width == 1);
  CHECK(!made.is_full());
  CHECK(made.with_channel(wide, obj::Channel::alpha, picture(1, 8192)) == wide);
  CHECK(made.is_full());
  CHECK(made.normals_from(wide, 1, false)->height == 1);  // there is room for a small one
  CHECK(made.normals_from(picture(8192, 8192), 1, false) == nullptr);
}

TEST_CASE("OBJ: no file outside the model's folder is read", "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("secret.mtl", "newmtl a\nKd 1 0 0\n");
  std::filesystem::create_directories(folder / "model");
  for (std::string const& library : {std::string("../secret.mtl"), (folder / "secret.mtl").string()}) {
    folder.write("model/m.obj", "mtllib " + library + "\nusemtl a\n" + triangle);
    Model const model = import_obj(folder / "model/m.obj");
    CHECK_THAT(shown(model.diagnostics), contains_text("m.obj:1:8: cannot use '") && contains_text("no material 'a'"));
    ModelOptions options;
    options.allowed_paths = {folder.path()};
    CHECK(shown(import_obj(folder / "model/m.obj", options).diagnostics) == "");
  }
}

TEST_CASE("MTL: pictures that are called otherwise, or lie elsewhere, are found", "[unit][obj]") {
  struct Case {
    char const* description;
    std::string named;  // in mtl/m.mtl, of m.obj
    std::string file;   // that is there
    std::string found;  // as told; empty: not found
    bool is_warned = true;
  };
  Case const cases[] = {
      {"as it is", "map_Kd tex.png", "mtl/tex.png", "mtl/tex.png", false},
      {"quotes", "map_Kd \"my tex.png\"", "mtl/my tex.png", "mtl/my tex.png", false},
      {"options after it", "map_Kd my tex.png -bm 0.1 -clamp on", "mtl/my tex.png", "mtl/my tex.png", false},
      {"letter case", "map_Kd Sub\\TEX.PNG", "mtl/sUb/tex.Png", "mtl/sUb/tex.Png", false},
      {"from the .obj", "map_Kd sub/tex.png", "SUB/tex.png", "SUB/tex.png"},
      {"a folder of Windows", "map_Kd C:\\Users\\bob\\Tex.png", "mtl/tex.png", "mtl/tex.png"},
      {"a folder of Linux", "map_Kd /home/bob/tex.png", "tex.PNG", "tex.PNG"},
      {"a folder above", "map_Kd ../../pictures/tex.png", "mtl/tex.png", "mtl/tex.png"},
      {"in textures", "map_Kd C:\\tex.png", "mtl/Textures/tex.png", "mtl/Textures/tex.png"},
      {"in tex", "map_Kd tex.png", "TEX/tex.png", "TEX/tex.png"},
      {"in maps", "map_Kd nowhere/tex.png", "maps/TEX.png", "maps/TEX.png"},
      {"its folder is there", "map_Kd other/tex.png", "mtl/tex.png", ""},
      {"in another folder", "map_Kd C:\\tex.png", "images/tex.png", ""},
      {"a folder of that name", "map_Kd C:\\other", "mtl/tex.png", ""},
  };
  auto const png = test::encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{50, 60, 70, 255}});
  for (Case const& c : cases) {
    INFO(c.description);
    TemporaryFolder const folder;
    std::filesystem::create_directories(folder / "mtl/other");
    std::filesystem::create_directories((folder / c.file).parent_path());
    folder.write(c.file, png);
    folder.write("mtl/m.mtl", "newmtl a\n" + c.named + "\n");
    folder.write("m.obj", "mtllib mtl/m.mtl\nusemtl a\n" + triangle);
    Model const model = import_obj(folder / "m.obj");
    Material const& material = **model.scene.materials.find("a");
    CHECK((material.pbr() && material.pbr()->base_color_texture) == !c.found.empty());
    bool const is_told = std::string(c.description) != "as it is";
    REQUIRE(model.diagnostics.size() == (is_told ? 1u : 0u));
    if (!is_told) continue;
    Diagnostic const& told = model.diagnostics[0];
    CHECK(told.location.line == 2);
    if (c.found.empty()) {
      CHECK(told.code == DiagnosticCode::texture_left_out);
    } else {
      CHECK(told.severity == (c.is_warned ? Severity::warning : Severity::note));
      CHECK(told.code == (c.is_warned ? DiagnosticCode::file_elsewhere : DiagnosticCode::none));
      INFO(told.message);
      CHECK(told.message.ends_with(", '" + c.found + "' is used"));
    }
  }
}

TEST_CASE("MTL: the options of a picture count after its name as well", "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("my a.png", test::encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{120, 130, 250, 255}}));
  folder.write("m.mtl", "newmtl a\nmap_Bump -s 2 2 my a.png -bm 0.25 -o 0.5 0.5\n");
  folder.write("m.obj", triangle_of_each({"a"}));
  Model const model = import_obj(folder / "m.obj");
  REQUIRE((*model.scene.materials.find("a"))->pbr());
  PbrModel const pbr = *(*model.scene.materials.find("a"))->pbr();
  CHECK(pbr.normal_scale == 0.25);
  REQUIRE(pbr.normal_texture);
  CHECK(pbr.normal_texture.scale == glm::dvec2(2));
}

TEST_CASE("MTL: one warning stands for all pictures that are elsewhere; notes name them", "[unit][obj]") {
  TemporaryFolder const folder;
  std::string mtl;
  for (std::string const name : {"a", "b", "c"}) {
    folder.write(name + ".png", test::encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{1, 2, 3, 255}}));
    mtl += "newmtl " + name + "\nmap_Kd C:\\" + name + ".png\nmap_Ke C:\\" + name + ".png\n";
  }
  folder.write("m.mtl", mtl);
  folder.write("m.obj", triangle_of_each({"a", "b", "c"}));
  auto const found = import_obj(folder / "m.obj").diagnostics;
  REQUIRE(found.size() == 3);
  CHECK(found[0].message == "instead of 'C:/a.png', 'a.png' is used (and in 2 more lines)");
  CHECK(found[1].message == "instead of 'C:/b.png', 'b.png' is used");
  CHECK(found[2].severity == Severity::note);
}

TEST_CASE("OBJ: an MTL file that is called otherwise is found, or the one called like the model", "[unit][obj]") {
  struct Case {
    std::string obj;
    std::string file;
    std::string told;
  };
  std::string const use = "usemtl a\n";
  Case const cases[] = {
      {"mtllib \"my stuff.mtl\"\n" + use, "my stuff.mtl", "instead of '\"my stuff.mtl\"', 'my stuff.mtl' is used"},
      {"mtllib My Stuff.MTL\n" + use, "my stuff.mtl", "instead of 'My Stuff.MTL', 'my stuff.mtl' is used"},
      {"mtllib C:\\My Documents\\a.mtl\n" + use, "a.mtl", "instead of 'C:/My Documents/a.mtl', 'a.mtl' is used"},
      {"mtllib nowhere.mtl\n" + use, "model.mtl", "instead of 'nowhere.mtl', 'model.mtl' is used"},
      {use, "Model.mtl", "no mtllib names an MTL file: 'Model.mtl' is used"},
      {"mtllib b.mtl A.mtl a.mtl\n" + use, "a.mtl", "instead of 'A.mtl', 'a.mtl' is used"},
      {"mtllib b.mtl a.mtl A.mtl\n" + use, "a.mtl", ""},
  };
  for (Case const& c : cases) {
    INFO(c.obj);
    TemporaryFolder const folder;
    folder.write("b.mtl", "newmtl b\n");
    folder.write(c.file, "newmtl a\nKd 0.25 0 0\n");
    folder.write("model.obj", c.obj + triangle);
    Model const model = import_obj(folder / "model.obj");
    REQUIRE(model.scene.materials.find("a"));
    CHECK((*model.scene.materials.find("a"))->kd() == Rgb(0.25, 0, 0));
    std::string const told = shown(model.diagnostics);
    CHECK(told.substr(std::min(told.find(": ") + 2, told.size())) == (c.told.empty() ? "" : c.told + "\n"));
  }
  TemporaryFolder const folder;
  folder.write("model.mtl", "newmtl a\nwibble\n");
  folder.write("model.obj", triangle);
  CHECK(shown(import_obj(folder / "model.obj").diagnostics) == "");  // it is not looked for
}

TEST_CASE("OBJ: a missing MTL file is told once, not for each of its materials", "[unit][obj]") {
  TemporaryFolder const folder;
  std::string uses;
  for (int i = 0; i < 150; ++i) uses += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
  folder.write("m.obj", "mtllib nowhere.mtl\n" + triangle + uses);
  auto const found = import_obj(folder / "m.obj").diagnostics;
  REQUIRE(found.size() == 2);
  CHECK(found[0].code == DiagnosticCode::unreadable_mtl);
  CHECK(found[1].message == "there is no material 'm0' nor 149 others: an MTL file is missing");
}

TEST_CASE("OBJ: a file that is refused for its place has a hint", "[unit][obj]") {
  TemporaryFolder const folder;
  std::filesystem::create_directories(folder / "model");
  folder.write("model/n.mtl", "newmtl a\nmap_Kd ../tex.png\nmap_Ke nowhere.png\n");
  folder.write("model/m.obj", "mtllib n.mtl ../o.mtl /o.mtl o.mtl\nusemtl a\n" + triangle);
  auto const found = import_obj(folder / "model/m.obj").diagnostics;
  REQUIRE(found.size() == 5);
  std::string const hint = "--allow-path <folder> permits files outside of the model's folder";
  CHECK(found[0].hint == hint);
  CHECK(found[1].hint == hint);
  CHECK(found[2].hint == "");
  CHECK(found[3].hint == hint);
  CHECK(found[4].hint == "");
}

TEST_CASE("OBJ: normals that are no numbers are the triangle's own, without a warning for each", "[unit][obj]") {
  Model const model = import_text(triangle + "vn nan NaN -nan\nvn 0 0 1\nf 1//1 2//2 3//2\n");
  CHECK(shown(model.diagnostics) == "");
  CHECK(mesh_of(model.scene, "mesh").geometry()->normals.at(3) == Float3{0, 0, 0});
}

TEST_CASE("OBJ: what is another file is told so, once", "[unit][obj]") {
  for (auto const& [text, message] : {
           std::pair<std::string, std::string>{"<!DOCTYPE html>\n<title>404</title>\n", "an HTML document"},
           {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"},
           {std::string("PK\3\4\n\0\n", 7), "a ZIP archive or an office document"},
           {"\x1F\x8B\x08\n", "a gzip archive"},
       }) {
    INFO(message);
    try {
      import_text(text);
      FAIL("it was read");
    } catch (SceneError const& error) {
      REQUIRE(error.diagnostics().size() == 1);
      CHECK(error.diagnostics()[0].code == DiagnosticCode::not_obj);
      CHECK(error.diagnostics()[0].message == "this is " + message + ", not an OBJ model");
      CHECK(!error.diagnostics()[0].hint.empty());
    }
  }
}

TEST_CASE("OBJ: hostile sizes end soon", "[unit][obj]") {
  std::string same = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";  // one position with many texture coordinates
  for (int i = 1; i <= 100000; ++i) same += "vt " + std::to_string(i) + "\nf 1/" + std::to_string(i) + " 2/1 3/1\n";
  CHECK(world_triangles(import_text(same).scene).size() == 100000);
  std::string polygon = triangle + "f";
  for (int i = 0; i < 200000; ++i) polygon += " " + std::to_string(1 + i % 3);
  CHECK(world_triangles(import_text(polygon).scene).size() == 1 + 199998);
  std::string groups = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 70000; ++i) groups += "g " + std::to_string(i) + "\nf 1 2 3\n";
  CHECK_THAT(shown(import_text(groups).diagnostics), contains_text("more than 65536 objects and groups"));
}
