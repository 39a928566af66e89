#include "lichtraum/ply.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

Model import_ply_text(std::string const& elements, std::string const& data) {
  return import_ply_bytes("ply\nformat ascii 1.0\n" + elements + "end_header\n" + data, "colors.ply", ".", {});
}

std::string vertices(std::size_t count, std::string const& more) {
  return "element vertex " + std::to_string(count) + "\nproperty float x\nproperty float y\nproperty float z\n" + more;
}

std::string const float_colors = "property float red\nproperty float green\nproperty double blue\n";
MeshGeometry const& points_of(Model const& model) {
  return *dynamic_cast<PointCloud const&>(**model.scene.shapes.find("points")).geometry();
}

std::string shown(Model const& model) {
  std::string all;
  for (Diagnostic const& d : model.diagnostics) all += d.message + "\n";
  return all;
}

constexpr float linear_of_188 = 0.5028865f;  // of 255, IEC 61966-2-1

}  // namespace

TEST_CASE("PLY: colours that are floats from 0 to 255 or 65535 are read as such", "[unit][ply]") {
  Model const fractions = import_ply_text(vertices(2, float_colors), "0 0 0 1 0.73725490196 0\n1 1 1 0 0 2\n");
  CHECK(shown(fractions).empty());
  CHECK(points_of(fractions).colors[0][1] == Approx(linear_of_188));
  CHECK(points_of(fractions).colors[1][2] > 1);

  Model const bytes = import_ply_text(vertices(2, float_colors), "0 0 0 255 188 0\n1 1 1 0 0 1\n");
  CHECK(shown(bytes) ==
        "colours of vertices go up to 255: read as 0 to 255, though those that are floats go from 0 to 1\n");
  CHECK(points_of(bytes).colors[0][0] == 1);
  CHECK(points_of(bytes).colors[0][1] == Approx(linear_of_188));
  CHECK(points_of(bytes).colors[1][2] == Approx(1 / 255.0 / 12.92));
  CHECK(points_of(bytes).colors[0][3] == 1);

  Model const words = import_ply_text(vertices(1, float_colors), "0 0 0 65535 48316 0\n");
  CHECK(shown(words) ==
        "colours of vertices go up to 65535: read as 0 to 65535, though those that are floats go from 0 to 1\n");
  CHECK(points_of(words).colors[0][0] == 1);
  CHECK(points_of(words).colors[0][1] == Approx(linear_of_188));
}

TEST_CASE("PLY: a model far from the origin may have colours from 0 to 255 as well", "[unit][ply]") {
  Model const model = import_ply_text(vertices(2, float_colors), "1000000 0 0 255 188 0\n1000001 1 1 0 0 1\n");
  CHECK(model.origin.x == Approx(1e6).margin(10));
  CHECK(points_of(model).positions[1][0] - points_of(model).positions[0][0] == 1);
  CHECK(points_of(model).colors[0][1] == Approx(linear_of_188));
}

TEST_CASE("PLY: an alpha of 1 stays one beside colours up to 255", "[unit][ply]") {
  Model const model = import_ply_text(vertices(1, float_colors + "property float alpha\n"), "0 0 0 255 0 0 1\n");
  CHECK(points_of(model).colors[0] == Float4{1, 0, 0, 1});
}
