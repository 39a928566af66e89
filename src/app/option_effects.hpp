#pragma once

#include <vector>

#include "lichtraum/job.hpp"

namespace lichtraum::app {

/// An option that was given, and changes nothing in a picture. `why` follows on "has no effect"; it may be empty.
struct OptionWithoutEffect {
  char const* option;
  char const* why;
};

/// Of the options that say how files are read.
std::vector<OptionWithoutEffect> options_without_effect(SceneReading const& asked, bool is_model);

/// Of these and those that say what is drawn, not what is stored. `asked`: the job as they say it; `decided`: as it is
/// drawn.
std::vector<OptionWithoutEffect> options_without_effect(Job const& asked, Job const& decided, bool is_model,
                                                        bool has_environment);

}  // namespace lichtraum::app
