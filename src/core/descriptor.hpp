#pragma once

#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

namespace lichtraum {

/// An open file, closed at the end.
class Descriptor {
 public:
  /// What open(2) gave: negative where it failed.
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (is_open()) ::close(number_);
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// As close(2): some file systems report a full disk only here.
  int close() { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

/// Returns errno; 0 when all is written.
inline int write_all(Descriptor const& file, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t const written = ::write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(std::size_t(written));
  }
  return 0;
}

}  // namespace lichtraum
