#pragma once

#include <cstdint>
#include <string>

#include "app/commands.hpp"
#include "farm/plan.hpp"

namespace lichtraum::app {

/// The commands under `lichtraum job`.
int job_plan_command(Arguments const& arguments, Console& console);
int job_work_command(Arguments const& arguments, Console& console);
int job_merge_command(Arguments const& arguments, Console& console);
int job_script_command(Arguments const& arguments, Console& console);
int job_status_command(Arguments const& arguments, Console& console);

/// "3 units", "1 unit".
std::string unit_text(std::int64_t count);

}  // namespace lichtraum::app
