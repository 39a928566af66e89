#include "view/problem_text.hpp"

#include <stdexcept>

#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

TEST_CASE("a window says what is wrong in a scene, and nothing of its dialect", "[unit][view]") {
  // A light with a brightness is a dialect, which is noted.
  std::string const scene = "define light lamp 0 0 5  1 1 1  2\ndefine nonsense\n";
  try {
    (void)EsdfScript::from_text(scene, "scene.sdf", {});
    FAIL("it was read");
  } catch (SceneError const& error) {
    CHECK_THAT(std::string(error.what()), contains_text("note: "));
    std::string const text = view::problem_text(error);
    CHECK_THAT(text, contains_text("scene.sdf:2:8: error: "));
    CHECK_THAT(text, !contains_text("note: "));
  }
  CHECK(view::problem_text(std::runtime_error("no memory")) == "no memory");
}
