#include "view/folder_files.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using lichtraum::view::FolderFiles;

TEST_CASE("the window goes through the scenes and models of a folder", "[unit][view]") {
  TemporaryFolder const folder;
  for (char const* const name : {"part10.stl", "part2.GLB", "part1.sdf", "notes.txt", "part2.png", "z.obj", "part3"}) {
    folder.write(name, "");
  }
  std::filesystem::create_directory(folder / "part4.sdf");
  auto const at = [&](char const* name) { return std::optional(std::filesystem::path(folder / name)); };

  FolderFiles files(folder / "part1.sdf");
  for (char const* const name : {"part2.GLB", "part10.stl", "z.obj", "part1.sdf"}) CHECK(files.step(1) == at(name));
  for (char const* const name : {"z.obj", "part10.stl", "part2.GLB", "part1.sdf"}) CHECK(files.step(-1) == at(name));

  files.open(folder / "part3");  // of no extension that is known: its place counts
  CHECK(files.step(1) == at("part10.stl"));
  files.open(folder / "part3");
  CHECK(files.step(-1) == at("part2.GLB"));
  files.open(folder / "nowhere" / "part3.sdf");
  CHECK(files.step(1) == std::nullopt);
}

TEST_CASE("files that cannot be read are skipped, once around at most", "[unit][view]") {
  TemporaryFolder const folder;
  for (char const* const name : {"a.sdf", "b.sdf", "c.sdf", "d.sdf"}) folder.write(name, "");
  auto const at = [&](char const* name) { return std::optional(std::filesystem::path(folder / name)); };

  FolderFiles files(folder / "a.sdf");
  CHECK(files.skip() == std::nullopt);  // it was named, not stepped to
  CHECK(files.step(1) == at("b.sdf"));
  CHECK(files.skip() == at("c.sdf"));
  files.arrive();
  CHECK(files.skip() == std::nullopt);  // it breaks later: it stays

  CHECK(files.step(-1) == at("b.sdf"));
  CHECK(files.skip() == at("a.sdf"));
  CHECK(files.skip() == at("d.sdf"));
  CHECK(files.skip() == at("c.sdf"));  // where it began
  CHECK(files.skip() == std::nullopt);

  files.step(1);
  files.open(folder / "a.sdf");
  CHECK(files.skip() == std::nullopt);
}
