#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lichtraum::test {

/// The device that kernel tests run on: the one whose name contains LICHTRAUM_TEST_DEVICE or which has that index, else
/// the first CPU. Without one, std::nullopt.
std::optional<std::string> test_device_name();

/// `full`, or less of it where work-items are interpreted: LICHTRAUM_TEST_SCALE is the share, 0..1 (default 1).
std::size_t scaled_count(std::size_t full);

/// How many points a work-item should have for a kernel test to be quick: sixteen on CPUs, where they are the lanes of
/// vector instructions, and one elsewhere.
std::size_t quickest_lanes();

/// An argument of a probe: a global buffer, or a number or struct by value.
struct ProbeArgument {
  enum class Kind { input, output, updated, value };
  Kind kind;
  void* data;  ///< only read for inputs and values
  std::size_t bytes;
  std::shared_ptr<void const> owned = {};  ///< a value's copy
};

template <class T, class Allocator>
ProbeArgument in(std::vector<T, Allocator> const& data) {
  return {ProbeArgument::Kind::input, const_cast<T*>(data.data()), data.size() * sizeof(T)};
}
/// Not defined before the probe writes it: an Oclgrind run reports an element that is read.
template <class T>
ProbeArgument out(std::vector<T>& data) {
  return {ProbeArgument::Kind::output, data.data(), data.size() * sizeof(T)};
}
template <class T>
ProbeArgument updated(std::vector<T>& data) {
  return {ProbeArgument::Kind::updated, data.data(), data.size() * sizeof(T)};
}
template <class T>
ProbeArgument value(T const& v) {
  auto const copy = std::make_shared<T>(v);
  return {ProbeArgument::Kind::value, copy.get(), sizeof(T), copy};
}

/// A program for the test device: a file of tests/kernel (or of kernels), built with -I kernels. Buffers without
/// elements are passed as one byte.
class ProbeProgram {
 public:
  /// Throws std::runtime_error with the compiler's log, and when it has a warning.
  explicit ProbeProgram(std::string const& file, std::string const& options = "");
  ~ProbeProgram();

  /// Runs `kernel` over `width` x `height` work-items and reads outputs back. The range is rounded up to the local
  /// size: the kernel must check. Groups of one by default: left to choose, PoCL 6 makes some of thousands, and what
  /// their work-items keep outgrows a thread's stack. Throws std::runtime_error.
  void run(std::string const& kernel, std::size_t width, std::vector<ProbeArgument> const& arguments,
           std::size_t height = 1, std::size_t local_width = 1, std::size_t local_height = 1) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum::test

/// First line of every test that needs a device.
#define NEEDS_OPENCL_DEVICE() \
  if (!lichtraum::test::test_device_name()) SKIP_TEST("no OpenCL device")
