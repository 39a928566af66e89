#include "lichtraum/gltf.hpp"

#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/gltf_writer.hpp"

using namespace lichtraum;
using testing::GltfWriter;

namespace {

std::vector<float> const triangle_positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};

using Corners = std::array<Vec3, 3>;

/// Every triangle in the world, instances unfolded.
std::vector<Corners> world_triangles(Scene const& scene) {
  FlatScene const flat = flatten(scene.roots());
  std::vector<Corners> result;
  auto const add = [&](FlatObject const& object, Transform const& transform) {
    for (auto const& t : object.triangles) {
      auto const corner = [&](int i) {
        return transform.point({t.vertices[i][0], t.vertices[i][1], t.vertices[i][2]});
      };
      result.push_back({corner(0), corner(1), corner(2)});
    }
  };
  add(flat.objects[0], Transform());
  for (auto const& instance : flat.instances) add(flat.objects[instance.object], instance.world_from_object);
  return result;
}

std::string messages(GltfModel const& model) {
  std::string all;
  for (auto const& d : model.diagnostics) all += d.message + '\n';
  return all;
}

}  // namespace

TEST_CASE("a triangle in a .gltf and in a .glb", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  for (char const* name : {"model.gltf", "model.glb"}) {
    GltfModel const model = import_gltf(writer.write(name));
    CHECK(messages(model) == "");
    auto const triangles = world_triangles(model.scene);
    REQUIRE(triangles.size() == 1);
    CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  }
}

TEST_CASE("a model without camera and lights gets some that show it", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  Scene const scene = load_gltf(writer.write());
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.lights.size() == 3);
  Camera const& camera = scene.cameras.front();
  REQUIRE(camera.resolution());
  Hit hit;
  Vec3 const center(0.5 * camera.resolution()->width, 0.5 * camera.resolution()->height, 0);
  Ray const ray = camera.generate_ray(center.x - 5, center.y + 5, *camera.resolution());
  auto const root = scene.roots().at(0);
  CHECK(root->closest_hit(ray, 0, hit));
}
