#include "farm/plan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>

#include "core/content_hash.hpp"
#include "core/quoted_for_shell.hpp"
#include "core/read_file.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"

namespace lichtraum::farm {
namespace {

namespace fs = std::filesystem;

constexpr char const* plan_name = "plan.json";

std::string hash_of(std::string_view bytes) {
  ContentHasher hasher;
  hasher.add(bytes);
  return hasher.finish().text();
}

}  // namespace

int Plan::picture_count() const {
  int count = 0;
  for (PlannedScene const& scene : scenes) count += scene.picture_count;
  return count;
}

Unit Plan::unit(std::int64_t number) const {
  Unit unit;
  unit.number = number;
  unit.picture = int(number / units_of_picture());
  std::int64_t const in_picture = number % units_of_picture();
  int const block = int(in_picture % sample_blocks());
  std::int64_t const place = in_picture / sample_blocks();
  int const x = int(place % columns()) * tile.width;
  int const y = int(place / columns()) * tile.height;
  unit.region = {region.x + x, region.y + y, std::min(tile.width, region.width - x),
                 std::min(tile.height, region.height - y)};
  unit.samples = {block * unit_samples, std::min(sample_count, (block + 1) * unit_samples)};
  return unit;
}

namespace {

/// Writes a whole file, unless there is one by then, also one that another machine has just made: false. A hard link is
/// what only one of them can make, on NFS as well.
bool create(fs::path const& file, std::string const& text) {
  std::random_device random;
  fs::path const beside =
      file.parent_path() / fmt::format(".{}.{:08x}{:08x}", file.filename().string(), random(), random());
  write_file_atomically(beside, text);
  bool is_made = ::link(beside.c_str(), file.c_str()) == 0;
  bool const has_links = is_made || (errno != EPERM && errno != ENOTSUP && errno != ENOSYS && errno != EMLINK);
  std::error_code failure;
  if (!has_links) {  // a file system without them: who comes last wins
    fs::rename(beside, file, failure);
    if (!failure) return true;
  }
  // The answer of a server may have been lost, but not what it did.
  is_made = is_made || fs::hard_link_count(beside, failure) == 2;
  fs::remove(beside, failure);
  return is_made;
}

}  // namespace

PlanFolder::PlanFolder(fs::path folder) : folder_(std::move(folder)) {
  fs::path const file = folder_ / plan_name;
  std::error_code ignored;
  if (fs::is_regular_file(folder_, ignored)) {
    throw Error(ErrorKind::no_input, fmt::format("'{}' is not a folder: lichtraum job plan {} -o FOLDER makes one",
                                                 folder_.string(), quoted_for_shell(folder_.string())));
  }
  if (!is_there()) {
    throw Error(ErrorKind::no_input, fmt::format("'{}' has no {}: lichtraum job plan SCENE -o {} makes one",
                                                 folder_.string(), plan_name, quoted_for_shell(folder_.string())));
  }
  std::string const text = read_file(file);
  hash_ = hash_of(text);
  try {
    plan_ = plan_from_json(text);
  } catch (Error const& error) {
    throw Error(ErrorKind::scene, fmt::format("{}: {}", file.string(), error.what()));
  }
}

PlanFolder::PlanFolder(fs::path folder, Plan plan) : folder_(std::move(folder)), plan_(std::move(plan)) {
  std::string const text = to_json(plan_);
  hash_ = hash_of(text);
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) {
    throw Error(ErrorKind::cannot_create,
                fmt::format("cannot make the folder '{}': {}", folder_.string(), failure.message()));
  }
  fs::path const file = folder_ / plan_name;
  bool const is_ours = !fs::exists(file, failure) && create(file, text);
  if (is_ours || read_file(file) == text) return;
  throw Error(ErrorKind::cannot_create,
              fmt::format("'{}' is another plan: choose another folder, or remove this one", file.string()));
}

bool PlanFolder::is_there() const {
  std::error_code ignored;
  return fs::exists(folder_ / plan_name, ignored);
}

fs::path PlanFolder::unit_file(std::int64_t number) const {
  return units_folder() / fmt::format("{:02x}", number % 256) / fmt::format("{}.unit", number);
}

std::string hash_of_file(fs::path const& path) {
  std::error_code failure;
  auto const found = fs::status(path, failure).type();
  if (found == fs::file_type::none) {
    throw Error(ErrorKind::io, fmt::format("'{}' cannot be read: {}", path.string(), failure.message()));
  }
  return found == fs::file_type::regular ? hash_of(read_file(path)) : "";
}

void PlannedFiles::check() {
  bool const is_first = checked_.empty();
  checked_.resize(plan_.files.size());
  for (std::size_t i = 0; i < plan_.files.size(); ++i) {
    ReadFile const& file = plan_.files[i];
    auto const stamp = stamp_of(file.path);
    if (!is_first && stamp == checked_[i]) continue;
    std::string now;
    try {
      now = hash_of_file(file.path);
    } catch (Error const& error) {  // as when a folder of another machine is not there for now
      throw Error(ErrorKind::try_again, error.what());
    }
    checked_[i] = stamp;
    if (now == file.hash) continue;
    std::string const what = now.empty() ? "is missing" : file.hash.empty() ? "is new" : "has changed";
    throw Error(ErrorKind::scene,
                fmt::format("'{}' {} since the plan was made: put it back, or make another plan", file.path, what));
  }
}

}  // namespace lichtraum::farm
