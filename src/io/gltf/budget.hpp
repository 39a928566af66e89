#pragma once

#include <cstdint>
#include <string_view>

#include "io/gltf/findings.hpp"

namespace lichtraum::gltf {

/// How much memory a model may take: a few bytes of JSON can name the same data again and again, so what it unfolds to
/// is counted, before it is made, against what its files hold. Generous: it stops what is hostile or damaged.
class Budget {
 public:
  explicit Budget(Findings& findings) : findings_(findings) {}

  /// More bytes that the model's files hold.
  void add_file(std::uint64_t bytes) { file_bytes_ += bytes; }
  std::uint64_t file_bytes() const { return file_bytes_; }

  /// Counts `bytes` of the pose that is being made; fails the import where there is no room. `pointer`: what takes
  /// them.
  void charge(std::uint64_t bytes, std::string_view pointer);
  /// The same for what all poses share.
  void charge_for_good(std::uint64_t bytes, std::string_view pointer);
  /// The same; false, and nothing is counted, where there is no room.
  bool take_for_good(std::uint64_t bytes);
  /// What was made for the pose before counts no more.
  void begin_pose() { of_pose_ = 0; }

 private:
  std::uint64_t limit() const;
  bool has_room(std::uint64_t bytes) const;
  [[noreturn]] void fail(std::string_view pointer);

  Findings& findings_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t for_good_ = 0;
  std::uint64_t of_pose_ = 0;
};

}  // namespace lichtraum::gltf
