#include <cmath>
#include <numbers>

#include "lichtraum/ply.hpp"
#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Model import_ply_text(std::string const& elements, std::string const& data) {
  return import_ply_bytes("ply\nformat ascii 1.0\n" + elements + "end_header\n" + data, "colors.ply", ".", {});
}

std::string vertices(std::size_t count, std::string const& more) {
  return "element vertex " + std::to_string(count) + "\nproperty float x\nproperty float y\nproperty float z\n" + more;
}

std::string const float_colors = "property float red\nproperty float green\nproperty double blue\n";
std::string const splats =
    "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\nproperty float f_rest_0\n"
    "property float opacity\n";

MeshGeometry const& points_of(Model const& model) {
  return *dynamic_cast<PointCloud const&>(**model.scene.shapes.find("points")).geometry();
}

constexpr float linear_of_188 = 0.5028865f;  // of 255, IEC 61966-2-1

}  // namespace

TEST_CASE("PLY: colours that are floats from 0 to 255 or 65535 are read as such", "[unit][ply]") {
  Model const fractions = import_ply_text(vertices(2, float_colors), "0 0 0 1 0.73725490196 0\n1 1 1 0 0 2\n");
  CHECK(message_lines(fractions.diagnostics).empty());
  CHECK(points_of(fractions).colors[0][1] == Approx(linear_of_188));
  CHECK(points_of(fractions).colors[1][2] > 1);

  Model const bytes = import_ply_text(vertices(2, float_colors), "0 0 0 255 188 0\n1 1 1 0 0 1\n");
  CHECK(message_lines(bytes.diagnostics) ==
        "colours go up to 255: read as 0 to 255, though those that are floats go from 0 to 1\n");
  CHECK(points_of(bytes).colors[0][0] == 1);
  CHECK(points_of(bytes).colors[0][1] == Approx(linear_of_188));
  CHECK(points_of(bytes).colors[1][2] == Approx(1 / 255.0 / 12.92));
  CHECK(points_of(bytes).colors[0][3] == 1);

  Model const words = import_ply_text(vertices(1, float_colors), "0 0 0 65535 48316 0\n");
  CHECK(message_lines(words.diagnostics) ==
        "colours go up to 65535: read as 0 to 65535, though those that are floats go from 0 to 1\n");
  CHECK(points_of(words).colors[0][0] == 1);
  CHECK(points_of(words).colors[0][1] == Approx(linear_of_188));
}

TEST_CASE("PLY: so are those of faces and edges", "[unit][ply]") {
  std::string const points = "0 0 0\n1 0 0\n0 1 0\n";
  Model const face =
      import_ply_text(vertices(3, "") + "element face 1\nproperty list uchar int vertex_indices\n" + float_colors,
                      points + "3 0 1 2 255 188 0\n");
  Model const edge =
      import_ply_text(vertices(3, "") + "element edge 1\nproperty int vertex1\nproperty int vertex2\n" + float_colors,
                      points + "0 1 255 188 0\n");
  auto const& mesh = *dynamic_cast<Mesh const&>(**face.scene.shapes.begin()).geometry();
  auto const& lines = *dynamic_cast<LineSet const&>(**edge.scene.shapes.begin()).geometry();
  for (MeshGeometry const* geometry : {&mesh, &lines}) {
    REQUIRE(!geometry->colors.empty());
    CHECK(geometry->colors[0][0] == 1);
    CHECK(geometry->colors[0][1] == Approx(linear_of_188));
  }
}

TEST_CASE("PLY: a model far from the origin may have colours from 0 to 255 as well", "[unit][ply]") {
  Model const model = import_ply_text(vertices(2, float_colors), "100000000 0 0 255 188 0\n100000001 1 1 0 0 1\n");
  CHECK(model.origin.x == Approx(1e8).margin(10));
  CHECK(points_of(model).positions[1][0] - points_of(model).positions[0][0] == 1);
  CHECK(points_of(model).colors[0][1] == Approx(linear_of_188));
}

TEST_CASE("PLY: an alpha of 1 stays one beside colours up to 255", "[unit][ply]") {
  Model const model = import_ply_text(vertices(1, float_colors + "property float alpha\n"), "0 0 0 255 0 0 1\n");
  CHECK(points_of(model).colors[0] == Float4{1, 0, 0, 1});
}

TEST_CASE("PLY: Gaussian splats are points in their mean colours, unless they are faint", "[unit][ply][points]") {
  double const first_harmonic = 1 / (2 * std::sqrt(std::numbers::pi));
  std::string const of_188 = std::to_string((188 / 255.0 - 0.5) / first_harmonic);
  std::string const half = std::to_string(0.5 / first_harmonic);
  Model const model = import_ply_text(vertices(4, splats), "0 0 0 " + half + " " + of_188 + " -" + half +
                                                               " 9 0\n1 0 0 5 -5 0 9 3\n2 0 0 0 0 0 9 -0.1\n"
                                                               "3 0 0 0 0 0 9 nan\n");
  CHECK(message_lines(model.diagnostics) ==
        "Gaussian splats are drawn as points of one size, in their mean colours; left out, as more than half of the "
        "light goes through them: 2\n");
  MeshGeometry const& points = points_of(model);
  REQUIRE(points.positions == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}});
  CHECK(points.colors[0][0] == Approx(1));
  CHECK(points.colors[0][1] == Approx(linear_of_188).epsilon(1e-4));
  CHECK(points.colors[0][2] == Approx(0).margin(1e-5));
  CHECK(points.colors[1][0] == 1);  // what exceeds a colour's range ends there
  CHECK(points.colors[1][1] == 0);
  CHECK(points.colors[1][3] == 1);
}

TEST_CASE("PLY: splats that have colours as others have them show those", "[unit][ply][points]") {
  Model const model =
      import_ply_text(vertices(1, splats + "property uchar red\nproperty uchar green\nproperty uchar blue\n"),
                      "0 0 0 0 0 0 0 -9 255 0 188\n");
  CHECK(message_lines(model.diagnostics).empty());
  REQUIRE(points_of(model).colors.size() == 1);
  CHECK(points_of(model).colors[0][2] == Approx(linear_of_188));
}

TEST_CASE("PLY: vertices of a surface keep their numbers, whatever they are called", "[unit][ply]") {
  Model const model = import_ply_text(vertices(3, splats) + "element face 1\nproperty list uchar int vertex_indices\n",
                                      "0 0 0 0 0 0 0 -9\n1 0 0 0 0 0 0 -9\n0 1 0 0 0 0 0 9\n3 0 1 2\n");
  CHECK(message_lines(model.diagnostics).empty());
}
