#include "support/obj_import.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

template <class Kind>
Kind const& named(Model const& model, std::string const& name) {
  CAPTURE(name);
  auto const* const shape = model.scene.shapes.find(name);
  REQUIRE(shape);
  return dynamic_cast<Kind const&>(**shape);
}

}  // namespace

TEST_CASE("OBJ: vertices that nothing names are points with their colours", "[unit][obj][points]") {
  Model const model = import_text("# a cloud\nv 0 0 0 1 0 0\nv 3 4 0 0 1 0\nvn 0 0 1\n");
  CHECK(shown(model.diagnostics) == "");
  auto const& cloud = named<PointCloud>(model, "points");
  CHECK(cloud.geometry()->positions == std::vector<Float3>{{0, 0, 0}, {3, 4, 0}});
  CHECK(cloud.geometry()->colors == std::vector<Float4>{{1, 0, 0, 1}, {0, 1, 0, 1}});
  CHECK(cloud.material()->pbr() != nullptr);  // or their colours would not count
  CHECK(2 * cloud.radius() == Approx(5 * 0.01));
  ModelOptions options;
  options.point_size = 40;
  Model const large = import_text("v 0 0 0\nv 3 4 0\n", options);
  CHECK(shown(large.diagnostics) == "");
  CHECK(2 * named<PointCloud>(large, "points").radius() == Approx(5 * 0.04));

  Model const far = import_text("v 5000000 0 0\nv 5000003 4 0\n");
  CHECK(far.origin != Vec3(0));
  CHECK(shown(import_text("v 0 0 0\nv 1 nan 0\n").diagnostics) ==
        "m.obj:0:0: 1 point left out: it has a vertex that is not finite\nm.obj:2:5: 'nan' is not a finite number\n");
  CHECK_THROWS_AS(import_text("v nan 0 0\n"), SceneError);
  CHECK_THROWS_AS(import_text("vn 0 0 1\n"), SceneError);
  // What names vertices in vain has no points either.
  for (char const* const vain : {"f 1 2\n", "f 1 2 9\n", "l 1\n", "p 9\n", "p x\n", "p\n", "curv 0 1 1 2\n"}) {
    CAPTURE(vain);
    CHECK_THROWS_AS(import_text(std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + vain), SceneError);
  }
}

TEST_CASE("OBJ: points are those that p names, by group and material", "[unit][obj][points]") {
  Model const model = import_text(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\n"
      "g left\np 1 -3/1\ng right\np 4 4\n");
  CHECK(shown(model.diagnostics) == "");
  CHECK(named<PointCloud>(model, "left").geometry()->positions == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}});
  CHECK(named<PointCloud>(model, "right").geometry()->positions == std::vector<Float3>{{3, 0, 0}});
}

TEST_CASE("OBJ: without faces, lines are drawn from vertex to vertex", "[unit][obj][lines]") {
  TemporaryFolder const folder;
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("m.obj",
               "mtllib m.mtl\nv 0 0 0\nv 3 0 0\nv 3 4 0\nv 9 9 9\n"
               "o frame\nusemtl red\nl 1/1 2/2 3\nl 4 4\nl 2 3\np 4\n");
  Model const model = import_obj(folder / "m.obj");
  CHECK(model.diagnostics.size() == 1);
  CHECK(model.diagnostics[0].message == "points are not drawn beside lines");
  CHECK(model.diagnostics[0].location.line == 11);
  auto const& lines = named<LineSet>(model, "frame.red");
  CHECK(lines.geometry()->positions == std::vector<Float3>{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {9, 9, 9}});
  CHECK(lines.geometry()->lines == std::vector<std::uint32_t>{0, 1, 1, 2, 3, 3, 1, 2});
  CHECK(lines.geometry()->indices.empty());
  CHECK(lines.material()->name() == "red");
  CHECK(lines.radius() > 0);

  Model const colored = import_text("v 0 0 0 1 0 0\nv 1 0 0 0 0 1\nvt 0 0\nvn 0 0 1\nl 1/1/1 2/1/1\n");
  auto const& between = named<LineSet>(colored, "lines");
  CHECK(between.geometry()->colors == std::vector<Float4>{{1, 0, 0, 1}, {0, 0, 1, 1}});
  CHECK(between.geometry()->texcoords.empty());
  CHECK(between.geometry()->normals.empty());
}

TEST_CASE("OBJ: what is wrong with lines and points is told with its place and left out", "[unit][obj][lines]") {
  std::string const line = "v 0 0 0\nv 1 0 0\nl 1 2\n";
  CHECK(shown(import_text(line + "l 1\n").diagnostics) == "m.obj:4:1: a line of 1 corner is left out\n");
  CHECK(shown(import_text(line + "l 1 x\n").diagnostics) ==
        "m.obj:4:5: expected vertex/texture/normal, found 'x': the line is left out\n");
  CHECK(shown(import_text(line + "l 1 3\n").diagnostics) ==
        "m.obj:0:0: 1 line left out: it has a vertex that is not there\nm.obj:4:5: there is no vertex 3; the file has "
        "2\n");
  CHECK(shown(import_text(line + "v 1 inf 0\nl 1 2 3\n").diagnostics) ==
        "m.obj:0:0: 1 line left out: it has a vertex that is not finite\nm.obj:4:5: 'inf' is not a finite number\n");
  CHECK(shown(import_text("v 0 0 0\np 1 0\np 1\n").diagnostics) ==
        "m.obj:2:5: expected vertex/texture/normal, found '0': the point is left out\n");
}
