#include <regex>
#include <set>

#include "lichtraum.hpp"
#include "lichtraum/model.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"

// What `cmake --install` puts in place for desktops, in a folder of its own.

namespace {

std::string run(std::filesystem::path const& folder, std::vector<std::string> const& words,
                std::map<std::string, std::string> const& environment = {}) {
  Process process;
  process.arguments = words;
  process.folder = folder;
  process.environment = environment;
  auto const result = run_process(process);
  INFO(words.front());
  INFO(result.out + result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

std::filesystem::path install(TemporaryFolder const& folder) {
  run(folder.path(),
      {LICHTRAUM_CMAKE, "--install", LICHTRAUM_BUILD_DIR, "--prefix", folder.path(), "--component", "desktop"});
  return folder / "share";
}

/// The value of a key of a desktop entry or a thumbnailer entry.
std::string value_of(std::string const& text, std::string const& key) {
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex("(?:^|\n)" + key + "=([^\n]*)")));
  return match[1];
}

std::set<std::string> parts(std::string const& list) {
  std::set<std::string> found;
  std::istringstream in(list);
  for (std::string part; std::getline(in, part, ';');) found.insert(part);
  return found;
}

/// The types of shared-mime-info and ours, where `mimetype` looks for them.
std::map<std::string, std::string> mime_database(TemporaryFolder const& folder) {
  auto const packages = install(folder) / "mime/packages";
  std::filesystem::copy_file("/usr/share/mime/packages/freedesktop.org.xml", packages / "freedesktop.org.xml");
  run(folder.path(), {"update-mime-database", (folder / "share/mime").string()});
  return {{"XDG_DATA_DIRS", (folder / "share").string()}, {"XDG_DATA_HOME", "/nonexistent"}};
}

char const* const without_mime = "shared-mime-info or mimetype (libfile-mimeinfo-perl) is not installed";
bool has_mime_tools() { return is_installed("update-mime-database") && is_installed("mimetype"); }

}  // namespace

TEST_CASE("the thumbnailer's command draws a thumbnail, as file managers run it", "[app][desktop]") {
  Lichtraum const lichtraum;
  std::string const entry = file_contents(install(lichtraum.folder) / "thumbnailers/lichtraum.thumbnailer");
  CHECK(entry.substr(0, 20) == "[Thumbnailer Entry]\n");
  CHECK(value_of(entry, "TryExec") == "lichtraum");
  std::string command = value_of(entry, "Exec");
  std::filesystem::copy_file(project_path("scenes/hello.sdf"), lichtraum.folder / "hello there.sdf");
  std::string const folder = lichtraum.folder.path();
  auto const fill_in = [&](std::string const& field, std::string const& value) {
    REQUIRE(command.find(field) != std::string::npos);
    command.replace(command.find(field), field.size(), value);
  };
  fill_in("%s", "128");
  fill_in("%i", "'" + folder + "/hello there.sdf'");
  fill_in("%o", "'" + folder + "/thumbnail.tmp'");
  CHECK(command.find('%') == std::string::npos);
  std::string const program_folder = std::filesystem::path(LICHTRAUM_PROGRAM).parent_path();
  run("/", {"sh", "-c", command},
      {{"PATH", program_folder + ":" + std::getenv("PATH")}, {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
  auto const picture = decode(lichtraum.folder.read("thumbnail.tmp"));
  REQUIRE(picture.width == 128);
  REQUIRE(picture.height == 72);
  // A grey background at the top, a pale floor at the bottom.
  CHECK(picture.at(64, 0, 2) > picture.at(64, 0, 0) + 5);
  CHECK(picture.at(64, 70, 0) > picture.at(64, 0, 0) + 40);
}

TEST_CASE("the desktop entry is valid and opens the window", "[app][desktop]") {
#ifdef LICHTRAUM_HAS_WINDOW
  TemporaryFolder const folder;
  auto const share = install(folder);
  auto const path = share / "applications/lichtraum.desktop";
  std::string const entry = file_contents(path);
  CHECK(value_of(entry, "Exec") == "lichtraum view %f");
  CHECK(std::filesystem::exists(share / "icons/hicolor/scalable/apps" / (value_of(entry, "Icon") + ".svg")));
  std::string const thumbnailer = file_contents(share / "thumbnailers/lichtraum.thumbnailer");
  CHECK(value_of(entry, "MimeType") == value_of(thumbnailer, "MimeType"));
  if (!is_installed("desktop-file-validate")) SKIP_TEST("desktop-file-utils is not installed");
  CHECK(run(folder.path(), {"desktop-file-validate", path}).empty());
#else
  SKIP_TEST("this build has no window");
#endif
}

TEST_CASE("what lichtraum reads has types that it opens, and they are its own extensions", "[app][desktop]") {
  if (!has_mime_tools()) SKIP_TEST(without_mime);
  TemporaryFolder const folder;
  mime_database(folder);
  // 50:model/obj:*.obj
  std::string const globs = file_contents(folder / "share/mime/globs2");
  std::set<std::string> without_extension =
      parts(value_of(file_contents(folder / "share/thumbnailers/lichtraum.thumbnailer"), "MimeType"));
  auto const types = without_extension;
  for (std::string const extension : {".sdf", ".esdf", ".gltf", ".glb", ".obj", ".ply", ".stl"}) {
    INFO(extension);
    int count = 0;
    for (std::string const& type : types) {
      bool const has_it = globs.find(":" + type + ":*" + extension + "\n") != std::string::npos;
      count += has_it;
      if (has_it) without_extension.erase(type);
    }
    CHECK(count == 1);
    CHECK((extension.find("sdf") != std::string::npos || lichtraum::is_model_file("a" + extension)));
  }
  CHECK(without_extension == std::set<std::string>{"application/vnd.ply"});  // which F3D brings
}

TEST_CASE("a scene without an extension is known, and no other text is taken for one", "[app][desktop]") {
  if (!has_mime_tools()) SKIP_TEST(without_mime);
  TemporaryFolder const folder;
  auto const environment = mime_database(folder);
  auto const type_of = [&](std::string const& name, std::string const& text) {
    folder.write(name, text);
    return run(folder.path(), {"mimetype", "-b", name}, environment);
  };
  std::string const statement = "define shape sphere ball 0 0 -3 1 red\n";
  CHECK(type_of("scene", statement) == "text/x-esdf\n");
  CHECK(type_of("scene", "# A ball.\n\n" + statement) == "text/x-esdf\n");
  CHECK(type_of("scene", read_project_file("scenes/hello.sdf")) == "text/x-esdf\n");
  CHECK(type_of("model", "ply\nformat ascii 1.0\n") == "model/x-ply\n");
  CHECK(type_of("notes", "We define shape and material.\n") == "text/plain\n");
  CHECK(type_of("header", "int a;\n#define shape 1\n") == "text/plain\n");
  CHECK(type_of("script", "#!/bin/sh\n" + statement) == "application/x-shellscript\n");
  CHECK(type_of("notes.txt", statement) == "text/plain\n");
  CHECK(type_of("notes.md", "# Scenes\n" + statement) == "text/markdown\n");
}
