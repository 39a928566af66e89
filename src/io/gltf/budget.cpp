#include "io/gltf/budget.hpp"

#include <fmt/format.h>

namespace lichtraum::gltf {

std::uint64_t Budget::limit() const {
  constexpr std::uint64_t always_allowed = std::uint64_t(1) << 29;
  constexpr std::uint64_t per_byte = 32;
  return always_allowed + per_byte * file_bytes_;
}

bool Budget::has_room(std::uint64_t bytes) const {
  std::uint64_t const taken = for_good_ + of_pose_;  // never more than the limit
  return bytes <= limit() - taken;
}

void Budget::fail(std::string_view pointer) {
  findings_.fail(DiagnosticCode::unfolds_too_far, pointer,
                 fmt::format("the model unfolds to more than {} bytes, from files of {} bytes", limit(), file_bytes_));
}

void Budget::charge(std::uint64_t bytes, std::string_view pointer) {
  if (!has_room(bytes)) fail(pointer);
  of_pose_ += bytes;
}

void Budget::charge_for_good(std::uint64_t bytes, std::string_view pointer) {
  if (!take_for_good(bytes)) fail(pointer);
}

bool Budget::take_for_good(std::uint64_t bytes) {
  if (!has_room(bytes)) return false;
  for_good_ += bytes;
  return true;
}

}  // namespace lichtraum::gltf
