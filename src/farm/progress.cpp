#include "farm/progress.hpp"

#include <array>
#include <charconv>
#include <map>

#include "core/folder_entries.hpp"
#include "farm/unit_file.hpp"

namespace lichtraum::farm {
namespace {

namespace fs = std::filesystem;

/// Units have few sizes: of those in the middle and at the edges, with all samples or the last.
class UnitSizes {
 public:
  explicit UnitSizes(Plan const& plan) : plan_(plan) {}
  std::uint64_t operator()(std::int64_t number) {
    Unit const unit = plan_.unit(number);
    std::array<int, 4> const key{unit.region.width, unit.region.height, unit.samples.first == 0, unit.samples.count()};
    auto const [entry, is_new] = sizes_.try_emplace(key);
    if (is_new) entry->second = unit_file_bytes(plan_, unit);
    return entry->second;
  }

 private:
  Plan const& plan_;
  std::map<std::array<int, 4>, std::uint64_t> sizes_;
};

/// -1 for a name that is none of a unit.
std::int64_t number_of(std::string const& stem) {
  std::int64_t number = -1;
  auto const [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  return error == std::errc() && end == stem.data() + stem.size() && std::to_string(number) == stem ? number : -1;
}

}  // namespace

Progress progress_of(PlanFolder const& folder) {
  Progress progress;
  progress.is_done.resize(std::size_t(folder.plan().unit_count()));
  UnitSizes size_of(folder.plan());
  auto const count = [&](fs::directory_entry const& entry) {
    fs::path const& path = entry.path();
    std::int64_t const number = number_of(path.stem().string());
    if (path.extension() == ".tmp") ++progress.unfinished;
    if (path.extension() == ".bad") ++progress.set_aside;
    if (path.extension() != ".unit" || number < 0 || number >= folder.plan().unit_count()) return;
    if (path != folder.unit_file(number)) return;
    std::error_code is_gone;
    std::uint64_t const size = entry.file_size(is_gone);
    if (is_gone) return;
    if (size != size_of(number)) {
      ++progress.cut_short;
      return;
    }
    ++progress.done;
    progress.bytes += size;
    progress.is_done[std::size_t(number)] = true;
  };
  for_each_entry(folder.units_folder(), [&](fs::directory_entry const& part) { for_each_entry(part.path(), count); });
  return progress;
}

std::vector<Progress::Range> Progress::missing(std::size_t most_ranges) const {
  std::vector<Range> ranges;
  auto const count = std::int64_t(is_done.size());
  for (std::int64_t i = 0; i < count; ++i) {
    if (is_done[std::size_t(i)]) continue;
    if (!ranges.empty() && ranges.back().last == i - 1) {
      ranges.back().last = i;
    } else if (ranges.size() == most_ranges) {
      break;
    } else {
      ranges.push_back({i, i});
    }
  }
  return ranges;
}

}  // namespace lichtraum::farm
