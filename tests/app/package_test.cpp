#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// The library as others use it: installed, moved to another folder, found by CMake and by pkg-config.

namespace {

namespace fs = std::filesystem;

ProcessResult run(fs::path const& folder, std::vector<std::string> const& words,
                  std::map<std::string, std::string> const& environment = {}) {
  Process process;
  process.arguments = words;
  process.folder = folder;
  process.environment = environment;
  process.timeout_seconds = 1800;  // a compiler may be slow
  return run_process(process);
}

std::string run_well(fs::path const& folder, std::vector<std::string> const& words,
                     std::map<std::string, std::string> const& environment = {}) {
  auto const result = run(folder, words, environment);
  INFO(words.front() << (words.size() > 1 ? " " + words[1] : ""));
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

/// The first block of that language in a document.
std::string documented(std::string const& language, char const* document = "docs/LIBRARY.md") {
  std::string const text = read_project_file(document);
  std::string const fence = "```" + language + "\n";
  std::size_t const begin = text.find(fence);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin + fence.size(), text.find("```", begin + 3) - begin - fence.size());
}

void replace(std::string& text, std::string const& what, std::string const& by) {
  std::size_t const at = text.find(what);
  INFO(what);
  REQUIRE(at != std::string::npos);
  text.replace(at, what.size(), by);
}

/// All of it installed to one folder, and then moved to another, which is returned.
fs::path installed(TemporaryFolder const& folder) {
  run_well(folder.path(), {LICHTRAUM_CMAKE, "--install", LICHTRAUM_BUILD_DIR, "--prefix", (folder / "here").string()});
  fs::rename(folder / "here", folder / "moved");
  return folder / "moved";
}

/// A folder with the documented program, built by a CMakeLists.txt.
void make_consumer(fs::path const& folder, std::string const& lists) {
  fs::create_directories(folder);
  std::ofstream(folder / "picture.cpp") << documented("cpp");
  std::ofstream(folder / "CMakeLists.txt") << lists;
}

std::vector<std::string> configure(fs::path const& prefix) {
  return {LICHTRAUM_CMAKE,
          "-G",
          "Ninja",
          "-S",
          ".",
          "-B",
          "build",
          "-D",
          "CMAKE_PREFIX_PATH=" + prefix.string(),
          "-D",
          "CMAKE_BUILD_TYPE=Release"};
}

/// The picture of hello.sdf by the program `lichtraum`, which the documented program has to give as well.
std::string const scene = project_path("scenes/hello.sdf");
std::string drawn_by(fs::path const& lichtraum, TemporaryFolder const& folder) {
  run_well(folder.path(), {lichtraum.string(), "render", "-q", scene, "-o", "drawn.ppm", "--size", "640x360"});
  std::string const picture = file_contents(folder / "drawn.ppm");
  REQUIRE(picture.size() > 640 * 360 * 3);
  return picture;
}

}  // namespace

TEST_CASE("documented programs compile without a warning", "[app][package]") {
  TemporaryFolder const folder;
  std::string const part = documented("cpp", "docs/JOB.md");
  std::string const include = "#include \"lichtraum/job.hpp\"\nusing namespace lichtraum;\n";
  folder.write("whole.cpp", documented("cpp"));
  folder.write("part.cpp", include + "void draw(std::string_view text) {\n" + part + "}\n");
  for (char const* const name : {"whole.cpp", "part.cpp"}) {
    run_well(folder.path(), {LICHTRAUM_CXX, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only",
                             "-I" + project_path("include"), "-I" + project_path("kernels"), name});
  }
}

TEST_CASE("programs find the installed library, link to it, and draw what the program draws", "[app][long][package]") {
  TemporaryFolder const folder;
  fs::path const prefix = installed(folder);
  fs::path const library = prefix / "lib";
  std::string const drawn = drawn_by(LICHTRAUM_PROGRAM, folder);

  SECTION("the shared one, by CMake") {
    make_consumer(folder / "shared", documented("cmake"));
    run_well(folder / "shared", configure(prefix));
    run_well(folder / "shared", {LICHTRAUM_CMAKE, "--build", "build"});
    run_well(folder / "shared", {"build/picture", scene});  // CMake leaves an rpath
    CHECK(file_contents(folder / "shared/picture.ppm") == drawn);
    CHECK_THAT(run_well(folder / "shared", {"ldd", "build/picture"}),
               contains_text((library / "liblichtraum.so.0").string()));
  }
  SECTION("the static one, by CMake") {
    std::string lists = documented("cmake");
    replace(lists, "REQUIRED)", "REQUIRED COMPONENTS static)");
    replace(lists, "lichtraum::lichtraum)", "lichtraum::lichtraum_static)");
    make_consumer(folder / "static", lists);
    run_well(folder / "static", configure(prefix));
    run_well(folder / "static", {LICHTRAUM_CMAKE, "--build", "build"});
    run_well(folder / "static", {"build/picture", scene});
    CHECK(file_contents(folder / "static/picture.ppm") == drawn);
    CHECK(run_well(folder / "static", {"ldd", "build/picture"}).find("liblichtraum") == std::string::npos);
  }
  SECTION("by pkg-config") {
    make_consumer(folder / "plain", "");
    std::string const flags = run_well(folder.path(), {"pkg-config", "--cflags", "--libs", "lichtraum"},
                                       {{"PKG_CONFIG_PATH", (library / "pkgconfig").string()}});
    std::vector<std::string> words{LICHTRAUM_CXX, "-std=c++20", "picture.cpp", "-o", "picture"};
    std::istringstream in(flags);
    words.insert(words.end(), std::istream_iterator<std::string>(in), {});
    run_well(folder / "plain", words);
    run_well(folder / "plain", {"./picture", scene}, {{"LD_LIBRARY_PATH", library.string()}});
    CHECK(file_contents(folder / "plain/picture.ppm") == drawn);
  }
}

namespace {

/// Configures a project that contains all of this one, in `folder`.
void make_containing_project(fs::path const& folder) {
  std::string lists = documented("cmake");
  replace(lists, "find_package(lichtraum 0.1 CONFIG REQUIRED)", "add_subdirectory(" + project_path("") + " lichtraum)");
  make_consumer(folder, lists);
  // Pictures have the same bytes as with -O3, and that would take minutes.
  std::vector<std::string> words = configure({});
  words.insert(words.end(), {"-D", "CMAKE_CXX_FLAGS_RELEASE=-O0", "-D", "LICHTRAUM_UNITY_BUILD=ON", "-D",
                             "LICHTRAUM_PRECOMPILE_KERNELS=OFF"});
  run_well(folder, words);
}

}  // namespace

TEST_CASE("a project that contains lichtraum builds its libraries and nothing else of it", "[app][long][package]") {
  TemporaryFolder const folder;
  make_containing_project(folder / "whole");
  std::string const all = run_well(folder / "whole", {"ninja", "-C", "build", "-t", "commands", "all"});
  CHECK_THAT(all, contains_text("picture.cpp"));
  CHECK_THAT(all, contains_text("liblichtraum.so"));
  for (char const* const other : {"src/app", "src/view", "tests/", "CLI11", "desktop"}) {
    INFO(other);
    CHECK(all.find(other) == std::string::npos);
  }
  // What it writes for its compiler, and with that its own file.
  std::string const target = "CMakeFiles/picture.dir/picture.cpp.o";
  run_well(folder / "whole", {LICHTRAUM_CMAKE, "--build", "build", "--target", "lichtraum_kernels", target});
  CHECK(fs::exists(folder / "whole/build" / target));
}

TEST_CASE("a project that contains lichtraum draws the same with it", "[app][long][package][.]") {
  TemporaryFolder const folder;
  make_containing_project(folder / "whole");
  run_well(folder / "whole", {LICHTRAUM_CMAKE, "--build", "build", "--parallel", "2", "--target", "picture"});
  run_well(folder / "whole", {"build/picture", scene});
  CHECK(file_contents(folder / "whole/picture.ppm") == drawn_by(LICHTRAUM_PROGRAM, folder));
}

TEST_CASE("Debian packages hold a program and a library that draw the same", "[app][long][package]") {
  for (char const* const needed : {"dpkg-deb", "dpkg-shlibdeps", "file", "cpack"}) {
    if (!is_installed(needed)) SKIP_TEST(std::string(needed) + " is not installed");
  }
  TemporaryFolder const folder;
  run_well(
      folder.path(), {project_path("tools/package"), "packages"},
      {{"LICHTRAUM_BUILT", LICHTRAUM_BUILD_DIR}, {"DEBFULLNAME", "Ada Lovelace"}, {"DEBEMAIL", "ada@lichtraum.org"}});
  std::vector<std::string> packages;
  for (auto const& entry : fs::directory_iterator(folder / "packages")) packages.push_back(entry.path().string());
  REQUIRE(packages.size() == 3);

  // Unpacked, without being root.
  for (std::string const& package : packages) {
    run_well(folder.path(), {"dpkg-deb", "-x", package, "system"});
    // What dpkg checks after an installation.
    run_well(folder.path(), {"dpkg-deb", "-e", package, "control"});
    run_well(folder / "system", {"md5sum", "--check", "--quiet", (folder / "control/md5sums").string()});
  }
  CHECK(fs::exists(folder / "system/usr/share/man/man1/lichtraum.1.gz"));
  CHECK(fs::exists(folder / "system/usr/share/doc/liblichtraum0/changelog.gz"));
  make_consumer(folder / "shared", documented("cmake"));
  run_well(folder / "shared", configure(folder / "system/usr"));
  run_well(folder / "shared", {LICHTRAUM_CMAKE, "--build", "build"});
  run_well(folder / "shared", {"build/picture", scene});
  CHECK(file_contents(folder / "shared/picture.ppm") == drawn_by(folder / "system/usr/bin/lichtraum", folder));
  CHECK(file_contents(folder / "drawn.ppm") == drawn_by(LICHTRAUM_PROGRAM, folder));
  CHECK_THAT(run_well(folder / "shared", {"ldd", "build/picture"}), contains_text((folder / "system/usr/").string()));

  if (!is_installed("lintian")) SKIP_TEST("lintian is not installed");
  // What is built for /usr/local lies in lib; in /usr/lib that one is for one architecture only.
  std::vector<std::string> words{"lintian",       "--no-cfg",        "--fail-on",
                                 "error,warning", "--suppress-tags", "pkg-config-unavailable-for-cross-compilation"};
  words.insert(words.end(), packages.begin(), packages.end());
  run_well(folder.path(), words);
}

TEST_CASE("another version than this is not found", "[app][long][package]") {
  TemporaryFolder const folder;
  fs::path const prefix = installed(folder);
  for (char const* const version : {"99", "0.2", "0.0"}) {
    std::string lists = documented("cmake");
    replace(lists, "0.1", version);
    make_consumer(folder / version, lists);
    auto const result = run(folder / version, configure(prefix));
    INFO(result.err);
    CHECK(result.exit_code != 0);
    CHECK_THAT(result.err, contains_text("compatible with requested version"));
  }
}

TEST_CASE("the shared library shows what is in its namespace, and each header can be included alone",
          "[app][long][package]") {
  TemporaryFolder const folder;
  fs::path const prefix = installed(folder);
  std::istringstream symbols(
      run_well(folder.path(), {"nm", "-DC", "--defined-only", (prefix / "lib/liblichtraum.so").string()}));
  std::regex const ours("^[0-9a-f]+ . ((typeinfo|typeinfo name|vtable) for )?lichtraum::.*");
  int count = 0;
  for (std::string line; std::getline(symbols, line); ++count) {
    INFO(line);
    CHECK(std::regex_match(line, ours));
    CHECK(line.find("lichtraum::cl::") == std::string::npos);
  }
  CHECK(count > 150);

  int headers = 0;
  for (auto const& entry : fs::directory_iterator(prefix / "include/lichtraum")) {
    if (!entry.is_regular_file()) continue;
    ++headers;
    std::string const name = entry.path().filename().string();
    std::ofstream(folder / (name + ".cpp")) << "#include \"lichtraum/" << name << "\"\n";
  }
  CHECK(headers > 40);
  // Two at a time: a compiler for each takes long.
  std::string const compile = "ls *.cpp | xargs -P 2 -n 8 " LICHTRAUM_CXX
                              " -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I " +
                              (prefix / "include").string() + " -I " + (prefix / "include/lichtraum/kernels").string();
  run_well(folder.path(), {"sh", "-c", compile});
}
