#include "core/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

#include "core/descriptor.hpp"
#include "core/huge_pages.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

std::string reason(int code) { return std::generic_category().message(code); }

// read(2), again when a signal interrupts it.
std::size_t read_some(int file, char* to, std::size_t size, std::filesystem::path const& path) {
  ssize_t count = 0;
  do {
    count = ::read(file, to, size);
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw Error(ErrorKind::io, fmt::format("cannot read '{}': {}", path.string(), reason(errno)));
  return static_cast<std::size_t>(count);
}

}  // namespace

std::string read_file(std::filesystem::path const& path, std::size_t stream_limit) {
  Descriptor const file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) {
    throw Error(ErrorKind::no_input, fmt::format("cannot open '{}': {}", path.string(), reason(errno)));
  }
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) {
    throw Error(ErrorKind::io, fmt::format("cannot read '{}': {}", path.string(), reason(errno)));
  }
  if (S_ISDIR(status.st_mode)) {
    throw Error(ErrorKind::no_input, fmt::format("cannot open '{}': it is a folder", path.string()));
  }

  bool const is_regular = S_ISREG(status.st_mode);
  constexpr std::size_t stream_block = std::size_t{1} << 16;
  std::string bytes;
  std::size_t size = 0;
  try {
    // One byte more than the file has, so that its end is seen without growing.
    std::size_t const first_size = is_regular ? static_cast<std::size_t>(status.st_size) + 1 : stream_block;
    reserve_in_huge_pages(bytes, first_size);
    bytes.resize(first_size);
    while (std::size_t const count = read_some(file.number(), bytes.data() + size, bytes.size() - size, path)) {
      size += count;
      if (!is_regular && size > stream_limit) {
        throw Error(ErrorKind::io, fmt::format("cannot read '{}': longer than {} bytes", path.string(), stream_limit));
      }
      if (size == bytes.size()) bytes.resize(2 * size);
    }
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::io, fmt::format("cannot read '{}': not enough memory", path.string()));
  } catch (std::length_error const&) {
    throw Error(ErrorKind::io, fmt::format("cannot read '{}': not enough memory", path.string()));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace lichtraum
