#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "lichtraum/ply.hpp"
#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/encode_png.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Mesh const& mesh_of(Model const& model, std::string const& name = "mesh") {
  auto const* shape = model.scene.shapes.find(name);
  REQUIRE(shape);
  return dynamic_cast<Mesh const&>(**shape);
}
MeshGeometry const& geometry_of(Model const& model) { return *mesh_of(model).geometry(); }

/// What a corner of the triangles has.
template <class T>
T at(MeshGeometry const& geometry, std::vector<T> const& list, std::size_t corner) {
  return list.at(geometry.indices.at(corner));
}

/// A square of four vertices, whose texture coordinates or colors the faces give, as ASCII.
std::string square(std::string const& face_properties, std::string const& faces, std::string const& comments = "") {
  auto const count = std::count(faces.begin(), faces.end(), '\n');
  return "ply\nformat ascii 1.0\n" + comments +
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(count) + "\nproperty list uchar int vertex_indices\n" + face_properties +
         "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces;
}
std::string const texcoord = "property list uchar float texcoord\n";

Model import_text(std::string const& text, ModelOptions const& options = {}) {
  return import_ply_bytes(text, "m.ply", ".", options);
}

/// Numbers as one of the three encodings has them.
class Writer {
 public:
  explicit Writer(std::string const& format) : format_(format) {}
  template <class T>
  void add(T value) {
    if (format_ == "ascii") {
      text += std::to_string(value) + " ";
      return;
    }
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (format_ == "binary_big_endian") std::reverse(bytes, bytes + sizeof value);
    text.append(bytes, sizeof value);
  }
  std::string text;

 private:
  std::string format_;
};

std::string one_pixel(std::uint8_t red) {
  return test::encode_png(1, 1, std::vector<std::array<std::uint8_t, 4>>{{red, 0, 0, 255}});
}

}  // namespace

TEST_CASE("PLY: corners have their own texture coordinates, shared where equal", "[unit][ply]") {
  for (std::string const format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    Writer out(format);
    out.text = "ply\nformat " + format +
               " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\n"
               "element face 2\nproperty list uchar double texcoord\nproperty int flags\n"
               "property list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i) {
      for (float f : {float(i), float(i * i), 0.0f, 0.0f, 0.0f, i == 3 ? -1.0f : 1.0f}) out.add(f);
      for (int c = 0; c < 3; ++c) out.add(std::uint8_t(c == 0 && i == 2 ? 255 : 0));
    }
    // Both triangles have the edge of 0 and 2, and agree at 2 only.
    double const uvs[2][6] = {{0, 0, 1, 0, 1, 0.75}, {0.5, 0.25, 1, 0.75, 0, 1}};
    int const vertices[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (int face = 0; face < 2; ++face) {
      out.add(std::uint8_t(6));
      for (double uv : uvs[face]) out.add(uv);
      out.add(std::int32_t(7));
      out.add(std::uint8_t(3));
      for (int vertex : vertices[face]) out.add(std::int32_t(vertex));
    }
    Model const model = import_text(out.text);
    CHECK(placed_message_lines(model.diagnostics) == "");
    MeshGeometry const& g = geometry_of(model);
    CHECK(g.indices == std::vector<std::uint32_t>{0, 1, 2, 3, 2, 4});
    REQUIRE(g.positions.size() == 5);
    CHECK(g.positions[3] == g.positions[0]);
    CHECK(g.positions[4] == Float3{3, 9, 0});
    CHECK(g.texcoords[0] == std::vector<Float2>{{0, 1}, {1, 1}, {1, 0.25f}, {0.5f, 0.75f}, {0, 0}});
    CHECK(g.normals == std::vector<Float3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}});
    CHECK(g.colors[2] == Float4{1, 0, 0, 1});
    CHECK(g.colors[3] == Float4{0, 0, 0, 1});
  }
}

TEST_CASE("PLY: corners share a vertex only where each number of them is the same", "[unit][ply]") {
  std::string const first = "3 0 1 2 6 0 0 0 0 0 0  1 1 1 1\n";
  for (std::string const other : {"6 1 0 1 0 1 0  1 1 1 1", "6 0 1 0 1 0 1  1 1 1 1", "6 0 0 0 0 0 0  0 1 1 1",
                                  "6 0 0 0 0 0 0  1 0 1 1", "6 0 0 0 0 0 0  1 1 0 1", "6 0 0 0 0 0 0  1 1 1 0"}) {
    INFO(other);
    Model const model = import_text(
        square(texcoord + "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n",
               first + "3 0 1 2 " + other + "\n" + first));
    CHECK(geometry_of(model).indices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 0, 1, 2});
  }
}

TEST_CASE("PLY: a vertex that is not there is none that a corner got for itself", "[unit][ply]") {
  Model const model = import_text(square(texcoord, "3 0 1 2 6 0 0 0 0 0 0\n3 0 1 2 6 1 1 1 1 1 1\n3 0 1 4 0\n"));
  CHECK_THAT(placed_message_lines(model.diagnostics),
             contains_text("1 triangle left out: it has a vertex that is not there"));
  CHECK(geometry_of(model).triangle_count() == 2);
}

TEST_CASE("PLY: polygons that are cut keep the texture coordinates of their corners", "[unit][ply]") {
  // An arrow head, whose reflex corner a fan from the first would cross; u and v are x and y.
  Model const model = import_text(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "1 0 0\n0.5 0.25 0\n0 0 0\n0.5 1 0\n4 2 1 0 3 8 0 0 0.5 0.25 1 0 0.5 1\n");
  MeshGeometry const& g = geometry_of(model);
  REQUIRE(g.indices.size() == 6);
  CHECK(g.positions.size() == 4);
  for (std::size_t i = 0; i < 6; ++i) {
    Float3 const position = at(g, g.positions, i);
    CHECK(at(g, g.texcoords[0], i) == Float2{position[0], 1 - position[1]});
  }
}

TEST_CASE("PLY: a list of texture coordinates that does not fit leaves the vertices' own, or 0 0", "[unit][ply]") {
  std::string const faces = "3 0 1 2 5 .5 .5 .5 .5 .5\n3 0 2 3 0\n3 0 2 3 7 1 1 1 1 1 1 1\n3 0 1 3 6 1 1 0.5 0.5 1 1\n";
  Model const model = import_text(square(texcoord, faces));
  CHECK_THAT(placed_message_lines(model.diagnostics),
             contains_text("15:23: face 0 has 5 texture coordinates for 3 corners: left out, as all of"));
  CHECK(model.diagnostics.size() == 1);
  MeshGeometry const& g = geometry_of(model);
  for (std::size_t corner : {1u, 3u, 6u}) CHECK(at(g, g.texcoords[0], corner) == Float2{0, 0});
  CHECK(at(g, g.texcoords[0], 10) == Float2{0.5f, 0.5f});

  std::string text = square(texcoord, faces);
  text.replace(text.find("property float z"), 16, "property float z\nproperty float s\nproperty float t");
  text.replace(text.find("0 0 0\n1 0 0\n1 1 0\n0 1 0"), 23, "0 0 0 .5 1\n1 0 0 .25 0\n1 1 0 0 0\n0 1 0 0 0");
  Model const with_own = import_text(text);
  MeshGeometry const& own = geometry_of(with_own);
  CHECK(at(own, own.texcoords[0], 0) == Float2{0.5f, 0});
  CHECK(at(own, own.texcoords[0], 1) == Float2{0.25f, 1});
  CHECK(at(own, own.texcoords[0], 10) == Float2{0.5f, 0.5f});
}

TEST_CASE("PLY: faces have colors, which count more than those of vertices", "[unit][ply]") {
  // A quadrangle of one color is cut and needs four vertices; its neighbour has its own.
  std::string text = square("property ushort red\nproperty ushort green\nproperty ushort blue\nproperty uchar alpha\n",
                            "4 0 1 2 3 65535 0 0 255\n3 0 1 2 0 65535 0 51\n");
  text.replace(text.find("property float z"), 16,
               "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue");
  text.replace(text.find("0 0 0\n1 0 0\n1 1 0\n0 1 0"), 23, "0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n0 1 0 9 9 9");
  Model const model = import_text(text);
  CHECK(placed_message_lines(model.diagnostics) == "");
  MeshGeometry const& g = geometry_of(model);
  CHECK(g.indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 5, 6});
  CHECK(g.positions.size() == 7);
  CHECK(g.positions[5] == Float3{1, 0, 0});
  CHECK(g.colors[3] == Float4{1, 0, 0, 1});
  CHECK(g.colors[4] == Float4{0, 1, 0, 0.2f});
  CHECK(g.texcoords.empty());
  REQUIRE(mesh_of(model).material()->pbr());
  CHECK(mesh_of(model).material()->pbr()->base_color == Rgb(1));
}

TEST_CASE("PLY: strips beside faces with attributes have the vertices' own", "[unit][ply]") {
  std::string const faces =
      "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string const strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  for (bool const strips_first : {false, true}) {
    std::string const face = "3 1 2 3 6 1 0 1 0 1 0 0 0 0\n";
    std::string const strip = "3 0 1 2\n";
    Model const model = import_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
        (strips_first ? strips + faces : faces + strips) +
        "end_header\n0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 255 0 0\n" +
        (strips_first ? strip + face : face + strip));
    CHECK(placed_message_lines(model.diagnostics) == "");
    MeshGeometry const& g = geometry_of(model);
    REQUIRE(g.indices.size() == 6);
    std::size_t const of_face = strips_first ? 3 : 0;
    CHECK(at(g, g.texcoords[0], of_face) == Float2{1, 1});
    CHECK(at(g, g.colors, of_face) == Float4{0, 0, 0, 1});
    CHECK(at(g, g.texcoords[0], 3 - of_face) == Float2{0, 0});
    CHECK(at(g, g.colors, 3 - of_face) == Float4{1, 0, 0, 1});
  }
}

TEST_CASE("PLY: faces show one of several pictures, by its number", "[unit][ply]") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  folder.write("a.png", one_pixel(10));
  folder.write("sub/b c.png", one_pixel(20));
  std::string const comments =
      "comment TextureFile a.png\ncomment TextureFile sub\\b c.png \ncomment TextureFile never shown.png\n";
  std::string const properties =
      texcoord + "property int texnumber\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string const faces =
      "3 0 1 2 6 0 0 1 0 1 1 1 0 255 0\n3 0 2 3 6 0 0 1 0 1 1 0 0 255 0\n"
      "3 0 1 3 6 0 0 1 0 1 1 -1 0 255 0\n3 1 2 3 6 0 0 1 0 1 1 3 0 255 0\n3 1 2 9 6 0 0 1 0 1 1 1 0 255 0\n";
  auto const import_from = [&](std::string const& text, ModelOptions const& options = {}) {
    return import_ply_bytes(text, "m.ply", folder.path(), options);
  };
  Model const model = import_from(square(properties, faces, comments));
  CHECK(placed_message_lines(model.diagnostics) == "0:0: 1 triangle left out: it has a vertex that is not there\n");
  auto const picture = [&](std::string const& mesh) {
    return mesh_of(model, mesh).material()->pbr()->base_color_texture.texture;
  };
  REQUIRE(picture("mesh"));
  CHECK(picture("mesh")->image->rgba[0] == 10);
  CHECK(mesh_of(model, "mesh").material()->name() == "a.png");
  CHECK(mesh_of(model, "mesh").geometry()->positions.size() == 3);
  CHECK(mesh_of(model, "mesh").geometry()->positions.at(2) == Float3{0, 1, 0});
  CHECK(mesh_of(model, "mesh").geometry()->colors.empty());  // as with colors of vertices
  REQUIRE(picture("mesh#2"));
  CHECK(picture("mesh#2")->image->rgba[0] == 20);
  CHECK(mesh_of(model, "mesh#2").geometry()->triangle_count() == 1);
  CHECK_FALSE(picture("mesh#3"));
  CHECK(mesh_of(model, "mesh#3").geometry()->triangle_count() == 2);
  CHECK(mesh_of(model, "mesh#3").geometry()->colors.at(0) == Float4{0, 1, 0, 1});

  SECTION("a picture that is named twice is read once") {
    Model const twice =
        import_from(square(properties, faces, "comment TextureFile a.png\ncomment TextureFile a.png\n"));
    auto const& first = mesh_of(twice, "mesh").material()->pbr()->base_color_texture.texture;
    auto const& second = mesh_of(twice, "mesh#2").material()->pbr()->base_color_texture.texture;
    REQUIRE((first && second));
    CHECK(first->image == second->image);
  }
  SECTION("strips show none, whatever a picture is called") {
    folder.write("default", one_pixel(30));
    std::string text = square(properties, "3 0 1 2 6 0 0 1 0 1 1 0 0 255 0\n",
                              "comment TextureFile default\ncomment TextureFile b.png\n");
    text.replace(text.find("end_header"), 10, "element tristrips 1\nproperty list int int vertex_indices\nend_header");
    Model const beside = import_from(text + "4 0 1 2 3\n");
    CHECK(mesh_of(beside).material()->pbr()->base_color_texture);
    CHECK(mesh_of(beside).material()->name() == "default#2");
    CHECK(mesh_of(beside, "mesh#2").geometry()->triangle_count() == 2);
    CHECK(mesh_of(beside, "mesh#2").material()->name() == "default");
  }
  SECTION("vertices' own colors do not count beside a picture") {
    Model const scan = import_from(
        "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 9 9 9\n1 0 0 1 0 9 9 9\n0 1 0 0 1 9 9 9\n3 0 1 2\n");
    CHECK(mesh_of(scan).material()->pbr()->base_color_texture);
    CHECK(geometry_of(scan).colors.empty());
  }
  SECTION("without a number the first counts, and this is told") {
    Model const first = import_from(square(texcoord, "3 0 1 2 6 0 0 1 0 1 1\n", comments));
    CHECK(placed_message_lines(first.diagnostics) ==
          "0:0: pictures are left out: all but 'a.png', the first of 3, as the faces have no texnumber\n");
    CHECK(mesh_of(first).material()->pbr()->base_color_texture.texture->image->rgba[0] == 10);
  }
  SECTION("a single picture is shown whatever the number") {
    Model const single =
        import_from(square(properties, faces.substr(0, faces.find('\n') + 1), "comment TextureFile a.png\n"));
    CHECK(placed_message_lines(single.diagnostics) == "");
    CHECK(mesh_of(single).material()->pbr()->base_color_texture);
  }
  SECTION("a picture that is not there leaves the colors of the faces") {
    Model const without =
        import_from(square(properties, faces.substr(0, faces.find('\n') + 1), "comment TextureFile no.png\n"));
    CHECK_THAT(placed_message_lines(without.diagnostics), contains_text("the picture is left out"));
    CHECK(geometry_of(without).colors.at(0) == Float4{0, 1, 0, 1});
  }
  SECTION("a material for everything needs no pictures") {
    ModelOptions options;
    options.material = std::make_shared<Material>("mine", PhongModel{});
    options.on_read = [](std::filesystem::path const&) { FAIL("a picture was read"); };
    Model const whole = import_from(square(properties, faces, comments), options);
    CHECK(geometry_of(whole).triangle_count() == 4);
    CHECK(mesh_of(whole).material()->name() == "mine");
  }
}

TEST_CASE("PLY: properties of faces have names in any case", "[unit][ply]") {
  std::string text = square("property list uchar float TexCoord\n", "3 0 1 2 6 1 0 1 0 1 0\n");
  text.replace(text.find("vertex_indices"), 14, "Vertex_Indices");
  Model const model = import_text(text);
  CHECK(geometry_of(model).texcoords.at(0).at(0) == Float2{1, 1});
}

TEST_CASE("PLY: attributes of faces may be anything", "[unit][ply]") {
  CHECK_THAT(
      placed_message_lines(
          import_text(square("property list int float texcoord\n", "3 0 1 2 6 0 0 1 0 1 1\n3 0 1 2 2000000000 1\n"))
              .diagnostics),
      contains_text("16:9: a list declares 2000000000 numbers") && contains_text("the data ends in face 1 of 2"));
  Model const strange = import_text(square(texcoord + "property float red\nproperty float green\nproperty float blue\n",
                                           "3 0 1 2 6 nan 0 1e60 0 x 1 nan 1 2\n3 0 1 -1 6 0 0 0 0 0 0 0 0 0\n"));
  MeshGeometry const& g = geometry_of(strange);
  CHECK(g.triangle_count() == 1);
  for (Float2 const& uv : g.texcoords.at(0)) CHECK((std::isfinite(uv[0]) && std::isfinite(uv[1])));
  CHECK(g.colors.at(0)[0] == 0);

  // A property may be there twice: the last counts.
  std::string const twice = "property list uchar int vertex_index\n" + texcoord + texcoord;
  Model const last = import_text(square(twice, "3 0 1 2 3 1 2 3 6 1 1 1 1 1 1 6 0 1 0 1 0 1\n"));
  CHECK(geometry_of(last).positions.at(0) == Float3{1, 0, 0});
  CHECK(geometry_of(last).texcoords.at(0).at(0) == Float2{0, 0});
}
