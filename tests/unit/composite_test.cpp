#include <chrono>
#include <stdexcept>

#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"
#include "support/shape_hit.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::shared_ptr<Sphere> unit_sphere() { return std::make_shared<Sphere>("ball", Vec3(0), 1, nullptr); }

double distance(Vec3 const& a, Vec3 const& b) { return glm::length(a - b); }

double seconds_of(std::function<void()> const& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("a composite answers with its nearest child, in its parent's frame", "[unit][graph]") {
  auto const near = std::make_shared<Sphere>("near", Vec3(0, 0, 2), 0.5, nullptr);
  auto const far = std::make_shared<Box>("far", Vec3(-5, -5, -1), Vec3(5, 5, 0), nullptr);
  for (auto const& children : {Composite::Children{near, far}, Composite::Children{far, near}}) {
    Composite group("group", children);
    group.translate({10, 0, 0});
    Hit hit = hit_of(group, {{10, 0, 10}, {0, 0, -1}});
    CHECK(hit.t == Approx(7.5));
    CHECK(hit.shape == near.get());
    hit = hit_of(group, {{12, 0, 10}, {0, 0, -1}});
    CHECK(hit.t == Approx(10));
    CHECK(hit.shape == far.get());
    float t = -1;
    CHECK(group.intersect({{10, 0, 10}, {0, 0, -2}}, t));
    CHECK(t == Approx(3.75));
    CHECK(!group.intersect({{17, 0, 10}, {0, 0, -2}}, t));
  }
  CHECK(hit_of(Composite("empty"), {{0, 0, 5}, {0, 0, -1}}).shape == nullptr);
}

TEST_CASE("nesting is the product of the transforms, for points and for normals", "[unit][graph]") {
  auto const ball = unit_sphere();
  auto const inner = std::make_shared<Composite>("inner", Composite::Children{ball});
  auto const outer = std::make_shared<Composite>("outer", Composite::Children{inner});
  ball->scale({1, 3, -0.5});
  inner->rotate(40, {1, 2, 3});
  inner->scale({2, 1, 1});  // after a rotation: a shear as seen from the ball
  outer->translate({5, 6, 7});
  outer->rotate(-70, {0, 1, 1});

  Sphere flat("flat", Vec3(0), 1, nullptr);
  flat.set_world_from_object(outer->world_from_object() * inner->world_from_object() * ball->world_from_object());
  int hits = 0;
  Vec3 const center = flat.world_from_object().point(Vec3(0));
  for (int i = 0; i < 400; ++i) {
    Vec3 const origin = center + Vec3(0, 0, 12);
    Ray const ray{origin, Vec3(i % 20 - 10, i / 20 - 10, -30)};
    Hit const expected = hit_of(flat, ray);
    Hit const actual = hit_of(*outer, ray);
    REQUIRE((actual.shape != nullptr) == (expected.shape != nullptr));
    if (!expected.shape) continue;
    ++hits;
    REQUIRE(actual.t == Approx(expected.t).epsilon(1e-12));
    REQUIRE(distance(actual.normal, expected.normal) < 1e-9);
  }
  CHECK(hits > 20);
}

TEST_CASE("a child of two parents, or twice of one, is drawn once per path", "[unit][graph]") {
  auto const ball = unit_sphere();
  auto const left = std::make_shared<Composite>("left", Composite::Children{ball});
  auto const right = std::make_shared<Composite>("right", Composite::Children{ball});
  left->translate({-5, 0, 0});
  right->translate({5, 0, 0});
  right->scale({1, 2, 1});
  Composite const both("both", {left, right, left});
  CHECK(hit_of(both, {{-5, 0, 9}, {0, 0, -1}}).t == Approx(8));
  CHECK(hit_of(both, {{5, 1.9, 9}, {0, 0, -1}}).shape == ball.get());
  CHECK(hit_of(both, {{-5, 1.9, 9}, {0, 0, -1}}).shape == nullptr);
  ball->translate({0, 0, 1});  // a late transform moves every occurrence
  CHECK(hit_of(both, {{-5, 0, 9}, {0, 0, -1}}).t == Approx(7));
  CHECK(hit_of(both, {{5, 0, 9}, {0, 0, -1}}).t == Approx(7));
}

TEST_CASE("a composite cannot come to hold itself", "[unit][graph]") {
  auto const a = std::make_shared<Composite>("a");
  auto const b = std::make_shared<Composite>("b", Composite::Children{a});
  auto const c = std::make_shared<Composite>("c");
  c->add(b);
  CHECK_THROWS_AS(a->add(a), std::invalid_argument);
  CHECK_THROWS_AS(a->add(b), std::invalid_argument);
  CHECK_THROWS_WITH(a->add(c), contains_text("'a'"));
  CHECK(a->children().empty());
  c->add(a);  // a second path is none
  b->add(a);
  CHECK(c->children().size() == 2);
  CHECK_THROWS_AS(a->add(nullptr), std::invalid_argument);
  CHECK_THROWS_AS(Composite("n", {nullptr}), std::invalid_argument);
}

TEST_CASE("the search for a cycle visits shared nodes once", "[unit][graph]") {
  // 60 levels, each holding the one below twice: 2^60 paths.
  auto const bottom = std::make_shared<Composite>("bottom");
  std::shared_ptr<Composite> top = bottom;
  for (int i = 0; i < 60; ++i) top = std::make_shared<Composite>("level", Composite::Children{top, top});
  CHECK_THROWS_AS(bottom->add(top), std::invalid_argument);
  auto const other = std::make_shared<Composite>("other");
  auto const parent = std::make_shared<Composite>("parent", Composite::Children{other});
  other->add(top);  // searched to the end, since `other` has a parent
  CHECK(other->children().size() == 1);
}

TEST_CASE("100,000 nested composites are built, hit and destroyed without deep recursion", "[unit][graph]") {
  constexpr int depth = 100'000;
  auto const build = [](bool with_add) {
    std::shared_ptr<Shape> top = unit_sphere();
    for (int i = 0; i < depth; ++i) {
      auto const group = std::make_shared<Composite>("g");
      if (with_add) {
        group->add(top);
      } else {
        top = std::make_shared<Composite>("g", Composite::Children{top});
        top->translate({1e-5, 0, 0});
        continue;
      }
      group->translate({1e-5, 0, 0});
      top = group;
    }
    return top;
  };
  for (bool const with_add : {false, true}) {
    // Quadratic building takes minutes; ten seconds are for slow machines and sanitizers.
    CHECK(seconds_of([&] {
            std::shared_ptr<Shape> top = build(with_add);
            Hit const hit = hit_of(*top, {{1, 0, 5}, {0, 0, -1}});
            CHECK(hit.t == Approx(4).epsilon(1e-6));
            CHECK(distance(hit.normal, {0, 0, 1}) < 1e-6);
            auto const bottom = std::make_shared<Composite>("below");
            bottom->add(top);
            top.reset();
          }) < 10);
  }
}

TEST_CASE("a nested chain with siblings on the way is walked to its end", "[unit][graph]") {
  auto const ball = unit_sphere();
  std::shared_ptr<Shape> top = ball;
  for (int i = 0; i < 50'000; ++i) {
    auto const sibling = std::make_shared<Sphere>("far", Vec3(0, 0, -100), 0.5, nullptr);
    top =
        std::make_shared<Composite>("g", i % 2 ? Composite::Children{top, sibling} : Composite::Children{sibling, top});
  }
  CHECK(hit_of(*top, {{0, 0, 5}, {0, 0, -1}}).shape == ball.get());
}

TEST_CASE("a million children are added in linear time", "[unit][graph]") {
  auto const group = std::make_shared<Composite>("g");
  auto const parent = std::make_shared<Composite>("p", Composite::Children{group});
  auto const leaf = unit_sphere();
  auto const empty = std::make_shared<Composite>("e");
  CHECK(seconds_of([&] {
          for (int i = 0; i < 1'000'000; ++i) group->add(i % 2 ? std::shared_ptr<Shape>(leaf) : empty);
        }) < 10);
  CHECK(group->children().size() == 1'000'000);
}

TEST_CASE("children that others hold survive their composite", "[unit][graph]") {
  auto const ball = unit_sphere();
  auto inner = std::make_shared<Composite>("inner", Composite::Children{ball});
  { Composite const outer("outer", {inner, std::make_shared<Composite>("only", Composite::Children{inner})}); }
  CHECK(inner.use_count() == 1);
  REQUIRE(inner->children().size() == 1);
  inner.reset();
  CHECK(ball.use_count() == 1);
}
