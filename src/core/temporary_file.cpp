#include "core/temporary_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <random>

namespace lichtraum {

TemporaryFile::TemporaryFile(std::filesystem::path const& folder, std::string_view extension) {
  std::random_device random;
  do {
    path_ = folder / fmt::format(".lichtraum-{:08x}{:08x}.tmp{}", random(), random(), extension);
    descriptor_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  } while (!descriptor_.is_open() && (errno == EEXIST || errno == EINTR));
  is_there_ = descriptor_.is_open();
}

TemporaryFile::~TemporaryFile() {
  if (is_there_) ::unlink(path_.c_str());
}

int TemporaryFile::rename_to(std::filesystem::path const& target) {
  if (::rename(path_.c_str(), target.c_str()) != 0) return errno;
  is_there_ = false;
  return 0;
}

}  // namespace lichtraum
