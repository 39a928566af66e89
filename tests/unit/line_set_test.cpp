#include <cmath>
#include <limits>

#include "compile/scene_buffers.hpp"
#include "lichtraum/graph_summary.hpp"
#include "lichtraum/ply.hpp"
#include "scene/flatten.hpp"
#include "scene/mesh_point.hpp"
#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/gltf_import.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using testing::GltfWriter;

namespace {

using Lines = std::vector<std::uint32_t>;

/// `vertices`: "x y z red green blue" a line; `edge_properties` come after vertex1 and vertex2.
Model import_edges(std::string const& vertices, std::size_t vertex_count, std::string const& edges,
                   std::size_t edge_count, std::string const& edge_properties = {}, ModelOptions const& options = {}) {
  return import_ply_bytes("ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertex_count) +
                              "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                              "property uchar green\nproperty uchar blue\nelement edge " +
                              std::to_string(edge_count) + "\nproperty int vertex1\nproperty int vertex2\n" +
                              edge_properties + "end_header\n" + vertices + edges,
                          "edges.ply", ".", options);
}

LineSet const& lines_of(Scene const& scene, char const* name) {
  return dynamic_cast<LineSet const&>(**scene.shapes.find(name));
}

std::shared_ptr<MeshGeometry> corner() {  // from red along x to green, and on along y to blue
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
  geometry->colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  geometry->lines = {0, 1, 1, 2};
  return geometry;
}

std::shared_ptr<Material const> white() { return std::make_shared<Material>("white", PbrModel()); }

}  // namespace

TEST_CASE("PLY: edges without faces are lines with their vertices' colours", "[unit][ply][lines]") {
  Model const model = import_edges("0 0 0 255 0 0\n3 4 0 0 255 0\n9 9 9 0 0 255\n", 3, "0 1\n", 1);
  CHECK(message_lines(model.diagnostics) == "");
  LineSet const& set = lines_of(model.scene, "lines");
  CHECK(set.geometry()->lines == Lines{0, 1});
  CHECK(set.geometry()->colors[1] == Float4{0, 1, 0, 1});
  CHECK(set.ends() == Lines{0, 1});  // a vertex without an edge is neither drawn nor framed
  CHECK(2 * set.radius() == Approx(5 * 0.004));
  CHECK(set.bounds().max.y == Approx(4 + set.radius()));
}

TEST_CASE("PLY: edges may have colours of their own", "[unit][ply][lines]") {
  Model const model =
      import_edges("0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n", 3, "0 1 255 0 0\n1 2 0 255 0\n7 2 0 0 0\n", 3,
                   "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  CHECK(message_lines(model.diagnostics) == "1 line left out: it has a vertex that is not there\n");
  MeshGeometry const& geometry = *lines_of(model.scene, "lines").geometry();
  REQUIRE(geometry.lines.size() == 4);
  Float4 const red{1, 0, 0, 1}, green{0, 1, 0, 1};
  CHECK(geometry.positions[geometry.lines[1]] == Float3{1, 0, 0});
  CHECK(geometry.positions[geometry.lines[2]] == Float3{1, 0, 0});
  CHECK(geometry.colors[geometry.lines[0]] == red);
  CHECK(geometry.colors[geometry.lines[1]] == red);
  CHECK(geometry.colors[geometry.lines[2]] == green);
  CHECK(geometry.colors[geometry.lines[3]] == green);
}

TEST_CASE("PLY: edges that cannot be drawn are told of, and those beside faces are left out", "[unit][ply][lines]") {
  Model const model = import_edges("0 0 0 1 2 3\n1e39 4 0 1 2 3\n1 0 0 1 2 3\n", 3, "0 1\n0 2\n-1 2\n0 3\n", 5);
  CHECK_THAT(message_lines(model.diagnostics),
             contains_text("2 lines left out: they have a vertex that is not there") &&
                 contains_text("1 line left out: it has a vertex that is not finite") &&
                 contains_text("the data ends in edge 4 of 5"));
  CHECK(lines_of(model.scene, "lines").geometry()->lines == Lines{0, 2});
  CHECK_THROWS_AS(import_edges("0 0 0 1 2 3\n", 1, "0 7\n", 1), SceneError);

  Model const solid = import_ply_bytes(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 1 1 2 3\n3 0 1 2\n",
      "solid.ply", ".", {});
  CHECK((*solid.scene.shapes.find("mesh"))->kind() == ShapeKind::mesh);
}

TEST_CASE("glTF: lists, loops and strips of lines", "[unit][gltf][lines]") {
  std::vector<float> const square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  struct Case {
    int mode;
    Lines expected;
  };
  for (auto const& [mode, expected] :
       {Case{1, {0, 1, 2, 3}}, Case{2, {0, 1, 1, 2, 2, 3, 3, 0}}, Case{3, {0, 1, 1, 2, 2, 3}}}) {
    INFO("mode " << mode);
    GltfWriter writer;
    writer.add_mesh(square)["mode"] = mode;
    Model const model = testing::import_model(writer);
    CHECK(message_lines(model.diagnostics) == "");
    CHECK(lines_of(model.scene, "mesh_0").geometry()->lines == expected);
  }
}

TEST_CASE("glTF: faulty lines are left out, and lines below a scaled node have the model's size",
          "[unit][gltf][lines]") {
  float const nan = std::numeric_limits<float>::quiet_NaN();
  GltfWriter writer;
  auto& primitive = writer.add_mesh({0, 0, 0, 1, 0, 0, nan, 0, 0, 0, 9, 0});
  primitive["mode"] = 1;
  primitive["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{0, 1, 1, 2, 9, 0, 1});
  writer.json["nodes"][0]["scale"] = {4, 4, 4};
  ModelOptions options;
  options.point_size = 100;
  Model const model = testing::import_model(writer, options);
  CHECK(message_lines(model.diagnostics) ==
        "/meshes/0/primitives/0/indices: 1 line left out: it has an index that is out of range (4)\n"
        "/meshes/0/primitives/0/attributes/POSITION: 1 line left out: it has a vertex that is not finite\n");
  LineSet const& set = lines_of(model.scene, "mesh_0");
  CHECK(set.geometry()->lines == Lines{0, 1});
  CHECK(4 * 2 * set.radius() == Approx(0.1 * 4));

  primitive["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{1});
  writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  CHECK_THAT(message_lines(testing::import_model(writer).diagnostics),
             contains_text("/meshes/0/primitives/0: it holds no line"));
}

TEST_CASE("a line is a cylinder between balls, and its colour goes from end to end", "[unit][lines]") {
  LineSet const set("set", corner(), 0.5, white());
  auto const hit_at = [&](Vec3 const& from, Vec3 const& direction) {
    Hit hit;
    REQUIRE(set.closest_hit({from, direction}, 0, hit));
    return hit;
  };
  Hit const side = hit_at({1, 0, 9}, {0, 0, -2});
  CHECK(side.t == Approx((9 - 0.5) / 2));
  CHECK(side.normal.z == Approx(1));
  CHECK(side.triangle == 0);
  CHECK(MeshPoint(side).color().r == Approx(0.75));
  CHECK(MeshPoint(side).color().g == Approx(0.25));
  Hit const end = hit_at({-0.3, 0, 9}, {0, 0, -1});  // on the ball, not on the cylinder's flat end
  CHECK(end.t == Approx(9 - 0.4));
  CHECK(MeshPoint(end).color().r == 1);
  Hit const second = hit_at({4, 3, 9}, {0, 0, -1});
  CHECK(second.triangle == 1);
  CHECK(MeshPoint(second).color().b == Approx(0.75));
  Hit missed;
  CHECK_FALSE(set.closest_hit({{2, 2, 9}, {0, 0, -1}}, 0, missed));

  GraphSummary const summary = summarise({std::make_shared<LineSet>("set", corner(), 0.5, white())});
  CHECK(summary.drawn.lines == 2);
  CHECK(summary.drawn.primitives() == 2 + 3);
  CHECK(summary.bounds.max == Vec3(4.5, 4.5, 0.5));
}

TEST_CASE("lines that cannot be are refused", "[unit][lines]") {
  auto const refuses = [](auto const& change) {
    auto geometry = corner();
    change(*geometry);
    CHECK_THROWS_AS(LineSet("set", geometry, 0.5, white()), std::invalid_argument);
  };
  refuses([](MeshGeometry& g) { g.lines.push_back(0); });
  refuses([](MeshGeometry& g) { g.lines[3] = 3; });
  refuses([](MeshGeometry& g) { g.colors.pop_back(); });
  CHECK_THROWS_AS(LineSet("set", nullptr, 0.5, white()), std::invalid_argument);
  for (double const radius : {0.0, -1.0, double(INFINITY), double(NAN)}) {
    CHECK_THROWS_AS(LineSet("set", corner(), radius, white()), std::invalid_argument);
  }
}

TEST_CASE("each cylinder of a line set has the colours of its ends, behind cylinders without",
          "[unit][compile][lines]") {
  auto const plain = std::make_shared<Cylinder>("plain", Vec3(0, 9, 0), Vec3(1, 9, 0), 1, nullptr);
  auto geometry = corner();
  geometry->lines.insert(geometry->lines.begin(), {1, 1});  // of no length: a ball
  auto const set = std::make_shared<LineSet>("set", geometry, 0.5, white());
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    SceneBuffers const buffers = compile_scene(flatten({plain, set}), {}, layout);
    REQUIRE(buffers.cylinders.size() == 3);
    REQUIRE(buffers.cylinder_colors.size() == 3);
    std::size_t colored = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      device::uint const first = buffers.cylinder_colors[i];
      if (first == 0) continue;
      ++colored;
      float const* const ends = buffers.vertex_data.data() + first - 1;
      // The first ends red and green, the second green and blue.
      CHECK((ends[0] == 1 ? ends[5] : ends[1]) == 1);
      CHECK((ends[0] == 1 ? ends[4] : ends[6]) == (ends[0] == 1 ? 0 : 1));
    }
    CHECK(colored == 2);
  }
}
