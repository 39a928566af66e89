#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "farm/plan.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/job.hpp"

namespace {

/// What is read must be written so that it is read as the same.
template <class Read>
void try_reading(std::string_view text, Read const& read) {
  try {
    auto const value = read(text);
    if (!(read(to_json(value)) == value)) std::abort();
  } catch (lichtraum::Error const&) {  // what a faulty text must end in; anything else is a finding
  }
}

}  // namespace

// Any bytes are read as the JSON of a job and of a plan; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const text(reinterpret_cast<char const*>(data), size);
  try_reading(text, lichtraum::job_from_json);
  try_reading(text, lichtraum::farm::plan_from_json);
  return 0;
}
