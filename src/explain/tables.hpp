#pragma once

#include <span>
#include <string_view>

#include "lichtraum/explanation.hpp"

namespace lichtraum::explain {

/// Whether a table explains all codes whose numbers begin with two digits, in their order, and no other.
constexpr bool explains_all(std::span<Explanation const> table, std::string_view digits) {
  std::size_t i = 0;
  for (DiagnosticCodeEntry const& entry : diagnostic_codes) {
    if (entry.code == DiagnosticCode::none || entry.text.substr(1, 2) != digits) continue;
    if (i == table.size() || table[i].code != entry.code) return false;
    ++i;
  }
  return i == table.size();
}

std::span<Explanation const> options();
std::span<Explanation const> files();
std::span<Explanation const> statements();
std::span<Explanation const> names();
std::span<Explanation const> numbers();
std::span<Explanation const> shapes();
std::span<Explanation const> materials_and_views();
std::span<Explanation const> pictures();
std::span<Explanation const> models();
std::span<Explanation const> gltf();
std::span<Explanation const> obj();
std::span<Explanation const> ply();
std::span<Explanation const> stl();

}  // namespace lichtraum::explain
