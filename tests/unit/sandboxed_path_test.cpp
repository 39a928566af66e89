#include "lichtraum/sandboxed_path.hpp"

#include <fstream>
#include <vector>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
namespace fs = std::filesystem;

namespace {

/// base/{file.glb, sub/, links...} beside outside/secret.glb
struct Tree {
  TemporaryFolder folder;
  fs::path base = fs::canonical(folder.path()) / "base";
  fs::path outside = fs::canonical(folder.path()) / "outside";

  Tree() {
    fs::create_directories(base / "sub");
    fs::create_directories(outside);
    std::ofstream(base / "file.glb") << "x";
    std::ofstream(outside / "secret.glb") << "x";
    fs::create_symlink(outside / "secret.glb", base / "to_secret");
    fs::create_symlink("../outside", base / "to_outside");
    fs::create_symlink("../outside/new.glb", base / "to_nothing");
    fs::create_symlink("loop_b", base / "loop_a");
    fs::create_symlink("loop_a", base / "loop_b");
    fs::create_symlink("sub/../file.glb", base / "inside");
    fs::create_symlink(base, outside / "back");
    fs::create_symlink(base, folder.path() / "alias");
  }
};

}  // namespace

TEST_CASE("paths below the folder are resolved", "[unit][path]") {
  Tree const tree;
  CHECK(resolve_sandboxed(tree.base, "file.glb").path == tree.base / "file.glb");
  CHECK(resolve_sandboxed(tree.base, "./file.glb").path == tree.base / "file.glb");
  CHECK(resolve_sandboxed(tree.base, "sub//new.png").path == tree.base / "sub" / "new.png");
  CHECK(resolve_sandboxed(tree.base, "new/folder/new.png").path == tree.base / "new" / "folder" / "new.png");
  CHECK(resolve_sandboxed(tree.base, "..file").path == tree.base / "..file");
  CHECK(resolve_sandboxed(tree.base, "inside").path == tree.base / "file.glb");
  CHECK(resolve_sandboxed(tree.folder.path() / "alias", "file.glb").path == tree.base / "file.glb");
  CHECK(resolve_sandboxed("", "x.png").path == fs::current_path() / "x.png");
}

TEST_CASE("paths that leave the folder are refused, with the reason", "[unit][path]") {
  Tree const tree;
  auto const reason = [&](fs::path const& requested) {
    SandboxedPath const result = resolve_sandboxed(tree.base, requested);
    CHECK_FALSE(result);
    CHECK(result.path.empty());
    return result.reason;
  };
  CHECK(reason("") == "it is empty");
  CHECK(reason(".") == "it is the folder itself");
  CHECK(reason("/etc/passwd") == "it is an absolute path");
  CHECK(reason(tree.base / "file.glb") == "it is an absolute path");
  CHECK(reason("../outside/secret.glb") == "it contains '..'");
  CHECK(reason("sub/../file.glb") == "it contains '..'");
  CHECK(reason("..") == "it contains '..'");
  CHECK(reason("to_secret") == "a symbolic link leads out of '" + tree.base.string() + "'");
  CHECK(reason("to_outside/secret.glb") == "a symbolic link leads out of '" + tree.base.string() + "'");
  CHECK(reason("to_nothing") == "a symbolic link leads out of '" + tree.base.string() + "'");
  CHECK(reason("loop_a") == "its symbolic links form a loop");
  CHECK(reason(fs::path(std::string("a\0b", 3))) == "it contains a NUL character");
  CHECK_FALSE(reason(std::string(10'000, 'x')).empty());
  // A folder whose name starts like the base's is not below it.
  fs::create_directories(tree.folder.path() / "base2");
  fs::create_symlink("../base2", tree.base / "to_base2");
  CHECK_FALSE(reason("to_base2/x").empty());
}

TEST_CASE("what one more allowed folder would permit is told apart", "[unit][path]") {
  Tree const tree;
  for (char const* const requested : {"/etc/passwd", "../outside/secret.glb", "to_secret"}) {
    CHECK(resolve_sandboxed(tree.base, requested).is_outside);
  }
  for (char const* const requested : {"", ".", "loop_a", "file.glb"}) {
    CHECK_FALSE(resolve_sandboxed(tree.base, requested).is_outside);
  }
}

TEST_CASE("allowed folders may be reached in every way", "[unit][path]") {
  Tree const tree;
  std::vector<fs::path> const allowed{tree.outside};
  fs::path const secret = tree.outside / "secret.glb";
  for (fs::path const& requested :
       {fs::path("../outside/secret.glb"), secret, fs::path("to_secret"), fs::path("to_outside/secret.glb")}) {
    INFO(requested);
    CHECK(resolve_sandboxed(tree.base, requested, allowed).path == secret);
  }
  CHECK_FALSE(resolve_sandboxed(tree.base, "/etc/passwd", allowed));
  CHECK_FALSE(resolve_sandboxed(tree.base, "../outside/../base2", allowed));
  CHECK_FALSE(resolve_sandboxed(tree.base, "../outside", allowed));
  // What leads from an allowed folder elsewhere is judged by where it ends.
  CHECK_FALSE(resolve_sandboxed(tree.outside, "back/file.glb", allowed));
}
