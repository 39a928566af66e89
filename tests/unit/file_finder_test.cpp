#include "io/file_finder.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
namespace fs = std::filesystem;

namespace {

/// The path of a name in the folder itself; empty where nothing is found.
std::string found_in(std::optional<fs::path> const& folder, std::string const& name,
                     std::vector<fs::path> const& allowed = {}) {
  fs::path const homes[] = {""};
  auto const found = FileFinder(folder, allowed).find(name, homes);
  return found ? found->path : "";
}

}  // namespace

TEST_CASE("files are found in any letter case, and as written first", "[unit][path]") {
  TemporaryFolder const folder;
  for (char const* const name : {"Tex.png", "TEX.png", "tex.PNG"}) folder.write(name, "");
  CHECK(found_in(folder.path(), "TEX.png") == "TEX.png");
  CHECK(found_in(folder.path(), "tex.PNG") == "tex.PNG");
  CHECK(found_in(folder.path(), "tex.png") == "TEX.png");  // the same everywhere
  CHECK(found_in(folder.path(), "'./sub/../Tex.png'") == "Tex.png");
  CHECK(found_in(folder.path(), "texx.png").empty());
  CHECK(found_in(folder.path(), "").empty());
  CHECK(found_in(folder.path(), "..").empty());
  CHECK(found_in(std::nullopt, "Tex.png").empty());
}

TEST_CASE("files are found in the folders alone that may be read", "[unit][path]") {
  TemporaryFolder const folder;
  for (char const* const name : {"model", "model/tex", "other", "other/sub"}) fs::create_directories(folder / name);
  folder.write("other/secret.png", "");
  folder.write("other/sub/secret2.png", "");
  fs::create_symlink("../other", folder / "model/textures");
  fs::create_symlink("../../other/secret.png", folder / "model/tex/link.png");
  fs::path const model = folder / "model";
  std::string const secret = (folder / "other/SECRET.png").string();
  for (std::string const& name : {std::string("secret.png"), std::string("textures/Secret.png"), secret,
                                  std::string("../other/SECRET.png"), std::string("link.png")}) {
    INFO(name);
    CHECK(found_in(model, name).empty());
    CHECK(!found_in(model, name, {folder.path()}).empty());
  }
  CHECK(found_in(model, secret, {folder / "other/"}) == folder / "other/secret.png");
  CHECK(found_in(model, "../OTHER/SUB/Secret2.png", {folder.path()}) == folder / "other/sub/secret2.png");
}

TEST_CASE("folders of very many files are not searched", "[unit][path]") {
  TemporaryFolder const folder;
  for (char const* const name : {"tex", "textures", "few"}) fs::create_directories(folder / name);
  for (std::size_t i = 0; i < FileFinder::max_entries; ++i) folder.write("textures/" + std::to_string(i) + ".png", "");
  folder.write("tex/A.png", "");
  folder.write("few/A.png", "");
  fs::path const homes[] = {""};
  std::optional<fs::path> const model = folder.path();
  FileFinder finder(model, {});
  CHECK(finder.find("few/a.png", homes)->path == "few/A.png");
  CHECK(!finder.find("a.png", homes));  // after textures nothing more is listed
  CHECK(!finder.find("1.PNG", homes));
  CHECK(finder.find("few/a.png", homes));  // what was seen is known
}
