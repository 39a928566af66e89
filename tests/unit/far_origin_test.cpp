#include "io/far_origin.hpp"

#include <algorithm>
#include <cstring>

#include "lichtraum/esdf.hpp"
#include "lichtraum/gltf.hpp"
#include "lichtraum/obj.hpp"
#include "lichtraum/ply.hpp"
#include "lichtraum/stl.hpp"
#include "scene/graph_fold.hpp"
#include "support/catch.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_triangles.hpp"
#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

Bounds box(Vec3 const& min, Vec3 const& max) {
  Bounds bounds;
  bounds.add(min);
  bounds.add(max);
  return bounds;
}

/// Positions of the only mesh.
std::vector<Float3> positions_in(Scene const& scene) {
  return dynamic_cast<Mesh const&>(**scene.shapes.find("mesh")).geometry()->positions;
}

// A millimetre above 5.6 million: floats have steps of half a metre there.
constexpr char const* far_obj =
    "v 500000 5600000 100\nv 500010 5600000.001 100\nv 500000.002 5600010 100\nvn 0 0 1\nf 1//1 2//1 3//1\n";
std::string const far_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "500000 5600000 100\n500010 5600000.001 100\n500000.002 5600010 100\n3 0 1 2\n";
std::string const far_stl =
    "solid mesh\nfacet normal 0 0 1\nouter loop\nvertex 500000 5600000 100\nvertex 500010 5600000.001 100\n"
    "vertex 500000.002 5600010 100\nendloop\nendfacet\nendsolid\n";

void check_moved(Model const& model) {
  REQUIRE(model.origin == Vec3(500010, 5600010, 100));
  auto const positions = positions_in(model.scene);
  REQUIRE(positions.size() == 3);
  CHECK(positions[0] == Float3{-10, -10, 0});
  CHECK(double(positions[1][1]) == Approx(-9.999).margin(1e-6));
  CHECK(double(positions[2][0]) == Approx(-9.998).margin(1e-6));
  REQUIRE(model.diagnostics.size() == 1);
  CHECK(model.diagnostics[0].code == DiagnosticCode::far_from_origin);
  CHECK(model.diagnostics[0].message ==
        "the model lies too far from the origin for its size: moved, so that 500010 5600010 100 is the origin");
}

}  // namespace

TEST_CASE("only what is far away for its size is moved", "[unit][far]") {
  CHECK(!far_origin({}));
  CHECK(!far_origin(box(Vec3(0), Vec3(0))));
  CHECK(!far_origin(box(Vec3(5), Vec3(5))));  // one point
  CHECK(!far_origin(box(Vec3(0), Vec3(1e300))));
  CHECK(!far_origin(box(Vec3(-1e308), Vec3(1e308))));
  CHECK(!far_origin(box(Vec3(1), Vec3(std::numeric_limits<double>::infinity()))));
  CHECK(!far_origin(box(Vec3(999, 0, 0), Vec3(1000, 0, 0))));
  CHECK(!far_origin(box(Vec3(0), Vec3(1e-320, 0, 0))));
  CHECK(!far_origin(box(Vec3(1e20), Vec3(1e20 * (1 + 1e-15)))));  // doubles have no detail there
  CHECK(far_origin(box(Vec3(1000, 0, 0), Vec3(1000.8, 0, 0))) == Vec3(1000.4, 0, 0));
  CHECK(far_origin(box(Vec3(-1000.8, 0, 0), Vec3(-1000, 0, 0))) == Vec3(-1000.4, 0, 0));
  CHECK(far_origin(box(Vec3(0, 0, 123400), Vec3(12, 34, 123456))) == Vec3(10, 20, 123430));
  CHECK(far_origin(box(Vec3(0, 1, 0), Vec3(0, 1.00032, 0))) == Vec3(0, 1.0002, 0));
  auto const tiny = far_origin(box(Vec3(1e-290), Vec3(1e-290 * 1.0001)));
  REQUIRE(tiny);
  CHECK(tiny->x / 1e-290 == Approx(1.00005).epsilon(1e-4));
}

TEST_CASE("far models keep what single precision would lose", "[unit][far]") {
  check_moved(import_obj_text(far_obj, "m.obj", {}, {}));
  check_moved(import_ply_bytes(far_ply, "m.ply", {}, {}));
  check_moved(import_stl_bytes(far_stl, "m.stl"));
}

TEST_CASE("what is far away in binary files is moved as well", "[unit][far]") {
  std::string stl = std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  float const corners[] = {500000, 0, 0, 500010, 0, 0, 500000, 10, 0};
  std::memcpy(stl.data() + 96, corners, sizeof corners);
  Model const model = import_stl_bytes(stl, "m.stl");
  CHECK(model.origin == Vec3(500010, 10, 0));
  CHECK(positions_in(model.scene)[0] == Float3{-10, -10, 0});
}

TEST_CASE("what is wrong in a far model is told once", "[unit][far]") {
  Model const model = import_obj_text(std::string(far_obj) + "bogus 1\n", "m.obj", {}, {});
  CHECK(model.diagnostics.size() == 2);
}

TEST_CASE("other models are as in their files", "[unit][far]") {
  Model const model =
      import_obj_text("v 500000 5600000 100\nv 500010 5600000 100\nv 0 0 0\nf 1 2 3\n", "m.obj", {}, {});
  CHECK(model.origin == Vec3(0));
  CHECK(model.diagnostics.empty());
  CHECK(positions_in(model.scene)[0] == Float3{500000, 5600000, 100});
}

TEST_CASE("a far model stands in a scene where its file says, with all its detail", "[unit][far]") {
  TemporaryFolder const folder;
  folder.write("far.obj", far_obj);
  folder.write("a.sdf", "define shape mesh far far.obj\ntransform far translate -500000 -5600000 -100\n");
  Scene const scene = EsdfScript::from_file(folder / "a.sdf", {}).take_scene();
  Bounds const bounds = fold_bounds(scene.roots()).total();
  CHECK(bounds.min.x == Approx(0).margin(1e-9));
  CHECK(bounds.min.y == Approx(0).margin(1e-9));
  CHECK(bounds.max.x == Approx(10).margin(1e-6));
  folder.write("a.sdf", "define shape mesh far far.obj\n");
  Scene const there = EsdfScript::from_file(folder / "a.sdf", {}).take_scene();
  CHECK(fold_bounds(there.roots()).total().min.y == Approx(5600000).epsilon(1e-12));
}

namespace {

/// A triangle on the globe with a lamp and a camera beside it, each a root, one of them by a matrix; an animation moves
/// the triangle by a quarter each second.
testing::GltfWriter far_gltf() {
  testing::GltfWriter writer;
  writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  writer.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  writer.json["extensionsUsed"] = {"KHR_lights_punctual"};
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 10}}};
  writer.json["nodes"] = {
      {{"mesh", 0}, {"translation", {4e6, 5e6, 1e6}}},
      {{"camera", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4e6 + 0.25, 5e6 + 0.5, 1e6 + 3, 1}}},
      {{"translation", {4e6, 5e6 + 2, 1e6}}, {"children", {3}}},
      {{"translation", {0.5, 0, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  writer.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 2});
  int const places = writer.add_vec3({4e6f, 5e6f, 1e6f, 4e6f + 0.5f, 5e6f, 1e6f});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  return writer;
}

}  // namespace

TEST_CASE("glTF models on the globe are moved, with cameras and lights, alike at all times", "[unit][far][gltf]") {
  TemporaryFolder const folder;
  folder.write("far.gltf", far_gltf().text());
  Vec3 const origin(4e6 + 1, 5e6 + 1, 1e6);
  auto const check = [&](Model const& model, double moved_by) {
    CHECK(model.origin == origin);
    Bounds const box = fold_bounds(model.scene.roots()).total();
    CHECK(box.min.x == moved_by - 1);
    CHECK(box.max.y == 0);
    CHECK(box.max.z == 0);
    REQUIRE(model.scene.cameras.size() == 1);
    CHECK(model.scene.cameras.front().generate_ray(0, 0, {8, 8}).origin == Vec3(-0.75, -0.5, 3));
    CHECK(*model.scene.lights.front().position() == Vec3(-0.5, 1, 0));
  };
  for (double const first : {-1., 0., 2.}) {
    CAPTURE(first);
    GltfAnimation animation(folder / "far.gltf", {});
    Model const model = animation.pose(first < 0 ? std::nullopt : std::optional(first));
    check(model, first > 0 ? 0.5 : 0);
    CHECK(std::ranges::count(model.diagnostics, DiagnosticCode::far_from_origin, &Diagnostic::code) == 1);
    CHECK(model.diagnostics.size() == 1);
    Model const next = animation.pose(1);
    check(next, 0.25);
    CHECK(next.diagnostics.empty());
  }
  // In a scene it stands where its file says.
  folder.write("a.sdf", "define shape mesh far far.gltf\ntransform far translate -4000000 -5000000 -1000000\n");
  Scene const scene = EsdfScript::from_file(folder / "a.sdf", {}).take_scene();
  CHECK(fold_bounds(scene.roots()).total().max.x == Approx(1).margin(1e-9));
}

TEST_CASE("vertices that nothing names, or that are infinite, do not say where a model lies", "[unit][far]") {
  std::string const obj = far_obj;
  for (char const* const vertex : {"v 0 0 0\n", "v inf 0 0\n", "v 1e300 0 0\n"}) {
    INFO(vertex);
    std::size_t const faces = obj.find("vn");
    Model const model = import_obj_text(obj.substr(0, faces) + vertex + obj.substr(faces), "m.obj", {}, {});
    CHECK(model.origin == Vec3(500010, 5600010, 100));
    CHECK(double(positions_in(model.scene)[1][1]) == Approx(-9.999).margin(1e-6));
  }
  for (char const* const vertex : {"0 0 0\n", "inf 0 0\n", "1e300 0 0\n"}) {
    INFO(vertex);
    std::string ply = far_ply;
    ply.replace(ply.find("vertex 3"), 8, "vertex 4");
    ply.insert(ply.find("3 0 1 2"), vertex);
    Model const model = import_ply_bytes(ply, "m.ply", ".", {});
    CHECK(model.origin == Vec3(500010, 5600010, 100));
    CHECK(double(positions_in(model.scene)[1][1]) == Approx(-9.999).margin(1e-6));
  }
  // And the other way round: what is drawn is near.
  std::string near = far_ply.substr(0, far_ply.find("500000")) + "0 0 0\n1 0 0\n0 1 0\n1e7 0 0\n3 0 1 2\n";
  near.replace(near.find("vertex 3"), 8, "vertex 4");
  CHECK(import_ply_bytes(near, "m.ply", ".", {}).origin == Vec3(0));
}
