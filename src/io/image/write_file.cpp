#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <utility>

#include "core/descriptor.hpp"
#include "core/follow_links.hpp"
#include "core/temporary_file.hpp"
#include "core/write_failure.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"

namespace lichtraum {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ErrorKind kind, fs::path const& path, std::string_view why) {
  throw Error(kind, fmt::format("cannot write '{}': {}", path.string(), why));
}

/// The standard streams by their device names: opened anew they would start at the file's beginning.
std::optional<int> standard_stream(fs::path const& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  return std::nullopt;
}

struct Target {
  fs::path path;                   ///< links followed
  std::optional<struct stat> old;  ///< what is there now
  bool is_stream() const { return old && !S_ISREG(old->st_mode); }
};

/// Throws Error{cannot_create} for what certainly cannot be written.
Target examine(fs::path const& path) {
  if (path.empty()) fail(ErrorKind::cannot_create, path, "the name is empty");
  struct stat status {};
  Target target{path, std::nullopt};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) fail(ErrorKind::cannot_create, path, "it is a folder");
    if (::access(path.c_str(), W_OK) != 0) {
      fail(ErrorKind::cannot_create, path,
           errno == EACCES ? "it may not be written (see its permissions)" : write_failure(errno));
    }
    target.old = status;
  } else if (errno != ENOENT && errno != ENOTDIR) {
    fail(ErrorKind::cannot_create, path, write_failure(errno));
  }
  if (!path.has_filename()) fail(ErrorKind::cannot_create, path, "there is no file name");
  // A device keeps its own name: /dev/fd/1 looks like a link to a path that does not exist ("pipe:[123]").
  if (target.is_stream()) return target;
  auto place = follow_links(path);
  if (!place) fail(ErrorKind::cannot_create, path, "too many symbolic links");
  target.path = std::move(*place);
  return target;
}

/// Where unfinished files are: renaming is only atomic within one file system.
fs::path folder_of(Target const& target) {
  return target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
}

void write_stream(int descriptor, fs::path const& path, std::string_view bytes) {
  Descriptor file(descriptor);
  if (!file.is_open()) fail(ErrorKind::cannot_create, path, write_failure(errno));
  int code = write_all(file, bytes);
  if (file.close() != 0 && code == 0) code = errno;
  if (code != 0) fail(ErrorKind::io, path, write_failure(code));
}

}  // namespace

void check_writable(fs::path const& path) {
  if (standard_stream(path)) return;
  Target const target = examine(path);
  if (target.is_stream()) return;
  // One without a name: a signal that ends the process now leaves nothing behind. Not every file system has them.
  if (Descriptor(::open(folder_of(target).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600)).is_open()) return;
  NewFile{path};
}

void write_file_atomically(fs::path const& path, std::string_view bytes) {
  if (auto const stream = standard_stream(path)) return write_stream(::dup(*stream), path, bytes);
  if (examine(path).is_stream()) return write_stream(::open(path.c_str(), O_WRONLY | O_CLOEXEC), path, bytes);
  NewFile file(path);
  file.write(bytes);
  file.finish();
}

NewFile::NewFile(fs::path path) : path_(std::move(path)) {
  Target const target = examine(path_);
  fs::path const folder = folder_of(target);
  temporary_ = std::make_unique<TemporaryFile>(folder);
  if (!temporary_->descriptor().is_open()) {
    int const code = errno;
    std::string const why = code == ENOENT ? fmt::format("there is no folder '{}' (mkdir -p makes it)", folder.string())
                            : code == ENOTDIR
                                ? fmt::format("'{}' is not a folder", folder.string())
                                : fmt::format("in the folder '{}': {}", folder.string(), write_failure(code));
    fail(ErrorKind::cannot_create, target.path, why);
  }
  if (target.old) ::fchmod(temporary_->descriptor().number(), target.old->st_mode & 07777);
}

NewFile::~NewFile() = default;

fs::path const& NewFile::unfinished_path() const { return temporary_->path(); }

/// Remembered, as some encoders write from destructors, which cannot throw.
void NewFile::note(int code) {
  if (code_ == 0) code_ = code;
  if (code_ != 0) fail(ErrorKind::io, path_, write_failure(code_));
}

void NewFile::write(std::string_view bytes) { note(write_all(temporary_->descriptor(), bytes)); }

void NewFile::seek(std::uint64_t position) {
  note(::lseek(temporary_->descriptor().number(), off_t(position), SEEK_SET) < 0 ? errno : 0);
}

// No fsync: the rename is atomic without it, and a picture can be rendered again after a power cut.
void NewFile::finish_as(fs::path const& path) {
  fs::path const target = examine(path).path;
  // Some file systems report a full disk only here.
  note(temporary_->descriptor().close() == 0 ? 0 : errno);
  note(temporary_->rename_to(target));
}

}  // namespace lichtraum
