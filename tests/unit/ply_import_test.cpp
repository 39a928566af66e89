#include "lichtraum/ply.hpp"

#include <algorithm>
#include <cstring>

#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/gltf_triangles.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using testing::Corners;
using testing::world_triangles;

namespace {

Model import_bytes(std::string const& bytes, ModelOptions const& options = {}) {
  return import_ply_bytes(bytes, "m.ply", ".", options);
}

std::string error_of(std::string const& bytes) {
  try {
    import_bytes(bytes);
  } catch (SceneError const& error) {
    return placed_message_lines(error.diagnostics());
  }
  return "no error";
}

MeshGeometry const& geometry_of(Scene const& scene) {
  return *dynamic_cast<Mesh const&>(**scene.shapes.find("mesh")).geometry();
}

std::string const vertex_header = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
std::string const face_header = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
std::string const ascii = "ply\nformat ascii 1.0\n" + vertex_header + face_header;

template <class T>
void append(std::string& out, T value, bool is_big_endian) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (is_big_endian) std::reverse(bytes, bytes + sizeof value);
  out.append(bytes, sizeof value);
}

}  // namespace

TEST_CASE("PLY: a triangle in ASCII, however its lines are broken", "[unit][ply]") {
  for (std::string const& data :
       {std::string("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), std::string("0 0 0 1 0\n\n0 0 1 0 3\n0 1 2"),
        std::string("0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n")}) {
    Model const model = import_bytes(ascii + data);
    CHECK(placed_message_lines(model.diagnostics) == "");
    auto const triangles = world_triangles(model.scene);
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(model.scene.cameras.size() == 1);
  }
}

TEST_CASE("PLY: binary of either byte order, every type, other elements and lists between", "[unit][ply]") {
  for (bool const big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\r\n" +
                        "comment made by hand\nobj_info none\n"
                        "element other 2\nproperty list ushort double weights\nproperty char c\n"
                        "element vertex 4\nproperty double x\nproperty short y\nproperty list uchar int rest\n"
                        "property uint z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                        "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
                        "element face 1\nproperty uchar flags\nproperty list int ushort vertex_index\nend_header\n";
    for (int i = 0; i < 2; ++i) {
      append(bytes, std::uint16_t(i), big);
      for (int k = 0; k < i; ++k) append(bytes, 1.0, big);
      append(bytes, std::int8_t(-1), big);
    }
    double const x[] = {0, 1, 1, 0};
    std::int16_t const y[] = {-300, -300, 300, 300};
    for (int i = 0; i < 4; ++i) {
      append(bytes, x[i], big);
      append(bytes, y[i], big);
      append(bytes, std::uint8_t(1), big);
      append(bytes, std::int32_t(5), big);
      append(bytes, std::uint32_t(70000), big);
      for (int c = 0; c < 3; ++c) append(bytes, std::uint8_t(c == 0 ? 255 : c == 1 ? 188 : 0), big);
      for (float n : {0.0f, 0.0f, 2.0f}) append(bytes, n, big);
      for (float t : {0.25f, 0.25f}) append(bytes, t, big);
    }
    append(bytes, std::uint8_t(0), big);
    append(bytes, std::int32_t(4), big);
    for (int i = 0; i < 4; ++i) append(bytes, std::uint16_t(i), big);

    Model const model = import_bytes(bytes);
    CHECK(placed_message_lines(model.diagnostics) == "");
    MeshGeometry const& g = geometry_of(model.scene);
    REQUIRE(g.positions.size() == 4);
    CHECK(g.positions[2] == Float3{1, 300, 70000});
    CHECK(g.indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    CHECK(g.normals[1] == Float3{0, 0, 1});
    CHECK(g.texcoords[0][3] == Float2{0.25f, 0.75f});
    CHECK(g.colors[0][0] == 1);
    CHECK(g.colors[0][1] == Approx(0.5028865));  // 188 / 255, IEC 61966-2-1
    CHECK(g.colors[0][3] == 1);
  }
}

TEST_CASE("PLY: strips, with a negative number between two", "[unit][ply]") {
  Model const model = import_bytes(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  CHECK(geometry_of(model.scene).indices == std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 0, 1, 2});
}

TEST_CASE("PLY: faults of the header are errors at their place", "[unit][ply]") {
  CHECK(error_of("") == "0:0: the header has no end: end_header is missing\n");
  CHECK(error_of("version https://git-lfs.github.com/spec/v1\n") == "0:0: this is a Git LFS pointer, not a PLY file\n");
  CHECK(error_of("solid\n") == "1:1: this is not a PLY file: it does not begin with 'ply'\n");
  CHECK(error_of("ply\nformat ascii 1.0\n") == "0:0: the header has no end: end_header is missing\n");
  CHECK(error_of("ply\nelement vertex 1\nend_header\n") == "3:1: the format is missing\n");
  CHECK(error_of("ply\nformat weird 1.0\n") ==
        "2:8: format: expected ascii, binary_little_endian or binary_big_endian, found 'weird'\n");
  CHECK(error_of("ply\nelement vertex -1\n") == "2:16: element: expected a name and a number, found '-1'\n");
  CHECK(error_of("ply\nformat ascii 1.0\n" + vertex_header + vertex_header) ==
        "7:9: the element 'vertex' is there twice\n");
  CHECK(error_of("ply\nproperty float x\n") == "2:1: a property before the first element\n");
  CHECK(error_of("ply\nelement a 1\nproperty half x\n") == "3:10: PLY has no type 'half'\n");
  CHECK(error_of("ply\nelement a 1\nproperty list float int x\n") ==
        "3:15: 'float' is not a type that can count the elements of a list\n");
  CHECK(error_of("ply\nwibble\n") == "2:1: unknown keyword in a PLY header: 'wibble'\n");
}

TEST_CASE("PLY: faults of the data are told with their place; what is whole is drawn", "[unit][ply]") {
  std::string const vertices = "0 0 0\n1 0 0\n0 1 0\n";
  auto const warnings = [&](std::string const& faces, int count) {
    std::string text = ascii + vertices + faces;
    text.replace(text.find("face 1"), 6, "face " + std::to_string(count));
    return placed_message_lines(import_bytes(text).diagnostics);
  };
  CHECK(warnings("3 0 1 2\n3 0 1 9\n", 2) == "0:0: 1 triangle left out: it has a vertex that is not there\n");
  CHECK(warnings("3 0 1 2\n3 0 1 -7\n", 2) == "0:0: 1 triangle left out: it has a vertex that is not there\n");
  CHECK(warnings("3 0 1 2\n3 0 1 x\n", 2) ==
        "0:0: 1 triangle left out: it has a vertex that is not there\n14:7: 'x' is not a number\n");
  CHECK_THAT(warnings("3 0 1 2\n3 0 1\n", 2), contains_text("the data ends in face 1 of 2"));
  CHECK_THAT(warnings("3 0 1 2\n999999 0 1\n", 2), contains_text("14:1: a list declares 999999 numbers"));
  CHECK_THAT(warnings("3 0 1 2\n2 0 1\n", 2), contains_text("face 1 has 2 corners"));
  CHECK_THAT(error_of(ascii + "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n"),
             contains_text("0:0: 1 triangle left out") && contains_text("it has no triangles"));

  std::string binary = "ply\nformat binary_little_endian 1.0\n" + vertex_header + face_header;
  std::size_t const data = binary.size();
  for (float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f}) append(binary, v, false);
  CHECK_THAT(error_of(binary), contains_text("byte " + std::to_string(data + 28) + ": the data ends in vertex 2 of 3"));
}

TEST_CASE("PLY: points that were not measured are counted, not told one by one", "[unit][ply]") {
  std::string const header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float quality\nend_header\n";
  CHECK(placed_message_lines(
            import_bytes(header + "0 0 0 1\nnan nan nan nan\n1 0 0 inf\nNaN -nan nan 0\n").diagnostics) ==
        "0:0: points that are not finite are left out: 2\n");
}

TEST_CASE("PLY: a header may promise anything", "[unit][ply]") {
  for (char const* format : {"ascii", "binary_little_endian"}) {
    for (char const* count : {"4294967295", "18446744073709551615"}) {
      std::string const start = std::string("ply\nformat ") + format + " 1.0\nelement vertex " + count +
                                "\nproperty float x\nproperty float y\nproperty float z\n";
      std::string const data = format == std::string("ascii") ? "1 2 3\n" : "123456789abc1";
      CHECK_THAT(placed_message_lines(import_bytes(start + "end_header\n" + data).diagnostics),
                 contains_text("the data ends in vertex 1 of"));
      CHECK_THAT(error_of(start + "end_header\n1 2\n"), contains_text("the data ends in vertex 0 of"));
      CHECK_THAT(error_of(std::string("ply\nformat ") + format + " 1.0\nelement nothing " + count + "\nend_header\n"),
                 contains_text("it has no triangles"));
      CHECK_THAT(error_of(std::string("ply\nformat ") + format + " 1.0\nelement a " + count +
                          "\nproperty list uchar int b\nend_header\n"),
                 contains_text("the data ends in a 0"));
    }
  }
}

TEST_CASE("PLY: lines of the header may end with CR alone, as old Macs write them", "[unit][ply]") {
  std::string text = ascii + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ranges::replace(text, '\n', '\r');
  std::vector<Corners> const expected = {{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
  CHECK(world_triangles(import_bytes(text).scene) == expected);

  std::string binary = "ply\nformat binary_little_endian 1.0\n" + vertex_header + face_header;
  std::ranges::replace(binary, '\n', '\r');
  for (float const x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(binary, x, false);
  append(binary, std::uint8_t(3), false);
  for (std::int32_t const i : {0, 1, 2}) append(binary, i, false);
  CHECK(world_triangles(import_bytes(binary).scene) == expected);
}
