#include <fmt/format.h>

#include "lichtraum.hpp"
#include "support/catch.hpp"

TEST_CASE("a scene that is far from the origin for its size is told, with where to move it", "[app][check]") {
  Lichtraum const lichtraum;
  auto const said = [&](std::string const& command, double distance, std::string const& more = "") {
    lichtraum.folder.write("a.sdf", fmt::format("define material m 1 0 0  1 0 0  0 0 0  10\n"
                                                "define shape sphere ball {} 0 -5  1  m\n"
                                                "{}define light ambient sky 0.5 0.5 0.5\n"
                                                "define camera eye 45\n"
                                                "transform eye translate {} 0 0\n"
                                                "render eye a.png 32 24\n",
                                                distance, more, distance));
    auto const result = lichtraum(command + " --device reference a.sdf");
    CHECK(result.exit_code == 0);
    return result.err;
  };
  for (std::string const command : {"render", "check"}) {
    CAPTURE(command);
    CHECK_THAT(said(command, 500000),
               contains_text("warning: the scene is 2 across and 5e+05 from the origin, where the device's numbers are "
                             "0.06 apart: details are lost [W0824]\n") &&
                   contains_text("hint: move it, with its cameras and lights, by -500000 0 5\n"));
    CHECK_THAT(said(command, -20002), contains_text("[W0824]") && contains_text("by 20002 0 5\n"));
    CHECK_THAT(said(command, 0), !contains_text("W0824"));
    CHECK_THAT(said(command, 19900), !contains_text("W0824"));
    // What is large has no details that are lost, nor has a plane, which is everywhere.
    CHECK_THAT(said(command, 500000, "define shape box floor 0 -2 0 1000 -1 1000 m\n"), !contains_text("W0824"));
    CHECK_THAT(said(command, 0, "define shape plane floor 0 -1e6 0  0 1 0 m\n"), !contains_text("W0824"));
  }
}
