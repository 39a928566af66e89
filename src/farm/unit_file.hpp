#pragma once

#include <string>
#include <string_view>

#include "farm/plan.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::farm {

/// A unit that is drawn.
struct DrawnUnit {
  std::string device_class;  ///< of what drew it
  RayCounts rays;
  Film film;
};

/// Writes a unit's file: under another name first, to the disk, and then in its place, so that it is there whole or not
/// at all, however many write it at once. Throws Error{try_again} when it cannot be written.
void write_unit(PlanFolder const& folder, std::int64_t number, DrawnUnit& unit);

/// What is known of a unit's file.
struct UnitCheck {
  std::string problem;     ///< why it cannot be used: "is missing"; empty: it can
  bool is_spoilt = false;  ///< what the file holds is of no use to anybody
  RayCounts rays;          ///< of one that can be used
};

/// Reads all of it. `allowed_class`: what must have drawn it; empty: any may have.
UnitCheck check_unit(PlanFolder const& folder, std::int64_t number, std::string_view allowed_class);

/// The rows [first, first + count) of a unit that was checked, counted from its top. Throws Error{try_again} when they
/// cannot be read any more.
Film read_rows(PlanFolder const& folder, std::int64_t number, int first, int count);

/// Whether it has the unit's size and begins as that does: what stands in the file is not read. `allowed_class` as
/// above.
bool looks_whole(PlanFolder const& folder, std::int64_t number, std::string_view allowed_class);

/// How many bytes the file of a unit has.
std::uint64_t unit_file_bytes(Plan const& plan, Unit const& unit);

/// Renames the file of a unit that cannot be used, so that the unit is drawn again. Returns its new name.
std::filesystem::path set_aside(PlanFolder const& folder, std::int64_t number);

}  // namespace lichtraum::farm
