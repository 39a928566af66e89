#include <cmath>
#include <cstring>

#include "compile/scene_buffers.hpp"
#include "lichtraum/obj.hpp"
#include "lichtraum/ply.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/diagnostic_lines.hpp"
#include "support/gltf_import.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using testing::GltfWriter;

namespace {

Model import_cloud(std::string const& data, std::size_t count, ModelOptions const& options = {}) {
  return import_ply_bytes("ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
                              "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                              "property uchar green\nproperty uchar blue\nend_header\n" +
                              data,
                          "cloud.ply", ".", options);
}

PointCloud const& cloud_of(Scene const& scene, char const* name) {
  return dynamic_cast<PointCloud const&>(**scene.shapes.find(name));
}

std::shared_ptr<MeshGeometry> colored_points(std::size_t count) {
  auto geometry = std::make_shared<MeshGeometry>();
  for (std::size_t i = 0; i < count; ++i) {
    geometry->positions.push_back({float(i), float(i % 7), float(i % 3)});
    geometry->colors.push_back({float(i), 0.5f, 0.25f, 1});
  }
  return geometry;
}

std::shared_ptr<Material const> white() { return std::make_shared<Material>("white", PbrModel()); }

/// The colour of the sphere or ellipsoid at `index` as the device finds it; none: -1.
float red_of(SceneBuffers const& buffers, BigVector<device::uint> const& colors, std::size_t index) {
  return colors[index] == 0 ? -1 : buffers.vertex_data[colors[index] - 1];
}

/// That each sphere with a colour has the one of its point, whose number is its x; returns how many there are.
std::size_t check_sphere_colors(SceneBuffers const& buffers, double scale) {
  std::size_t colored = 0;
  auto const check = [&](std::size_t index, float x, device::PrimitiveTag const& tag) {
    float const red = red_of(buffers, buffers.sphere_colors, index);
    CHECK(red == (tag.material == 0 ? float(std::round(x / scale)) : -1.0f));
    colored += red >= 0;
  };
  if (buffers.layout == TreeLayout::binary) {
    REQUIRE(buffers.sphere_colors.size() == buffers.spheres.size());
    for (std::size_t i = 0; i < buffers.spheres.size(); ++i) {
      check(i, buffers.spheres[i].center[0], buffers.spheres[i].tag);
    }
    return colored;
  }
  REQUIRE(buffers.sphere_colors.size() == BLOCK_LANES * buffers.sphere_blocks.size());
  for (std::size_t i = 0; i < buffers.sphere_colors.size(); ++i) {
    auto const& block = buffers.sphere_blocks[i / BLOCK_LANES];
    std::size_t const lane = i % BLOCK_LANES;
    if (std::isnan(block.radius[lane])) continue;
    check(i, block.center[0][lane], block.tags[lane]);
  }
  return colored;
}

}  // namespace

TEST_CASE("PLY: vertices without faces are points with their colours", "[unit][ply][points]") {
  Model const model = import_cloud("0 0 0 255 0 0\n3 4 0 0 255 0\n", 2);
  CHECK(message_lines(model.diagnostics) == "");
  PointCloud const& cloud = cloud_of(model.scene, "points");
  REQUIRE(cloud.geometry()->positions == std::vector<Float3>{{0, 0, 0}, {3, 4, 0}});
  CHECK(cloud.geometry()->colors == std::vector<Float4>{{1, 0, 0, 1}, {0, 1, 0, 1}});
  CHECK(cloud.material()->pbr() != nullptr);  // or their colours would not count
  CHECK(2 * cloud.radius() == Approx(5 * 0.01));
  Hit hit;
  REQUIRE(model.scene.roots().front()->closest_hit({{3, 4, 9}, {0, 0, -2}}, 0, hit));
  CHECK(hit.triangle == 1);
  CHECK(hit.t == Approx((9 - cloud.radius()) / 2));
  CHECK(hit.normal.z == Approx(1));
}

TEST_CASE("PLY: points that are not finite are left out, and a file needs one that is", "[unit][ply][points]") {
  Model const model = import_cloud("0 0 0 255 0 0\n1e39 4 0 0 255 0\n1 0 0 0 0 255\n", 3);
  CHECK(message_lines(model.diagnostics) == "points that are not finite are left out: 1\n'1e39' is too large\n");
  CHECK(cloud_of(model.scene, "points").geometry()->colors.back() == Float4{0, 0, 1, 1});
  CHECK_THROWS_AS(import_cloud("1e39 0 0 1 2 3\n", 1), SceneError);
  CHECK_THROWS_AS(import_cloud("", 0), SceneError);
}

TEST_CASE("a size of points is told to have no effect where a model has neither points nor lines", "[unit][points]") {
  std::string const warning = "it has no points and no lines; their size has no effect\n";
  ModelOptions options;
  options.point_size = 5;
  std::string const corners = "3\nproperty float x\nproperty float y\nproperty float z\n";
  std::string const triangle = "0 0 0\n1 0 0\n0 1 0\n";
  std::string const ply = "ply\nformat ascii 1.0\nelement vertex " + corners;
  auto const of_ply = [&](std::string const& more) {
    return message_lines(import_ply_bytes(ply + more, "a.ply", ".", options).diagnostics);
  };
  CHECK(of_ply("end_header\n" + triangle).empty());
  CHECK(of_ply("element face 1\nproperty list uchar int vertex_indices\nend_header\n" + triangle + "3 0 1 2\n") ==
        warning);
  CHECK(message_lines(import_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", ".", options).diagnostics) ==
        warning);
  CHECK(message_lines(import_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", ".").diagnostics).empty());
  GltfWriter writer;
  writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0});
  CHECK(message_lines(testing::import_model(writer, options).diagnostics) == warning);
  writer.json["meshes"][0]["primitives"][0]["mode"] = 1;
  CHECK(message_lines(testing::import_model(writer, options).diagnostics).find(warning) == std::string::npos);
}

TEST_CASE("points have one size for all, by their number or as asked for", "[unit][points]") {
  ModelOptions options;
  options.point_size = 40;
  CHECK(2 * cloud_of(import_cloud("0 0 0 1 2 3\n3 4 0 1 2 3\n", 2, options).scene, "points").radius() ==
        Approx(5 * 0.04));

  std::string data;
  for (int i = 0; i < 40000; ++i) data += "0 0 0 1 2 3\n";
  data += "3 4 0 1 2 3\n";
  CHECK(2 * cloud_of(import_cloud(data, 40001).scene, "points").radius() == Approx(5 * 0.006).epsilon(1e-4));

  // Alone, the box around it has no diagonal.
  double const alone = cloud_of(import_cloud("7 7 7 1 2 3\n", 1).scene, "points").radius();
  CHECK(alone > 0.001);
  CHECK(alone < 1);
}

TEST_CASE("glTF: points below a scaled node have the model's size, as far as indices name them",
          "[unit][gltf][points]") {
  GltfWriter writer;
  auto& points = writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 9, 0, 0, 0, 1});
  points["mode"] = 0;
  points["attributes"]["COLOR_0"] =
      writer.add_accessor("VEC4", 4, std::vector<float>{1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1});
  points["indices"] = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{0, 1, 3, 1, 9});
  writer.json["nodes"][0]["scale"] = {4, 4, 4};
  ModelOptions options;
  options.point_size = 100;
  Model const model = testing::import_model(writer, options);
  CHECK(message_lines(model.diagnostics) ==
        "/meshes/0/primitives/0/indices: points left out whose index is out of range (4): 1\n");
  PointCloud const& cloud = cloud_of(model.scene, "mesh_0");
  // (0, 9, 0) is named by no index: the box is 4 x 0 x 4.
  CHECK(4 * 2 * cloud.radius() == Approx(0.1 * std::sqrt(32)));
  Hit hit;
  REQUIRE(model.scene.roots().front()->closest_hit({{4, 0, 9}, {0, 0, -1}}, 0, hit));
  CHECK(hit.triangle == 1);
  CHECK_FALSE(model.scene.roots().front()->closest_hit({{0, 36, 9}, {0, 0, -1}}, 0, hit));
  CHECK(flatten(model.scene.roots()).unrepresentable == 0);
}

TEST_CASE("each sphere of a point cloud keeps its colour in every layout, alone and after another scene",
          "[unit][compile][points]") {
  constexpr std::size_t count = 500;
  auto const cloud = std::make_shared<PointCloud>("cloud", colored_points(count), 0.25, white());
  auto const group = std::make_shared<Composite>("group", Composite::Children{cloud});
  group->scale(2);
  group->set_moves_as_one(true);
  auto const ball = std::make_shared<Sphere>("ball", Vec3(-9, 0, 0), 1, nullptr);
  auto const shared_cloud = std::make_shared<PointCloud>("shared", colored_points(count), 0.25, cloud->material());
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    SceneBuffers const alone = compile_scene(flatten({group, ball}), {}, layout);
    CHECK((alone.shading.features & SCENE_ATTRIBUTES) != 0);
    CHECK(check_sphere_colors(alone, 2) == count);

    auto const left = std::make_shared<Composite>("left", Composite::Children{shared_cloud});
    auto const right = std::make_shared<Composite>("right", Composite::Children{shared_cloud});
    right->translate({0, 0, 50});
    SceneBuffers before = compile_scene(flatten({left, right}), {}, layout);
    REQUIRE(before.instances.size() == 2);
    CHECK(check_sphere_colors(before, 1) == count);
    right->translate({0, 0, 50});
    SceneBuffers const after = compile_scene(flatten({left, right}), {}, layout, &before);
    CHECK(check_sphere_colors(after, 1) == count);
  }
}

TEST_CASE("points that are stretched are ellipsoids with their colours", "[unit][compile][points]") {
  auto const cloud = std::make_shared<PointCloud>("cloud", colored_points(20), 0.25, white());
  cloud->scale(Vec3(1, 2, 1));
  auto const plain = std::make_shared<Sphere>("plain", Vec3(0), 1, nullptr);
  plain->scale(Vec3(1, 2, 1));
  SceneBuffers const buffers = compile_scene(flatten({plain, cloud}), {}, TreeLayout::binary);
  REQUIRE(buffers.ellipsoids.size() == 21);
  REQUIRE(buffers.ellipsoid_colors.size() == 21);
  CHECK(buffers.ellipsoid_colors[0] == 0);
  for (std::size_t i = 0; i < 20; ++i) CHECK(red_of(buffers, buffers.ellipsoid_colors, i + 1) == float(i));
}
