#include "core/counted.hpp"

#include "support/catch.hpp"

using lichtraum::counted;

TEST_CASE("what is counted is in the singular where it is one", "[unit]") {
  CHECK(counted(0, "sphere") == "0 spheres");
  CHECK(counted(1, "box") == "1 box");
  CHECK(counted(2, "box") == "2 boxes");
  CHECK(counted(3, "mesh") == "3 meshes");
}
