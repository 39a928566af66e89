#include <cmath>

#include "lichtraum/aov.hpp"
#include "lichtraum/drawn_objects.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/textured_meshes.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Resolution const size{160, 120};

/// Shapes of each kind; a part that occurs four times (an instance on the device: it has more than eight primitives),
/// between shapes of the world before and after it; shapes that occur twice and are copied.
std::string const graph =
    "define material red 1 0 0  0.8 0.1 0.1  0 0 0  1\n"
    "define shape box floor -30 -3 -30 30 -2.5 30 red\n"
    "define shape sphere ball 0 0.9 0 0.4 red\n"
    "define shape box plate -0.6 -0.6 -0.6 0.6 0.4 0.6 red\n"
    "define shape triangle t1 -1 0 0  0 1 0  -1 1 0 red\ndefine shape triangle t2 1 0 0  1 1 0  0 1 0 red\n"
    "define shape triangle t3 -1 0 0.1  0 1 0.1  -1 1 0.1 red\ndefine shape triangle t4 1 0 0.1  1 1 0.1  0 1 0.1 red\n"
    "define shape triangle t5 -1 -1 0  -0.6 -1 0  -0.8 0 0 red\ndefine shape triangle t6 1 -1 0  0.6 -1 0  0.8 0 0 "
    "red\n"
    "define shape composite wings t1 t2 t3 t4 t5 t6\n"
    "define shape composite part ball plate wings\n"
    "define shape composite left part\ntransform left rotate 30 0 1 0\ntransform left translate -2.2 0 0\n"
    "define shape sphere middle 0 0 0 0.8 red\ntransform middle scale 0.5 1 0.7\n"
    "define shape composite right part\ntransform right scale -1 1.3 0.8\ntransform right translate 2.2 0 0\n"
    "define shape composite row left middle right\n"
    "define shape composite above row\ntransform above rotate 10 0 0 1\ntransform above translate 0 2.8 -1\n"
    "define shape composite all row above\n"
    "define shape box last 3.5 -2 -1 4.2 4 0 red\n"
    "define camera eye 50\ntransform eye rotate -5 1 0 0\ntransform eye translate 0 2.5 12\n";

/// How many pixels differ: by more than `tolerance` of the expected value's size, or in whether anything is there.
std::size_t differing(Image const& actual, Image const& expected, double tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < expected.data().size(); i += 3) {
    bool is_same = true;
    for (std::size_t c = i; c < i + 3; ++c) {
      double const a = double(actual.data()[c]), e = double(expected.data()[c]);
      is_same = is_same && (a == e || std::abs(a - e) <= tolerance * std::max(1.0, std::abs(e)));
    }
    count += !is_same;
  }
  return count;
}

void check_aovs(Scene const& scene, std::string const& name) {
  auto const pixels = std::size_t(size.width * size.height);
  RenderRequest request = whole_picture(scene.cameras.front(), size);
  request.sampling = {Sampling::Pattern::seeded, 3};  // means nothing
  request.tone_map = ToneMap::reinhard;
  request.transfer = Transfer::srgb;
  for (auto const& [aov, tolerance] : {std::pair{Aov::depth, 2e-5}, {Aov::normal, 2e-4}, {Aov::object_id, 0.0}}) {
    request.aov = aov;
    Image const expected = render_reference(scene, request);
    for (DeviceInfo const& device : opencl_devices()) {
      for (Traversal const traversal : {Traversal::scalar, Traversal::wide, Traversal::packet}) {
        INFO(name << ", aov " << int(aov) << ", traversal " << int(traversal.grouping));
        Image const actual = render_on(device, scene, request, traversal);
        CHECK(differing(actual, expected, tolerance) <= pixels / 500);  // silhouettes, and a bumpy normal's steps
      }
    }
  }
}

}  // namespace

TEST_CASE("depth, normals and objects are what the reference tracer finds", "[image][aov]") {
  REQUIRE_OPENCL_DEVICE();
  check_aovs(scene_of(graph), "graph");
}

TEST_CASE("a picture's objects lead back to their places in the graph", "[image][aov]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(graph);
  DrawnObjects const objects(scene);
  CHECK(objects.count() == 2 * (8 + 1 + 8) + 2);
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  RenderRequest request = whole_picture(scene.cameras.front(), size);
  auto const name_at = [&](Vec3 const& point) {
    // Where the camera sees a point: its coordinates in the camera's frame.
    Vec3 const p = request.camera.world_from_camera().inverse().point(point);
    double const width = 2 * std::tan(0.5 * 50 * 3.14159265358979 / 180);
    int const x = int(size.width * (0.5 - p.x / p.z / width)),
              y = int(size.height / 2.0 + size.width * p.y / p.z / width);
    auto const seen = look_at_pixel(*renderer, request, x, y);
    if (!seen) return std::string("nothing");
    CHECK(glm::distance(seen->position, request.camera.world_from_camera().point(Vec3(0))) ==
          Approx(seen->distance).epsilon(1e-6));
    CHECK(glm::distance(seen->position, point) < 0.8);
    CHECK(glm::length(seen->normal) == Approx(1).epsilon(1e-4));
    std::string names;
    for (auto const& shape : objects.shapes_on(objects.path_of(seen->object))) names += "/" + shape->name();
    return names;
  };
  CHECK(name_at({-2.2, 0.9, 0.3}) == "/all/row/left/part/ball");
  CHECK(name_at({2.2, -0.2, 0.5}) == "/all/row/right/part/plate");
  CHECK(name_at({0, 0, 0.5}) == "/all/row/middle");
  CHECK(name_at({0, 2.8, -0.5}) == "/all/above/row/middle");
  CHECK(name_at({3.8, 2, 0}) == "/last");
  CHECK(name_at({0, -2.5, -3}) == "/floor");
  CHECK(name_at({-5, 5, 0}) == "nothing");
}

TEST_CASE("smooth, bumpy and cut out surfaces show in normals, depth and objects", "[image][aov]") {
  REQUIRE_OPENCL_DEVICE();
  check_aovs(make_textured_scene(), "textured");
}

TEST_CASE("planes other than the picture can be shown as one", "[image][aov]") {
  Image depth(Resolution{3, 1});
  depth.data() = {2, 2, 2, 4, 4, 4, INFINITY, INFINITY, INFINITY};
  Image const grey = aov_as_picture(depth, Aov::depth);
  CHECK(grey.data()[0] == 1);
  CHECK((grey.data()[3] > 0 && grey.data()[3] < 0.2f));
  CHECK(grey.data()[6] == 0);
  Image normal(Resolution{2, 1});
  normal.data() = {0, 0, -1, 0, 0, 0};
  CHECK(aov_as_picture(normal, Aov::normal).data() == std::vector<float>{0.5f, 0.5f, 0, 0, 0, 0});
  Image ids(Resolution{3, 1});
  ids.data() = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  auto const colors = aov_as_picture(ids, Aov::object_id).data();
  CHECK((colors[0] == 0 && colors[1] == 0 && colors[2] == 0));
  double apart = 0;
  for (std::size_t c = 0; c < 3; ++c) apart += std::abs(double(colors[3 + c] - colors[6 + c]));
  CHECK(apart > 0.3);
}
