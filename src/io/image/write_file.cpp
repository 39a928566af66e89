#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"

namespace lichtraum {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ErrorKind kind, fs::path const& path, std::string_view why) {
  throw Error(kind, fmt::format("cannot write '{}': {}", path.string(), why));
}

std::string reason(int code) {
  if (code == ENOSPC) return "the disk is full";
  if (code == EDQUOT) return "your disk quota is used up";
  if (code == EFBIG) return "the file would be larger than the limit set for this process (ulimit -f)";
  return std::strerror(code);
}

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

  /// Returns errno, 0 when all went well. Some file systems report a full disk only here.
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

  /// Returns errno, 0 when all is written.
  int write(std::string_view bytes) {
    while (!bytes.empty()) {
      ssize_t const written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  }

 private:
  int descriptor_;
};

/// A new file in the same folder as its target: renaming is only atomic within one file system.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path const& target) : file_(-1) {
    fs::path const folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    for (int attempt = 0;; ++attempt) {
      // Short, so that a target whose name is as long as names may be can be written too.
      path_ = folder / fmt::format(".lichtraum-{}-{}.tmp", ::getpid(), attempt);
      int const descriptor = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) {
        file_.emplace(descriptor);
        return;
      }
      if (errno == EEXIST || errno == EINTR) continue;  // left over by a killed process that had this number
      int const code = errno;
      if (code == ENOENT) {
        fail(ErrorKind::cannot_create, target,
             fmt::format("there is no folder '{}' (mkdir -p makes it)", folder.string()));
      }
      if (code == ENOTDIR) {
        fail(ErrorKind::cannot_create, target, fmt::format("'{}' is not a folder", folder.string()));
      }
      fail(ErrorKind::cannot_create, target, fmt::format("in the folder '{}': {}", folder.string(), reason(code)));
    }
  }
  TemporaryFile(TemporaryFile const&) = delete;
  TemporaryFile& operator=(TemporaryFile const&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
  }

  File& file() { return *file_; }
  int rename_to(fs::path const& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
    renamed_ = true;
    return 0;
  }

 private:
  fs::path path_;
  std::optional<File> file_;
  bool renamed_ = false;
};

/// Where a write through symbolic links ends up, the last of them dangling or not.
fs::path follow_links(fs::path const& path) {
  fs::path place = path;
  for (int links = 0; links < 40; ++links) {
    std::error_code no_link;
    fs::path const next = fs::read_symlink(place, no_link);
    if (no_link) return place;
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  fail(ErrorKind::cannot_create, path, "too many symbolic links");
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
           errno == EACCES ? "it may not be written (see its permissions)" : reason(errno));
    }
    target.old = status;
  } else if (errno != ENOENT && errno != ENOTDIR) {
    fail(ErrorKind::cannot_create, path, reason(errno));
  }
  if (!path.has_filename()) fail(ErrorKind::cannot_create, path, "there is no file name");
  // A device keeps its own name: /dev/fd/1 looks like a link to a path that does not exist ("pipe:[123]").
  if (!target.is_stream()) target.path = follow_links(path);
  return target;
}

void write_stream(int descriptor, fs::path const& path, std::string_view bytes) {
  File file(descriptor);
  if (!file.is_open()) fail(ErrorKind::cannot_create, path, reason(errno));
  int const write_error = file.write(bytes);
  int const close_error = file.close();
  if (int const code = write_error ? write_error : close_error) fail(ErrorKind::io, path, reason(code));
}

}  // namespace

void check_writable(fs::path const& path) {
  if (standard_stream(path)) return;
  Target const target = examine(path);
  if (!target.is_stream()) TemporaryFile{target.path};
}

void write_file_atomically(fs::path const& path, std::string_view bytes) {
  if (auto const stream = standard_stream(path)) return write_stream(::dup(*stream), path, bytes);
  Target const target = examine(path);
  if (target.is_stream()) return write_stream(::open(path.c_str(), O_WRONLY | O_CLOEXEC), path, bytes);

  TemporaryFile temporary(target.path);
  if (target.old) ::fchmod(temporary.file().descriptor(), target.old->st_mode & 07777);
  // No fsync: the rename is atomic without it, and a picture can be rendered again after a power cut.
  int code = temporary.file().write(bytes);
  if (int const close_error = temporary.file().close(); code == 0) code = close_error;
  if (code != 0) fail(ErrorKind::io, path, reason(code));
  if (int const rename_error = temporary.rename_to(target.path)) fail(ErrorKind::io, path, reason(rename_error));
}

}  // namespace lichtraum
