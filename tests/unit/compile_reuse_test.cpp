#include <cstring>

#include "compile/scene_buffers.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"

// What compile_scene takes from the scene before is what it would have built.

using namespace lichtraum;

namespace {

using Shapes = std::vector<std::shared_ptr<Shape const>>;

struct TwoParts {
  std::shared_ptr<Composite> ladder = std::make_shared<Composite>("ladder");  // shown twice
  std::shared_ptr<Composite> left = std::make_shared<Composite>("left");
  std::shared_ptr<Composite> right = std::make_shared<Composite>("right");
  std::shared_ptr<Sphere> ball = std::make_shared<Sphere>("ball", Vec3(0, 5, 0), 1, nullptr);

  TwoParts() {
    for (int i = 0; i < 20; ++i) {
      double const x = i;
      ladder->add(std::make_shared<Triangle>("t", Vec3(x, 0, 0), Vec3(x, 1, 0), Vec3(x, 0, 1), nullptr));
      ladder->add(std::make_shared<Sphere>("s", Vec3(x, 2, 0), 0.3, nullptr));
    }
    left->add(ladder);
    right->add(ladder);
    right->translate({0, 0, 10});
  }
  Shapes roots() const { return {left, right, ball}; }
};

template <class T, class Allocator>
bool same(std::vector<T, Allocator> const& a, std::vector<T, Allocator> const& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), sizeof(T) * a.size()) == 0);
}

bool same_arrays(SceneBuffers const& a, SceneBuffers const& b) {
  return same(a.nodes, b.nodes) && same(a.references, b.references) && same(a.triangles, b.triangles) &&
         same(a.wide_nodes, b.wide_nodes) && same(a.triangle_blocks, b.triangle_blocks) &&
         same(a.triangle_tags, b.triangle_tags) && same(a.spheres, b.spheres) &&
         same(a.sphere_blocks, b.sphere_blocks) && same(a.instances, b.instances) && a.root_node == b.root_node &&
         a.stack_size == b.stack_size && a.crowding == b.crowding && a.flat_instances == b.flat_instances &&
         a.unrepresentable == b.unrepresentable;
}

}  // namespace

TEST_CASE("a scene compiled after another is the same as compiled alone", "[unit][compile]") {
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    TwoParts parts;
    SceneBuffers before = compile_scene(flatten(parts.roots()), {}, layout);
    std::vector<std::function<void()>> const changes{
        [] {},
        [&] {
          parts.ball->translate({1, 2, 3});
        },
        [&] {
          parts.right->rotate(30, {0, 1, 0});
        },
        [&] { parts.ladder->add(std::make_shared<Sphere>("more", Vec3(0), 1, nullptr)); },
        [&] { parts.left->add(std::make_shared<Box>("box", Vec3(0), Vec3(1), nullptr)); },
        [&] {  // so that only the ladder's inside changes: where it is placed stays as it is
          for (int i = 0; i < 300; ++i) {
            parts.ladder->add(std::make_shared<Sphere>("inside", Vec3(1 + 0.05 * i, 0.5, 0.5), 0.1, nullptr));
          }
        },
    };
    for (auto const& change : changes) {
      change();
      SceneBuffers const alone = compile_scene(flatten(parts.roots()), {}, layout);
      SceneBuffers const after = compile_scene(flatten(parts.roots()), {}, layout, &before);
      CHECK(same_arrays(after, alone));
      before = compile_scene(flatten(parts.roots()), {}, layout);
    }
  }
}

TEST_CASE("an object that stays is found again after one whose blocks have become more", "[unit][compile]") {
  bool const has_spheres = GENERATE(true, false);
  // Groups of spheres or triangles, far from each other.
  auto const row = [&](std::vector<int> const& groups) {
    auto composite = std::make_shared<Composite>("row");
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (int i = 0; i < groups[g]; ++i) {
        Vec3 const at(100. * double(g) + i, 0, 0);
        if (has_spheres) {
          composite->add(std::make_shared<Sphere>("s", at, 0.3, nullptr));
        } else {
          composite->add(std::make_shared<Triangle>("t", at, at + Vec3(0, 0.3, 0), at + Vec3(0, 0, 0.3), nullptr));
        }
      }
    }
    return composite;
  };
  auto const twice = [](std::shared_ptr<Composite> const& part, double z) {
    auto moved = std::make_shared<Composite>("moved");
    moved->add(part);
    moved->translate({0, 0, z});
    auto both = std::make_shared<Composite>("both");
    both->add(part);
    both->add(moved);
    return both;
  };
  auto const staying = twice(row({4, 4, 4, 4}), 20);
  Shapes const before_roots{twice(row({4, 4, 4, 4, 4}), 10), staying};
  Shapes const after_roots{twice(row({3, 3, 3, 3, 3, 3, 2}), 10), staying};
  SceneBuffers const before = compile_scene(flatten(before_roots), {}, TreeLayout::wide);
  SceneBuffers const alone = compile_scene(flatten(after_roots), {}, TreeLayout::wide);
  auto const blocks_of = [](SceneBuffers const& buffers) {
    return buffers.sphere_blocks.size() + buffers.triangle_blocks.size();
  };
  REQUIRE(blocks_of(before) < blocks_of(alone));
  CHECK(same_arrays(compile_scene(flatten(after_roots), {}, TreeLayout::wide, &before), alone));
}

TEST_CASE("what is left out of a hierarchy is counted though the hierarchy is taken over", "[unit][compile]") {
  TwoParts parts;
  // Center and radius fit a float, their sum does not.
  parts.ladder->add(std::make_shared<Sphere>("huge", Vec3(3e38, 0, 0), 3e38, nullptr));
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    SceneBuffers const before = compile_scene(flatten(parts.roots()), {}, layout);
    CHECK(before.unrepresentable == 1);  // of the object that is shown twice
    SceneBuffers const after = compile_scene(flatten(parts.roots()), {}, layout, &before);
    CHECK(same_arrays(after, before));
  }
}

TEST_CASE("only what has changed is built again", "[unit][compile]") {
  TwoParts parts;
  SceneBuffers before = compile_scene(flatten(parts.roots()), {}, TreeLayout::wide);
  REQUIRE(before.objects.size() == 2);
  // A mark in both hierarchies shows which of them is taken over.
  for (CompiledObject const& object : before.objects) before.wide_nodes[object.root_node].bounds[0][0] = -12345;
  auto const marks = [&] {
    SceneBuffers const after = compile_scene(flatten(parts.roots()), {}, TreeLayout::wide, &before);
    std::vector<bool> found;
    for (CompiledObject const& object : after.objects) {
      found.push_back(after.wide_nodes[object.root_node].bounds[0][0] == -12345);
    }
    return found;
  };
  CHECK(marks() == std::vector<bool>{true, true});
  parts.ball->translate({1, 0, 0});
  CHECK(marks() == std::vector<bool>{true, false});  // the ladder's, not the world's
}

TEST_CASE("a large part that moves as one is not built again for what moves", "[unit][compile]") {
  auto part = std::make_shared<Composite>("part");
  for (int i = 0; i < 5000; ++i) part->add(std::make_shared<Sphere>("s", Vec3(i, 2, 0), 0.3, nullptr));
  part->set_moves_as_one(true);
  auto const ball = std::make_shared<Sphere>("ball", Vec3(0, 5, 0), 1, nullptr);
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    // A mark in the part's hierarchy shows where it comes from.
    constexpr float mark = -12345;
    auto const marked = [&](SceneBuffers& scene, CompiledObject const& object) -> float& {
      return layout == TreeLayout::binary ? scene.nodes[object.root_node].children[0].min[0]
                                          : scene.wide_nodes[object.root_node].bounds[0][0];
    };
    SceneBuffers before = compile_scene(flatten({part, ball}), {}, layout);
    REQUIRE(before.objects.size() == 2);
    REQUIRE(before.instances.size() == 1);
    marked(before, before.objects[0]) = mark;
    auto const is_taken_over = [&] {
      SceneBuffers after = compile_scene(flatten({part, ball}), {}, layout, &before);
      return marked(after, after.objects[0]) == mark;
    };
    CHECK(is_taken_over());
    ball->translate({1, 0, 0});
    CHECK(is_taken_over());
    part->rotate(30, {0, 1, 0});
    part->scale({1, 2, -3});
    CHECK(is_taken_over());
    part->children()[17]->translate({0, 0, 1});
    CHECK_FALSE(is_taken_over());
  }
}

TEST_CASE("shapes whose squares are no floats are left out, and counted", "[unit][compile]") {
  auto const left_out = [](std::shared_ptr<Shape const> const& shape) {
    return compile_scene(flatten({shape}), {}, TreeLayout::wide).unrepresentable;
  };
  CHECK(left_out(std::make_shared<Sphere>("s", Vec3(9e17, 0, 0), 0.9e17, nullptr)) == 0);
  CHECK(left_out(std::make_shared<Sphere>("s", Vec3(-9e17, 0, 0), 2e17, nullptr)) == 1);
  CHECK(left_out(std::make_shared<Sphere>("s", Vec3(0, 1e37, 0), 1e36, nullptr)) == 1);
  CHECK(left_out(std::make_shared<Triangle>("t", Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, 9e17), nullptr)) == 0);
  CHECK(left_out(std::make_shared<Triangle>("t", Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, -2e18), nullptr)) == 1);
  CHECK(left_out(std::make_shared<Box>("b", Vec3(0), Vec3(1e30), nullptr)) == 0);
}
