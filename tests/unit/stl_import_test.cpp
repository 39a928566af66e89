#include "lichtraum/stl.hpp"

#include <cstring>
#include <limits>

#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/gltf_triangles.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using testing::Corners;
using testing::world_triangles;

namespace {

Model import_bytes(std::string const& bytes) { return import_stl_bytes(bytes, "m.stl"); }

std::string warnings(std::string const& bytes) { return placed_message_lines(import_bytes(bytes).diagnostics); }

std::string error_of(std::string const& bytes) {
  try {
    import_bytes(bytes);
  } catch (SceneError const& error) {
    return placed_message_lines(error.diagnostics());
  }
  return "no error";
}

MeshGeometry const& geometry_of(Scene const& scene, std::string_view name) {
  return *dynamic_cast<Mesh const&>(**scene.shapes.find(name)).geometry();
}

std::string const facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
std::string const other_facet =
    "facet normal 0 0 1\n outer loop\n  vertex -0 1 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\n";

using Facet = std::array<float, 12>;
Facet const binary_facet = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0};

void append(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(char(value >> 8 * i & 0xFF));
}

std::string binary(std::uint32_t declared, std::vector<Facet> const& facets, std::string header = "") {
  header.resize(80);
  append(header, declared);
  for (Facet const& numbers : facets) {
    for (float const number : numbers) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      append(header, bits);
    }
    header += "\xFF\xFF";  // attributes
  }
  return header;
}

}  // namespace

TEST_CASE("STL: facets in ASCII, in any case, however lines are broken", "[unit][stl]") {
  std::string const text = "solid a name\n" + facet + other_facet + "endsolid a name\n";
  std::string upper = text, one_line = text, old_mac = text, windows;
  for (char& c : upper) c = char(std::toupper(c));
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  for (char& c : old_mac) c = c == '\n' ? '\r' : c;
  for (char const c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c == ' ' ? '\t' : c);
  for (std::string const& bytes : {text, upper, one_line, old_mac, windows, "\xEF\xBB\xBF\n " + text}) {
    INFO(bytes);
    Model const model = import_bytes(bytes);
    CHECK(placed_message_lines(model.diagnostics) == "");
    auto const triangles = world_triangles(model.scene);
    REQUIRE(triangles.size() == 2);
    CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(triangles[1] == Corners{Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)});
    CHECK(model.scene.shapes.contains(bytes == upper ? "A NAME" : "a name"));
    CHECK(model.scene.cameras.size() == 1);
  }
}

TEST_CASE("STL: corners at the same place are one vertex, and shade flat", "[unit][stl]") {
  Facet const second = {0, 0, 0, -0.0f, 1, 0, 1, 0, -0.0f, 1, 1, 0};
  for (std::string const& bytes :
       {"solid mesh\n" + facet + other_facet + "endsolid\n", binary(2, {binary_facet, second})}) {
    Model const model = import_bytes(bytes);
    MeshGeometry const& g = geometry_of(model.scene, "mesh");
    CHECK(g.positions == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    CHECK(g.indices == std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3});
    CHECK(g.normals.empty());
  }
}

TEST_CASE("STL: each solid is a mesh, those without facets are none", "[unit][stl]") {
  std::string const names = "solid Solid\n" + facet + "endsolid Solid\nsolid empty\nendsolid empty\nsolid\n" + facet +
                            "endsolid\nsolid facet\n" + facet + "endsolid facet\n";
  std::string one_line = names;
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  for (std::string const& bytes : {names, one_line}) {
    Model const model = import_bytes(bytes);
    CHECK(placed_message_lines(model.diagnostics) == "");
    CHECK(world_triangles(model.scene).size() == 3);
    for (char const* name : {"Solid", "mesh", "facet"}) {
      REQUIRE(model.scene.shapes.contains(name));
      CHECK(geometry_of(model.scene, name).indices.size() == 3);
    }
    CHECK(!model.scene.shapes.contains("empty"));
  }
}

TEST_CASE("STL: a binary file may begin like an ASCII one, and an ASCII one have odd normals", "[unit][stl]") {
  for (std::string const header : {"", "solid cube", "solid facet normal 0 0 1"}) {
    Model const model = import_bytes(binary(1, {binary_facet}, header));
    CHECK(placed_message_lines(model.diagnostics) == "");
    CHECK(world_triangles(model.scene)[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  }
  // Filled with blanks there is a NUL in the count only, and in a file that is cut short.
  std::string blank = binary(2, {binary_facet}, "solid" + std::string(75, ' '));
  CHECK(warnings(blank) == "0:0: byte 134: the data ends in facet 1 of 2\n");
  for (std::string const normal : {"facet normal nan nan nan", "facet normal", "facet normal -1.#IND 0 0"}) {
    std::string text = "solid\n" + facet + "endsolid\n";
    text.replace(text.find("facet normal 0 0 1"), 18, normal);
    CHECK(warnings(text) == "");
  }
}

TEST_CASE("STL: faults of binary files are told with their byte; what is whole is drawn", "[unit][stl]") {
  std::string const two = binary(2, {binary_facet, binary_facet});
  CHECK(warnings(two.substr(0, two.size() - 1)) == "0:0: byte 183: the data ends in facet 1 of 2\n");
  CHECK(warnings(binary(0xFFFFFFFF, {binary_facet})) == "0:0: byte 134: the data ends in facet 1 of 4294967295\n");
  CHECK(warnings(binary(1, {binary_facet, binary_facet})) ==
        "0:0: byte 134: 50 bytes follow the last facet that the file declares (1): left out\n");
  Facet faulty = binary_facet;
  faulty[11] = std::numeric_limits<float>::quiet_NaN();
  CHECK(warnings(binary(3, {binary_facet, faulty, faulty})) ==
        "0:0: byte 134: 2 triangles left out: they have a vertex that is not finite\n");
  faulty[11] = -std::numeric_limits<float>::infinity();
  CHECK(error_of(binary(1, {faulty})) ==
        "0:0: byte 84: 1 triangle left out: it has a vertex that is not finite\n"
        "0:0: the model has nothing to draw: it has no triangles\n");
  CHECK(error_of(binary(0, {})) == "0:0: the model has nothing to draw: it has no triangles\n");
  CHECK_THAT(error_of(binary(0, {binary_facet})),
             contains_text("byte 84: 50 bytes follow the last facet that the file declares (0)"));
  CHECK(error_of(two.substr(0, 83)) == "0:0: byte 83: the file ends in the header, which has 84 bytes\n");
}

TEST_CASE("STL: faults of ASCII files are told with their line; what is whole is drawn", "[unit][stl]") {
  auto const with = [](std::string const& from, std::string const& to) {
    std::string faulty = facet;
    faulty.replace(faulty.find(from), from.size(), to);
    return "solid\n" + facet + faulty + facet + "endsolid\n";
  };
  auto const check = [&](std::string const& bytes, std::string const& expected) {
    Model const model = import_bytes(bytes);
    CHECK(placed_message_lines(model.diagnostics) == expected);
    CHECK(world_triangles(model.scene).size() == 2);
  };
  check(with("vertex 1", "vertex nan"), "12:10: 'nan' is not a finite number\n");
  check(with("vertex 1", "vertex 1e99"), "12:10: '1e99' is too large\n");
  check(with("vertex 1 0", "vertex 1"), "13:3: 'vertex' is not a number\n");
  check(with("vertex 1", "vertx 1"), "12:3: expected 'vertex', found 'vertx'\n");
  check(with("  vertex 0 0 0\n", ""), "13:2: expected 'vertex', found 'endloop'\n");
  check(with("facet", "face"), "9:1: expected 'facet', found 'face'\n");
  check(with("outer", "inner"), "10:2: expected 'outer', found 'inner'\n");
  check(with("endfacet", ""), "16:1: expected 'endfacet', found 'facet'\n");
  CHECK(warnings("solid\n" + facet) == "8:9: the file ends where 'endsolid' is missing\n");
  CHECK(warnings("solid\n" + facet + "facet normal 0 0 1 outer\n") == "9:25: the file ends where 'loop' is missing\n");
  CHECK(warnings("solid\n" + facet + "endsolid\nwhat is this\n") == "10:1: expected 'solid', found 'what'\n");
  CHECK(error_of("") == "0:0: this is not an STL file: it does not begin with 'solid'\n");
  CHECK(error_of("PK\3\4" + std::string(100, '\0')) ==
        "0:0: this is a ZIP archive or an office document, not an STL file\n");
  CHECK(error_of("ply\n") == "1:1: this is not an STL file: it does not begin with 'solid'\n");
  CHECK(error_of("solid a\nendsolid a\n") == "0:0: the model has nothing to draw: it has no triangles\n");
  CHECK_THAT(error_of("solid\nfacet normal 0 0 1 outer loop vertex 1 2"), contains_text("2:41: the file ends where"));
}

TEST_CASE("STL: thousands of faults are told a hundred times", "[unit][stl]") {
  std::string text = "solid\n" + facet;
  for (int i = 0; i < 5000; ++i) text += "facet normal 0 0 1\nouter loop\nvertex x\n";
  CHECK(import_bytes(text + "endsolid\n").diagnostics.size() == 101);
}
