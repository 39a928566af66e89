#include "scene/flatten.hpp"

#include <memory>

#include "scene/copy_graph.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

std::shared_ptr<Material> grey() { return std::make_shared<Material>("grey", Rgb(0.1), Rgb(0.5), Rgb(0), 1); }

std::shared_ptr<Sphere> sphere(Vec3 const& center = Vec3(0), double radius = 1) {
  return std::make_shared<Sphere>("sphere", center, radius, grey());
}

/// A composite of `count` spheres in a row along x.
std::shared_ptr<Composite> row_of_spheres(int count) {
  auto row = std::make_shared<Composite>("row");
  for (int i = 0; i < count; ++i) row->add(sphere({double(i), 0, 0}, 0.25));
  return row;
}

Vec3 center(device::SpherePrimitive const& s) { return {s.center[0], s.center[1], s.center[2]}; }

}  // namespace

TEST_CASE("flatten bakes a sphere under a similarity as a sphere", "[unit][flatten]") {
  auto shape = sphere({1, 0, 0}, 0.5);
  shape->rotate(90, {0, 0, 1});
  shape->scale(-2);  // mirrors as well
  shape->translate({0, 0, 7});
  FlatScene const flat = flatten({shape});
  REQUIRE(flat.objects.size() == 1);
  REQUIRE(flat.objects[0].spheres.size() == 1);
  CHECK(glm::distance(center(flat.objects[0].spheres[0]), Vec3(0, -2, 7)) < 1e-6);
  CHECK(flat.objects[0].spheres[0].radius == 1.0f);
}

TEST_CASE("flatten bakes a sphere under a per-axis scale as an ellipsoid with its matrix", "[unit][flatten]") {
  auto shape = sphere({1, 1, 1}, 2);
  shape->scale(Vec3(1, 2, 4));
  FlatScene const flat = flatten({shape});
  REQUIRE(flat.objects[0].spheres.empty());
  REQUIRE(flat.objects[0].ellipsoids.size() == 1);
  auto const& m = flat.objects[0].ellipsoids[0].unit_from_object;
  auto const unit = [&](Vec3 const& p) {
    auto const row = [&](device::float4 const& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
    return Vec3(row(m.row_x), row(m.row_y), row(m.row_z));
  };
  // The centre and the ends of the three axes of the ellipsoid, by hand.
  CHECK(glm::length(unit({1, 2, 4})) < 1e-6);
  CHECK(glm::distance(unit({3, 2, 4}), Vec3(1, 0, 0)) < 1e-6);
  CHECK(glm::distance(unit({1, 6, 4}), Vec3(0, 1, 0)) < 1e-6);
  CHECK(glm::distance(unit({1, 2, 12}), Vec3(0, 0, 1)) < 1e-6);
}

TEST_CASE("flatten multiplies matrices down the graph", "[unit][flatten]") {
  auto shape = sphere();
  auto inner = std::make_shared<Composite>("inner", Composite::Children{shape});
  auto outer = std::make_shared<Composite>("outer", Composite::Children{inner});
  shape->translate({1, 0, 0});
  inner->scale(3);
  outer->rotate(90, {0, 0, 1});
  FlatScene const flat = flatten({outer});
  REQUIRE(flat.objects[0].spheres.size() == 1);
  CHECK(glm::distance(center(flat.objects[0].spheres[0]), Vec3(0, 3, 0)) < 1e-6);
  CHECK(flat.objects[0].spheres[0].radius == 3.0f);
}

TEST_CASE("flatten makes an object of a composite that occurs several times", "[unit][flatten]") {
  auto row = row_of_spheres(10);
  row->translate({0, 0, -5});
  auto left = std::make_shared<Composite>("left", Composite::Children{row});
  auto right = std::make_shared<Composite>("right", Composite::Children{row});
  right->translate({100, 0, 0});
  FlatScene const flat = flatten({left, right, sphere()});
  REQUIRE(flat.objects.size() == 2);
  CHECK(flat.objects[0].spheres.size() == 1);
  CHECK(flat.objects[1].spheres.size() == 10);
  CHECK(center(flat.objects[1].spheres[3]) == Vec3(3, 0, 0));
  REQUIRE(flat.instances.size() == 2);
  CHECK(flat.instances[0].object == 1);
  CHECK(flat.instances[0].world_from_object.point(Vec3(0)) == Vec3(0, 0, -5));
  CHECK(flat.instances[1].world_from_object.point(Vec3(0)) == Vec3(100, 0, -5));
}

TEST_CASE("flatten copies what is too small to be an object", "[unit][flatten]") {
  auto row = row_of_spheres(2);
  auto twice = std::make_shared<Composite>("twice", Composite::Children{row, row});
  FlatScene const flat = flatten({twice});
  CHECK(flat.instances.empty());
  CHECK(flat.objects.size() == 1);
  CHECK(flat.objects[0].spheres.size() == 4);
}

TEST_CASE("flatten makes an object of a large composite that moves as one", "[unit][flatten]") {
  auto row = row_of_spheres(5000);
  row->translate({0, 0, -5});
  auto holder = std::make_shared<Composite>("holder", Composite::Children{row, sphere()});
  holder->translate({7, 0, 0});
  CHECK(flatten({holder, sphere()}).instances.empty());  // nobody said that it moves as one

  row->set_moves_as_one(true);
  FlatScene const flat = flatten({holder, sphere()});
  REQUIRE(flat.objects.size() == 2);
  CHECK(flat.objects[0].spheres.size() == 2);
  CHECK(flat.objects[1].spheres.size() == 5000);
  CHECK(center(flat.objects[1].spheres[3]) == Vec3(3, 0, 0));  // in its own frame
  REQUIRE(flat.instances.size() == 1);
  CHECK(flat.instances[0].object == 1);
  CHECK(flat.instances[0].world_from_object.point(Vec3(0)) == Vec3(7, 0, -5));

  holder->set_moves_as_one(true);  // the topmost
  CHECK(flatten({holder}).objects[1].spheres.size() == 5001);
}

TEST_CASE("flatten bakes a small composite that moves as one", "[unit][flatten]") {
  auto row = row_of_spheres(4095);
  row->set_moves_as_one(true);
  CHECK(flatten({row}).objects[0].spheres.size() == 4095);
  row->add(sphere());
  CHECK(flatten({row}).objects[0].spheres.empty());
}

TEST_CASE("a copied graph moves as the graph did", "[unit][flatten]") {
  auto row = row_of_spheres(1);
  CHECK_FALSE(row->moves_as_one());
  row->set_moves_as_one(true);
  auto const copies = copy_graph({std::make_shared<Composite>("parent", Composite::Children{row})});
  auto const& parent = dynamic_cast<Composite const&>(*copies.at(0));
  CHECK_FALSE(parent.moves_as_one());
  CHECK(dynamic_cast<Composite const&>(*parent.children().at(0)).moves_as_one());
}

TEST_CASE("flatten draws a child once per path", "[unit][flatten]") {
  // Ten levels of a composite that names the one below twice: 2^10 rows of 8 spheres.
  std::shared_ptr<Composite> top = row_of_spheres(8);
  for (int level = 0; level < 10; ++level) {
    top = std::make_shared<Composite>("level", Composite::Children{top, top});
  }
  FlatScene const flat = flatten({top});
  std::uint64_t drawn = flat.objects[0].primitive_count();
  for (FlatInstance const& instance : flat.instances) drawn += flat.objects[instance.object].primitive_count();
  CHECK(drawn == 8 * 1024);
}

TEST_CASE("flatten refuses a graph that unfolds to more than memory holds", "[unit][flatten]") {
  std::shared_ptr<Composite> top = row_of_spheres(8);
  for (int level = 0; level < 1000; ++level) {
    top = std::make_shared<Composite>("level", Composite::Children{top, top});
  }
  try {
    flatten({top});
    FAIL("nothing was thrown");
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::scene);
    CHECK(std::string(error.what()).find("more than 10^18") != std::string::npos);
  }
}

TEST_CASE("flatten walks a chain of 100,000 composites", "[unit][flatten]") {
  std::shared_ptr<Shape> top = sphere();
  for (int level = 0; level < 100'000; ++level) {
    top = std::make_shared<Composite>("level", Composite::Children{top});
    if (level % 1000 == 0) top->translate({1, 0, 0});
  }
  FlatScene const flat = flatten({top});
  REQUIRE(flat.objects[0].spheres.size() == 1);
  CHECK(center(flat.objects[0].spheres[0]) == Vec3(100, 0, 0));
}

TEST_CASE("flatten leaves out and counts what does not fit a float", "[unit][flatten]") {
  FlatScene const flat = flatten({sphere({1e300, 0, 0}), sphere()});
  CHECK(flat.unrepresentable == 1);
  CHECK(flat.objects[0].spheres.size() == 1);
}

TEST_CASE("flatten numbers materials once and says which shape a primitive came from", "[unit][flatten]") {
  auto const red = std::make_shared<Material>("red", Rgb(1, 0, 0), Rgb(1, 0, 0), Rgb(0), 1);
  auto const blue = std::make_shared<Material>("blue", Rgb(0, 0, 1), Rgb(0, 0, 1), Rgb(0), 1);
  auto const box = std::make_shared<Box>("box", Vec3(1), Vec3(-1), blue);
  auto const ball = std::make_shared<Sphere>("ball", Vec3(0), 1, red);
  auto const triangle = std::make_shared<Triangle>("triangle", Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), blue);
  FlatScene const flat = flatten({ball, box, triangle});
  REQUIRE(flat.materials.size() == 2);
  FlatObject const& world = flat.objects[0];
  CHECK(flat.materials[world.spheres[0].tag.material] == red);
  CHECK(flat.materials[world.boxes[0].tag.material] == blue);
  CHECK(flat.materials[world.triangles[0].tag.material] == blue);
  CHECK(flat.shapes[world.boxes[0].tag.shape] == box.get());
  CHECK(flat.shapes[world.triangles[0].tag.shape] == triangle.get());
}

namespace {

/// `count` triangles with outward side +z, side by side along x.
std::shared_ptr<Mesh> strip_mesh(int count) {
  auto geometry = std::make_shared<MeshGeometry>();
  for (int i = 0; i < count; ++i) {
    auto const x = float(i);
    geometry->positions.insert(geometry->positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    for (int corner = 0; corner < 3; ++corner) geometry->indices.push_back(std::uint32_t(3 * i + corner));
  }
  return std::make_shared<Mesh>("mesh", geometry, grey());
}

Vec3 normal(device::TrianglePrimitive const& t) {
  auto const corner = [&](int i) { return Vec3(t.vertices[i][0], t.vertices[i][1], t.vertices[i][2]); };
  return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
}

}  // namespace

TEST_CASE("flatten says how much a graph unfolds to", "[unit][flatten]") {
  auto const pair = strip_mesh(2);  // too small for an object
  std::shared_ptr<Shape> top = sphere();
  for (int level = 0; level < 54; ++level) {
    top = std::make_shared<Composite>("level", Composite::Children{top, top, pair});
  }
  // The fourteenth level is the last that becomes an object: 3 2^14 - 2 primitives, in 2^40 places; above it the pair
  // is in 2^40 - 1.
  CHECK_THROWS_WITH(flatten({top}), contains_text("2199023304700 primitives and 1099511627776 instances, which need "
                                                  "800 TB of memory"));
}

TEST_CASE("flatten bakes a mesh that occurs once into the world", "[unit][flatten][mesh]") {
  auto mesh = strip_mesh(20);
  mesh->rotate(90, {0, 1, 0});
  mesh->translate({0, 0, 5});
  FlatScene const flat = flatten({mesh});
  REQUIRE(flat.instances.empty());
  REQUIRE(flat.objects[0].triangles.size() == 20);
  CHECK(flat.objects[0].triangles[3].vertices[0][2] == Approx(2));
  CHECK(flat.objects[0].triangles[19].vertices[1][2] == Approx(-15));
  CHECK(glm::distance(normal(flat.objects[0].triangles[3]), Vec3(1, 0, 0)) < 1e-6);
}

TEST_CASE("flatten makes an object of a mesh that occurs several times", "[unit][flatten][mesh]") {
  auto mesh = strip_mesh(20);
  mesh->translate({0, 7, 0});
  auto left = std::make_shared<Composite>("left", Composite::Children{mesh});
  auto right = std::make_shared<Composite>("right", Composite::Children{mesh});
  right->translate({100, 0, 0});
  FlatScene const flat = flatten({left, right, mesh});
  REQUIRE(flat.objects.size() == 2);
  CHECK(flat.objects[0].triangles.empty());
  CHECK(flat.objects[1].triangles.size() == 20);
  CHECK(flat.objects[1].triangles[0].vertices[0][1] == 0.f);  // in its own frame
  REQUIRE(flat.instances.size() == 3);
  CHECK(flat.instances[0].world_from_object.point(Vec3(0)) == Vec3(0, 7, 0));
  CHECK(flat.instances[1].world_from_object.point(Vec3(0)) == Vec3(100, 7, 0));
  CHECK(flat.shapes.size() == 1);
}

TEST_CASE("flatten copies a small mesh instead of making instances", "[unit][flatten][mesh]") {
  auto mesh = strip_mesh(2);
  FlatScene const flat = flatten({std::make_shared<Composite>("twice", Composite::Children{mesh, mesh})});
  CHECK(flat.instances.empty());
  CHECK(flat.objects[0].triangles.size() == 4);
}

TEST_CASE("triangles keep their outward side when they are mirrored", "[unit][flatten][mesh]") {
  auto mesh = strip_mesh(1);
  mesh->scale(Vec3(-2, 1, 1));
  auto triangle = std::make_shared<Triangle>("t", Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), grey());
  triangle->scale(Vec3(1, -3, 1));
  FlatScene const flat = flatten({mesh, triangle});
  CHECK(normal(flat.objects[0].triangles[0]) == Vec3(0, 0, 1));
  CHECK(normal(flat.objects[0].triangles[1]) == Vec3(0, 0, 1));
  // The reference tracer says the same.
  Hit hit;
  REQUIRE(mesh->closest_hit({{-0.5, 0.25, 1}, {0, 0, -1}}, 0, hit));
  CHECK(hit.normal == Vec3(0, 0, 1));
}

TEST_CASE("flatten leaves out the triangles of a mesh that do not fit a float", "[unit][flatten][mesh]") {
  auto mesh = strip_mesh(10);
  mesh->scale(Vec3(1e38, 1, 1));  // x = 3.4e38 is the last that fits: the fourth triangle ends at 4e38
  FlatScene const flat = flatten({mesh});
  CHECK(flat.objects[0].triangles.size() == 3);
  CHECK(flat.unrepresentable == 7);
}
