#include <cmath>
#include <filesystem>

#include "io/obj/made_pictures.hpp"
#include "support/encode_png.hpp"
#include "support/obj_import.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

using Pixels = std::vector<std::array<std::uint8_t, 4>>;

void write_png(TemporaryFolder const& folder, char const* name, int width, Pixels const& pixels) {
  folder.write(name, encode_png(width, int(pixels.size()) / width, pixels));
}

/// A triangle of each of these materials of m.mtl.
std::string triangle_of_each(std::initializer_list<char const*> materials) {
  std::string text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (char const* material : materials) text += std::string("usemtl ") + material + "\nf 1 2 3\n";
  return text;
}

}  // namespace

TEST_CASE("MTL: Phong's coefficients, mirrors and glass", "[unit][obj]") {
  TemporaryFolder const folder;
  ModelOptions options;
  options.is_part_of_scene = true;
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
  Model const model = import_obj(folder / "m.obj", options);
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

TEST_CASE("MTL: a model by itself has highlights of paint, and its mirrors and glass stay what they are",
          "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("m.mtl",
               "newmtl blender\nNs 250\nKd 0.8 0.05 0.05\nKs 0.5 0.5 0.5\nillum 2\n"
               "newmtl old\nKd 0.58 0.1 0.1\nKs 0.9 0.9 0.9\nNs 10\n"
               "newmtl weak\nKd 0.5 0.5 0.5\nKs 0.1 0.1 0.1\n"
               "newmtl matt\nKs 1 1 1\nillum 1\n"
               "newmtl mirror\nKs 0.3 0.3 0.3\nillum 3\n"
               "newmtl thin\nKs 0.5 0.5 0.5\nd 0.5\n");
  folder.write("m.obj", triangle_of_each({"blender", "old", "weak", "matt", "mirror", "thin"}));
  Model const model = import_obj(folder / "m.obj");
  auto const& material = [&](char const* name) -> Material const& { return **model.scene.materials.find(name); };
  struct Case {
    char const* name;
    Rgb color;
    double specular;
  };
  for (Case const& c : std::vector<Case>{{"blender", {0.8, 0.05, 0.05}, 1},
                                         {"old", {0.58, 0.1, 0.1}, 1},
                                         {"weak", {0.5, 0.5, 0.5}, 0.2},
                                         {"matt", {0.8, 0.8, 0.8}, 0}}) {
    INFO(c.name);
    REQUIRE(material(c.name).pbr());
    CHECK(material(c.name).pbr()->base_color == c.color);
    CHECK(material(c.name).pbr()->specular == Approx(c.specular));
    CHECK(material(c.name).pbr()->double_sided);
  }
  CHECK(material("blender").pbr()->roughness == Approx(std::pow(2 / 1002., 0.25)));
  CHECK(material("mirror").reflect() == 0.3);
  CHECK(material("thin").transmit() == 0.5);
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
  auto const png = encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{50, 60, 70, 255}});
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
  folder.write("my a.png", encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{120, 130, 250, 255}}));
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
    folder.write(name + ".png", encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{1, 2, 3, 255}}));
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

TEST_CASE("OBJ: a colour of 0 beside a picture that is lost says nothing", "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("m.obj", "mtllib m.mtl\nusemtl a\n" + triangle + "usemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
  folder.write("m.mtl",
               "newmtl a\nKd 0 0 0\nmap_Kd lost.png\nnewmtl b\nKd 0 0 0\nnewmtl c\nKd 0 0.5 0\nmap_Kd lost.png\n");
  Model const model = import_obj(folder / "m.obj");
  auto const kd = [&](char const* name) {
    PbrModel const* const pbr = (*model.scene.materials.find(name))->pbr();
    REQUIRE(pbr);
    return pbr->base_color;
  };
  CHECK(kd("a") == Rgb(0.8));
  CHECK(kd("b") == Rgb(0));
  CHECK(kd("c") == Rgb(0, 0.5, 0));
}
