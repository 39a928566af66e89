#pragma once

#include <span>
#include <vector>

#include "shared/alias_table.h"

namespace lichtraum {

/// Fills alias tables; keeps what it needs for that from one to the next.
class AliasTableMaker {
 public:
  /// One entry a weight, which must be finite and not negative; what has none is never chosen, unless all have none:
  /// then all are chosen alike.
  void fill(std::span<double const> weights, std::span<device::AliasEntry> entries);

 private:
  std::vector<double> scaled_;
  std::vector<device::uint> small_, large_;
};

}  // namespace lichtraum
