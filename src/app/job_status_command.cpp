#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/arguments.hpp"
#include "app/device_text.hpp"
#include "app/job_commands.hpp"
#include "farm/progress.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* job_status_description =
    "Tells how many units of the plan in the folder DIR are done. Only names and\n"
    "sizes of files are looked at: merge checks what is in them.";

constexpr char const* job_status_examples =
    "  lichtraum job status shared\n"
    "  lichtraum job status shared --json\n";

/// What is missing is told as ranges, of which there may be as many as units.
constexpr std::size_t most_ranges = 1000;
constexpr std::size_t most_shown_ranges = 5;

std::string status_text(farm::PlanFolder const& folder, farm::Progress const& progress) {
  std::int64_t const count = folder.plan().unit_count();
  std::string text = fmt::format("{}: {} of {} done, {:.1f} MB\n", folder.path().string(), progress.done,
                                 unit_text(count), double(progress.bytes) / 1e6);
  std::vector<std::string> ranges;
  for (auto const& [first, last] : progress.missing(most_shown_ranges + 1)) {
    ranges.push_back(first == last ? fmt::format("{}", first) : fmt::format("{}..{}", first, last));
  }
  if (ranges.size() > most_shown_ranges) ranges.back() = "...";
  if (!ranges.empty()) text += fmt::format("missing: {}\n", fmt::join(ranges, ", "));
  if (progress.cut_short > 0) text += fmt::format("cut short: {}\n", progress.cut_short);
  if (progress.set_aside > 0) text += fmt::format("set aside: {}\n", progress.set_aside);
  if (progress.unfinished > 0)
    text += fmt::format("unfinished (being written, or left by a worker that was killed): {}\n", progress.unfinished);
  return text;
}

std::string status_json(farm::PlanFolder const& folder, farm::Progress const& progress) {
  using Json = nlohmann::ordered_json;
  farm::Plan const& plan = folder.plan();
  Json missing = Json::array();
  for (auto const& [first, last] : progress.missing(most_ranges)) missing.push_back({first, last});
  Json const json = {{"lichtraum", LICHTRAUM_VERSION},
                     {"plan", folder.hash()},
                     {"class", plan.device.hash},
                     {"device", {{"kind", kind_name(plan.device.kind)}, {"name", plan.device.name}}},
                     {"pictures", plan.picture_count()},
                     {"units", plan.unit_count()},
                     {"done", progress.done},
                     {"cut_short", progress.cut_short},
                     {"set_aside", progress.set_aside},
                     {"unfinished", progress.unfinished},
                     {"bytes", progress.bytes},
                     {"missing", std::move(missing)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int job_status_command(Arguments const& arguments, Console& console) {
  std::string name;
  bool is_json = false;
  auto const parser = make_parser("job status", job_status_description, job_status_examples);
  add_inputs(*parser, name, "DIR");
  parser->add_flag("--json", is_json, "Print JSON")->group("Output");
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;
  farm::PlanFolder const folder(name);
  farm::Progress const progress = farm::progress_of(folder);
  write_standard_output(is_json ? status_json(folder, progress) : status_text(folder, progress));
  return 0;
}

}  // namespace lichtraum::app
