#include "core/read_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;

namespace {

struct Failure {
  ErrorKind kind;
  std::string message;
};

Failure failure_of(std::filesystem::path const& path, std::size_t stream_limit = max_stream_bytes) {
  try {
    read_file(path, stream_limit);
  } catch (Error const& error) {
    return {error.kind(), error.what()};
  }
  FAIL("'" << path.string() << "' was read");
  return {ErrorKind::internal, ""};
}

}  // namespace

TEST_CASE("a file's bytes are read as they are", "[unit]") {
  TemporaryFolder const folder;
  for (std::size_t const size : {0, 1, 65'535, 65'536, 65'537, 1'000'000}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 7);
    std::ofstream(folder.path() / "f", std::ios::binary) << bytes;
    CHECK(read_file(folder.path() / "f") == bytes);
  }
}

TEST_CASE("what cannot be opened is no input", "[unit]") {
  TemporaryFolder const folder;
  Failure const missing = failure_of(folder.path() / "missing.sdf");
  CHECK(missing.kind == ErrorKind::no_input);
  CHECK_THAT(missing.message, contains_text("missing.sdf': No such file or directory"));
  Failure const is_folder = failure_of(folder.path());
  CHECK(is_folder.kind == ErrorKind::no_input);
  CHECK_THAT(is_folder.message, contains_text("it is a folder"));
  CHECK(failure_of("").kind == ErrorKind::no_input);
  std::ofstream(folder.path() / "f") << "x";
  CHECK(failure_of(folder.path() / "f" / "g").kind == ErrorKind::no_input);
  if (::geteuid() != 0) {  // root may read everything
    ::chmod((folder.path() / "f").c_str(), 0);
    CHECK(failure_of(folder.path() / "f").kind == ErrorKind::no_input);
  }
}

TEST_CASE("pipes are read to their end, devices up to a limit", "[unit]") {
  TemporaryFolder const folder;
  std::string const pipe = (folder.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string const text(300'000, '#');
  std::thread writer([&] { std::ofstream(pipe) << text; });
  CHECK(read_file(pipe) == text);
  writer.join();
  CHECK(read_file("/dev/null").empty());
  Failure const endless = failure_of("/dev/zero", 1'000'000);
  CHECK(endless.kind == ErrorKind::io);
  CHECK_THAT(endless.message, contains_text("longer than 1000000 bytes"));
}

TEST_CASE("scenes come from files", "[unit][esdf]") {
  TemporaryFolder const folder;
  auto const path = folder.path() / "scene.sdf";
  std::ofstream(path) << "define camera eye 45\n";
  CHECK(load_esdf(path).cameras.size() == 1);
  CHECK_THROWS_AS(load_esdf(folder.path() / "other.sdf"), Error);

  std::ofstream(path) << "nonsense\n";
  try {
    load_esdf(path);
    FAIL("loaded");
  } catch (SceneError const& error) {
    CHECK(error.kind() == ErrorKind::scene);
    CHECK(error.diagnostics().at(0).location.file == path.string());
  }
}
