#pragma once

#include <vector>

#include "farm/plan.hpp"

namespace lichtraum::farm {

/// What a folder has of its plan's units, by their files' sizes: nothing of them is read.
struct Progress {
  std::int64_t done = 0;
  std::int64_t cut_short = 0;   ///< files of another size
  std::int64_t set_aside = 0;   ///< that could not be used, and are kept to be looked at
  std::int64_t unfinished = 0;  ///< that someone writes, or wrote when they were killed
  std::uint64_t bytes = 0;      ///< of all that is done
  std::vector<bool> is_done;    ///< by number

  /// The numbers that are missing, from `first` on, as ranges.
  struct Range {
    std::int64_t first = 0;
    std::int64_t last = 0;  ///< included
  };
  std::vector<Range> missing(std::size_t most_ranges) const;
};

Progress progress_of(PlanFolder const& folder);

}  // namespace lichtraum::farm
