#include <barrier>
#include <thread>
#include <vector>

#include "farm/plan.hpp"
#include "farm/unit_file.hpp"
#include "lichtraum/error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::farm;

namespace {

Plan plan_with_seed(std::uint64_t seed) {
  Plan plan;
  plan.version = "0.1.0";
  plan.job.scene = "hello.sdf";
  plan.job.seed = seed;
  plan.scenes = {{"hello.sdf", 1}};
  plan.region = {0, 0, 64, 48};
  plan.planes = {FilmPlane::radiance};
  plan.tile = {32, 32};
  return plan;
}

}  // namespace

TEST_CASE("of several plans for one folder that are made at once, one is there, and the others are told",
          "[unit][farm]") {
  constexpr int rounds = 20, planners = 4;
  for (int round = 0; round < rounds; ++round) {
    TemporaryFolder const folder;
    std::barrier start(planners);
    std::vector<ErrorKind> failures(planners, ErrorKind::internal);
    std::vector<int> is_made(planners);
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < planners; ++i) {
        threads.emplace_back([&, i] {
          start.arrive_and_wait();
          try {
            PlanFolder(folder.path(), plan_with_seed(std::uint64_t(i)));
            is_made[std::size_t(i)] = 1;
          } catch (Error const& error) {
            failures[std::size_t(i)] = error.kind();
          }
        });
      }
    }
    std::uint64_t const winner = PlanFolder(folder.path()).plan().job.seed;
    for (int i = 0; i < planners; ++i) {
      INFO("round " << round << ", plan " << i << " of " << winner);
      CHECK(is_made[std::size_t(i)] == (std::uint64_t(i) == winner));
      if (std::uint64_t(i) != winner) CHECK(failures[std::size_t(i)] == ErrorKind::cannot_create);
    }
    CHECK(folder.names() == std::vector<std::string>{"plan.json"});
  }
}

TEST_CASE("the same plan may be made for its folder again", "[unit][farm]") {
  TemporaryFolder const folder;
  PlanFolder const first(folder.path(), plan_with_seed(1)), second(folder.path(), plan_with_seed(1));
  CHECK(first.hash() == second.hash());
  CHECK_THROWS_AS(PlanFolder(folder.path(), plan_with_seed(2)), Error);
  CHECK(PlanFolder(folder.path()).plan().job.seed == 1);
}

TEST_CASE("a plan of many scenes can be read", "[unit][farm]") {
  Plan plan = plan_with_seed(1);
  plan.scenes.clear();
  for (int i = 0; i < 100'000; ++i) {  // minutes under sanitizers, if each were compared with all before it
    std::string const name = "frame" + std::to_string(i) + ".sdf";
    plan.scenes.push_back({name, 1});
    plan.files.push_back({name, "0123456789abcdef0123456789abcdef"});
  }
  CHECK(plan_from_json(to_json(plan)) == plan);
}

TEST_CASE("what is no plan is called so", "[unit][farm]") {
  CHECK_THROWS_WITH(plan_from_json(std::string(100, '[')), contains_text("not a plan: "));
}

TEST_CASE("a folder whose plan is gone gets no units", "[unit][farm]") {
  TemporaryFolder const folder;
  PlanFolder const plan(folder / "job", plan_with_seed(1));
  DrawnUnit unit{std::string(32, 'a'), {}, Film({0, 0, 32, 32}, {FilmPlane::radiance})};
  unit.film.set_end(1);
  write_unit(plan, 0, unit);
  CHECK(std::filesystem::exists(plan.unit_file(0)));
  // Where a share was unmounted, its folder is there still.
  for (bool const is_folder_left : {true, false}) {
    std::filesystem::remove_all(folder / "job");
    if (is_folder_left) std::filesystem::create_directory(folder / "job");
    try {
      write_unit(plan, 0, unit);
      FAIL("the unit was written");
    } catch (Error const& error) {
      CHECK(error.kind() == ErrorKind::try_again);
    }
    CHECK(std::filesystem::exists(folder / "job") == is_folder_left);
    if (is_folder_left) CHECK(std::filesystem::is_empty(folder / "job"));
  }
}
