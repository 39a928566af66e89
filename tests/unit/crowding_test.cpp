#include "accel/crowding.hpp"

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

BuildPrimitive cube(double x, double y, double z, device::uint index, device::uint kind = PRIMITIVE_SPHERE) {
  DeviceBounds bounds;
  add_point(bounds, Vec3(x, y, z));
  add_point(bounds, Vec3(x + 1, y + 1, z + 1));
  return {bounds, {kind, index}};
}

double crowding_of(std::vector<BuildPrimitive> primitives, std::vector<double> const& of_instances = {}) {
  return crowding(build_bvh(primitives), of_instances);
}

}  // namespace

TEST_CASE("crowding is the number of leaves where all are in one place", "[unit][crowding]") {
  std::vector<BuildPrimitive> stack;
  for (device::uint i = 0; i < 4096; ++i) stack.push_back(cube(0, 0, 0, i));
  CHECK(crowding_of(stack) == Approx(1024));  // of four each
  // Whatever else there is.
  for (device::uint i = 0; i < 1000; ++i) stack.push_back(cube(100 + 10 * i, 0, 0, 4096 + i));
  CHECK(crowding_of(stack) == Approx(1024));
}

TEST_CASE("crowding is small where boxes lie beside each other", "[unit][crowding]") {
  std::vector<BuildPrimitive> wall;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) wall.push_back(cube(x, y, 0, device::uint(64 * y + x)));
  }
  double const of_wall = crowding_of(wall);
  CHECK(of_wall >= 1);
  CHECK(of_wall < 8);
  CHECK(crowding_of({}) == 0);
  CHECK(crowding_of({cube(0, 0, 0, 0)}) == Approx(1));
}

TEST_CASE("crowding counts what instances stand for, and what every ray meets", "[unit][crowding]") {
  CHECK(crowding_of({cube(0, 0, 0, 0, PRIMITIVE_INSTANCE)}, {500}) == Approx(500));
  CHECK(crowding_of({cube(0, 0, 0, 0, PRIMITIVE_INSTANCE), cube(0, 0, 0, 1, PRIMITIVE_INSTANCE)}, {500, 0}) ==
        Approx(501));
  std::vector<BuildPrimitive> planes;
  for (device::uint i = 0; i < 64; ++i) planes.push_back({{}, {PRIMITIVE_PLANE, i}});
  std::vector<BuildPrimitive> one{cube(0, 0, 0, 0)};
  CHECK(crowding(build_bvh(one, planes)) == Approx(64));
}
