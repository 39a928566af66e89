#include "view/unused_name.hpp"

#include <filesystem>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using lichtraum::view::unused_name;

TEST_CASE("what is saved gets the first name that is free", "[unit][view]") {
  TemporaryFolder const folder;
  std::string const stem = folder / "ball_view";
  CHECK(unused_name(stem, ".png") == stem + "_0001.png");
  folder.write("ball_view_0001.png", "");
  folder.write("ball_view_0003.png", "");
  CHECK(unused_name(stem, ".png") == stem + "_0002.png");
  std::filesystem::create_symlink("ball_view_0002.png", folder / "ball_view_0002.png");
  CHECK(unused_name(stem, ".png") == stem + "_0004.png");
  std::string const endless(300, 'x');
  CHECK(unused_name(endless, ".png") == endless + "_0001.png");  // the one who writes it says why it cannot be
}
