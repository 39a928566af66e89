#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <thread>

#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
namespace fs = std::filesystem;

namespace {

template <class Function>
Error error_of(Function const& function) {
  try {
    function();
  } catch (Error const& error) {
    return error;
  }
  FAIL("nothing was thrown");
  throw;
}

mode_t permissions(fs::path const& path) {
  struct stat status {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

/// The exit status of a child process that does `work`.
int in_child(std::function<int()> const& work) {
  pid_t const child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a file is written whole and nothing else is left", "[unit][file]") {
  TemporaryFolder const folder;
  std::string const bytes(1'000'000, 'x');
  write_file_atomically(folder / "new.png", bytes);
  CHECK(folder.read("new.png") == bytes);
  write_file_atomically(folder / "new.png", "short");
  CHECK(folder.read("new.png") == "short");
  CHECK(folder.names() == std::vector<std::string>{"new.png"});
  std::string const long_name = std::string(251, 'n') + ".png";  // as long as names may be
  write_file_atomically(folder / long_name, "x");
  CHECK(folder.read(long_name) == "x");
}

TEST_CASE("a new file obeys the umask, a replaced one keeps its permissions", "[unit][file]") {
  TemporaryFolder const folder;
  mode_t const old_mask = ::umask(027);
  write_file_atomically(folder / "new.png", "x");
  ::umask(old_mask);
  CHECK(permissions(folder / "new.png") == 0640);
  ::chmod((folder / "new.png").c_str(), 0604);
  write_file_atomically(folder / "new.png", "y");
  CHECK(permissions(folder / "new.png") == 0604);
}

TEST_CASE("symbolic links are written through and stay links", "[unit][file]") {
  TemporaryFolder const folder;
  fs::create_directory(folder / "sub");
  folder.write("sub/real.png", "old");
  fs::create_symlink("sub/real.png", folder / "link.png");
  fs::create_symlink("link.png", folder / "link2.png");
  fs::create_symlink("sub/later.png", folder / "dangling.png");
  fs::create_symlink("circle.png", folder / "circle.png");

  check_writable(folder / "link2.png");
  write_file_atomically(folder / "link2.png", "new");
  CHECK(folder.read("sub/real.png") == "new");
  CHECK(fs::is_symlink(folder / "link2.png"));
  CHECK(fs::is_symlink(folder / "link.png"));
  write_file_atomically(folder / "dangling.png", "new");
  CHECK(folder.read("sub/later.png") == "new");
  CHECK(fs::is_symlink(folder / "dangling.png"));
  CHECK(error_of([&] { check_writable(folder / "circle.png"); }).kind() == ErrorKind::cannot_create);
}

TEST_CASE("what cannot be written is refused with the reason, and leaves nothing", "[unit][file]") {
  TemporaryFolder const folder;
  folder.write("file", "x");
  auto const refused = [&](fs::path const& path, std::string const& why) {
    INFO(path);
    for (auto const& function :
         std::vector<std::function<void()>>{[&] { check_writable(path); }, [&] { write_file_atomically(path, "x"); }}) {
      Error const error = error_of(function);
      CHECK(error.kind() == ErrorKind::cannot_create);
      CHECK_THAT(error.what(), contains_text(why));
    }
  };
  refused(folder / "missing/x.png", "no folder");
  refused(folder / "file/x.png", "not a folder");
  refused(folder.path(), "it is a folder");
  refused(folder / "new/", "no file name");
  refused("", "empty");
  refused(folder / std::string(300, 'n'), "too long");
  refused("/proc/x.png", "/proc");
  check_writable(folder / "good.png");
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("read-only files and folders are refused", "[unit][file]") {
  TemporaryFolder const folder;
  folder.write("old.png", "old");
  fs::create_directory(folder / "locked");
  // Root may write anything: a child without privileges tries.
  ::chmod(folder.path().c_str(), 0777);
  ::chmod((folder / "old.png").c_str(), 0444);
  ::chmod((folder / "locked").c_str(), 0555);
  int const status = in_child([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) return 1;
    for (fs::path const& path : {folder / "old.png", folder / "locked/new.png"}) {
      try {
        check_writable(path);
        return 2;
      } catch (Error const& error) {
        if (error.kind() != ErrorKind::cannot_create) return 3;
      }
    }
    return 0;
  });
  CHECK(status == 0);
  CHECK(folder.read("old.png") == "old");
}

TEST_CASE("a full device and a size limit are I/O errors, and the old file stays", "[unit][file]") {
  Error const full = error_of([] { write_file_atomically("/dev/full", "x"); });
  CHECK(full.kind() == ErrorKind::io);
  CHECK_THAT(full.what(), contains_text("/dev/full") && contains_text("disk is full"));

  TemporaryFolder const folder;
  folder.write("old.png", "old");
  int const status = in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit const limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file_atomically(folder / "old.png", std::string(5000, 'x'));
      return 1;
    } catch (Error const& error) {
      return error.kind() == ErrorKind::io ? 0 : 2;
    }
  });
  CHECK(status == 0);
  CHECK(folder.read("old.png") == "old");
  CHECK(folder.names() == std::vector<std::string>{"old.png"});
}

TEST_CASE("pipes are written directly and stay pipes", "[unit][file]") {
  TemporaryFolder const folder;
  fs::path const pipe = folder / "pipe.ppm";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string received;
  std::thread reader([&] { received = folder.read("pipe.ppm"); });
  std::string const bytes(200'000, 'p');  // more than a pipe holds
  check_writable(pipe);
  write_file_atomically(pipe, bytes);
  reader.join();
  CHECK(received == bytes);
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("a file that is written by and by is there when it is whole", "[unit][file]") {
  TemporaryFolder const folder;
  folder.write("picture.png", "old");
  {
    NewFile file(folder / "picture.png");
    file.write("abc");
    file.write("defg");
    file.seek(1);
    file.write("XY");
    CHECK(folder.read("picture.png") == "old");
    CHECK(folder.names().size() == 2);
    file.finish();
    CHECK(folder.read("picture.png") == "aXYdefg");
  }
  CHECK(folder.names() == std::vector<std::string>{"picture.png"});
  {
    NewFile file(folder / "picture.png");
    file.write("not whole");
  }
  CHECK(folder.read("picture.png") == "aXYdefg");
  CHECK(folder.names() == std::vector<std::string>{"picture.png"});
  {
    NewFile file(folder / "picture.png");
    file.write("other");
    file.finish_as(folder / "other.png");
  }
  CHECK(folder.read("picture.png") == "aXYdefg");
  CHECK(folder.read("other.png") == "other");
  CHECK_THROWS_AS(NewFile(folder / "missing" / "picture.png"), Error);
}

TEST_CASE("a write that failed is not forgotten where it cannot be reported", "[unit][file]") {
  TemporaryFolder const folder;
  folder.write("old.exr", "old");
  int const status = in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit const limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    NewFile file(folder / "old.exr");
    try {
      file.write(std::string(5000, 'x'));
      return 1;
    } catch (Error const&) {  // as OpenEXR's destructor does
    }
    try {
      file.finish();
      return 2;
    } catch (Error const& error) {
      return error.kind() == ErrorKind::io ? 0 : 3;
    }
  });
  CHECK(status == 0);
  CHECK(folder.read("old.exr") == "old");
  CHECK(folder.names() == std::vector<std::string>{"old.exr"});
}
