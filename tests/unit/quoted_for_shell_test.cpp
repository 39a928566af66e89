#include "core/quoted_for_shell.hpp"

#include "support/catch.hpp"

using lichtraum::quoted_for_shell;

TEST_CASE("words are quoted for a shell where they need it", "[unit]") {
  CHECK(quoted_for_shell("/data/shared-1_2.sdf") == "/data/shared-1_2.sdf");
  CHECK(quoted_for_shell("my folder") == "'my folder'");
  CHECK(quoted_for_shell("it's") == "'it'\\''s'");
  CHECK(quoted_for_shell("") == "''");
  CHECK(quoted_for_shell("~$HOME") == "'~$HOME'");
}
