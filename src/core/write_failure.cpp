#include "core/write_failure.hpp"

#include <cerrno>
#include <cstring>

namespace lichtraum {

std::string write_failure(int code) {
  switch (code) {
    case ENOSPC:
      return "the disk is full";
    case EDQUOT:
      return "your disk quota is used up";
    case EFBIG:
      return "the file would be larger than the limit set for this process (ulimit -f)";
    case EPIPE:
      return "the reader closed the pipe";
    default:
      return std::strerror(code);
  }
}

}  // namespace lichtraum
