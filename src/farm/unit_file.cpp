#include "farm/unit_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <vector>

#include "core/content_hash.hpp"
#include "core/descriptor.hpp"
#include "core/temporary_file.hpp"
#include "core/write_failure.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum::farm {
namespace {

namespace fs = std::filesystem;

// A file is its head, the film's arrays, and a hash of both: all as the machine has numbers in memory, which on those
// that OpenCL knows is little-endian.

constexpr std::string_view magic = "lichtraum unit\n";
constexpr std::uint32_t file_version = 1;
constexpr std::size_t hash_digits = 32;

struct Head {
  std::array<char, 16> magic{};
  std::uint32_t version = file_version;
  std::uint32_t reserved = 0;
  std::array<char, hash_digits> plan{};
  std::array<char, hash_digits> device_class{};
  std::uint64_t number = 0;
  std::uint64_t rays[5]{};
};
static_assert(sizeof(Head) == 136);

template <std::size_t size>
void put(std::array<char, size>& to, std::string_view text) {
  std::copy_n(text.begin(), std::min(size, text.size()), to.begin());
}
template <std::size_t size>
std::string_view text_of(std::array<char, size> const& chars) {
  return {chars.data(), strnlen(chars.data(), size)};
}

Head head_of(PlanFolder const& folder, std::int64_t number, DrawnUnit const& unit) {
  Head head;
  put(head.magic, magic);
  put(head.plan, folder.hash());
  put(head.device_class, unit.device_class);
  head.number = std::uint64_t(number);
  RayCounts const& rays = unit.rays;
  std::uint64_t const counts[] = {rays.camera, rays.shadow, rays.secondary, rays.camera_hits, rays.not_finite};
  std::copy(std::begin(counts), std::end(counts), head.rays);
  return head;
}

/// Why the file is not that unit's; empty when it may be.
std::string problem_of(Head const& head, PlanFolder const& folder, std::int64_t number) {
  if (text_of(head.magic) != magic || head.version != file_version) return "is no unit of this version";
  if (text_of(head.plan) != folder.hash()) return "is of another plan";
  if (head.number != std::uint64_t(number)) return fmt::format("is unit {}", head.number);
  return {};
}

bool is_allowed(Head const& head, std::string_view allowed_class) {
  return allowed_class.empty() || text_of(head.device_class) == allowed_class;
}

std::uint64_t bytes_of(Descriptor const& file) {
  struct stat status {};
  return ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) ? std::uint64_t(status.st_size) : 0;
}

Descriptor open_unit(PlanFolder const& folder, std::int64_t number) {
  return Descriptor(::open(folder.unit_file(number).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

bool read_exactly(Descriptor const& file, void* bytes, std::size_t count) {
  auto* at = static_cast<char*>(bytes);
  while (count > 0) {
    ssize_t const got = ::read(file.number(), at, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    count -= std::size_t(got);
  }
  return true;
}

[[noreturn]] void cannot_write(fs::path const& path) {
  throw Error(ErrorKind::try_again,
              fmt::format("cannot write '{}': {}; what is done stays, and 'lichtraum job work' goes on", path.string(),
                          write_failure(errno)));
}

/// What some file systems find out late is known before the name is there.
void finish(TemporaryFile& file, PlanFolder const& folder, std::int64_t number) {
  fs::path const path = folder.unit_file(number);
  if (::fsync(file.descriptor().number()) != 0) cannot_write(path);
  if (file.descriptor().close() != 0) cannot_write(path);
  int code = file.rename_to(path);
  if (code == EISDIR) {
    set_aside(folder, number);
    code = file.rename_to(path);
  }
  errno = code;
  if (code != 0) cannot_write(path);
  Descriptor const parent(::open(path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.is_open()) ::fsync(parent.number());
}

}  // namespace

void write_unit(PlanFolder const& folder, std::int64_t number, DrawnUnit& unit) {
  fs::path const path = folder.unit_file(number);
  // A share that is no longer mounted leaves its folder behind, on the local disk: nobody would look for units there.
  if (!folder.is_there()) {
    throw Error(
        ErrorKind::try_again,
        fmt::format("'{}' no longer has its plan: is the share still mounted? What is done stays, and 'lichtraum "
                    "job work' goes on once it is back",
                    folder.path().string()));
  }
  std::error_code failure;
  fs::create_directories(path.parent_path(), failure);
  if (failure) {
    errno = failure.value();
    cannot_write(path);
  }
  TemporaryFile file(path.parent_path());
  if (!file.descriptor().is_open()) cannot_write(path);
  auto const write = [&](void const* bytes, std::size_t count) {
    if (write_all(file.descriptor(), {static_cast<char const*>(bytes), count}) != 0) cannot_write(path);
  };
  ContentHasher hasher;
  auto const add = [&](void const* bytes, std::size_t count) {
    hasher.add_bytes(bytes, count);
    write(bytes, count);
  };
  Head const head = head_of(folder, number, unit);
  add(&head, sizeof head);
  for (auto const& array : unit.film.arrays()) add(array.data(), array.size());
  std::string const hash = hasher.finish().text();
  write(hash.data(), hash.size());
  finish(file, folder, number);
}

UnitCheck check_unit(PlanFolder const& folder, std::int64_t number, std::string_view allowed_class) {
  UnitCheck check;
  Descriptor const file(open_unit(folder, number));
  if (!file.is_open()) {
    check.problem = errno == ENOENT ? "is missing" : fmt::format("cannot be read: {}", std::strerror(errno));
    return check;
  }
  std::uint64_t const wanted = unit_file_bytes(folder.plan(), folder.plan().unit(number)), found = bytes_of(file);
  if (found != wanted) {
    check.is_spoilt = true;
    check.problem = fmt::format("has {} bytes instead of {}", found, wanted);
    return check;
  }
  Head head;
  bool is_read = read_exactly(file, &head, sizeof head);
  if (is_read) check.problem = problem_of(head, folder, number);
  if (!check.problem.empty()) {
    check.is_spoilt = true;
    return check;
  }
  if (is_read && !is_allowed(head, allowed_class)) {
    check.problem =
        fmt::format("was drawn by a device of another class, {}: --allow-mixed takes it", text_of(head.device_class));
    return check;
  }
  ContentHasher hasher;
  hasher.add_bytes(&head, sizeof head);
  std::vector<char> some(std::size_t(1) << 20);
  for (std::uint64_t left = wanted - sizeof head - hash_digits; is_read && left > 0;) {
    std::size_t const count = std::size_t(std::min<std::uint64_t>(left, some.size()));
    is_read = read_exactly(file, some.data(), count);
    hasher.add_bytes(some.data(), count);
    left -= count;
  }
  std::array<char, hash_digits> hash{};
  is_read = is_read && read_exactly(file, hash.data(), hash.size());
  if (!is_read) {
    check.problem = "cannot be read to its end";
  } else if (text_of(hash) != hasher.finish().text()) {
    check.is_spoilt = true;
    check.problem = "does not have the bytes that were written to it";
  } else {
    check.rays = {head.rays[0], head.rays[1], head.rays[2], head.rays[3], head.rays[4]};
  }
  return check;
}

Film read_rows(PlanFolder const& folder, std::int64_t number, int first, int count) {
  Unit const unit = folder.plan().unit(number);
  Region const rows{unit.region.x, unit.region.y + first, unit.region.width, count};
  Film film = Film::of_samples(rows, folder.plan().planes, unit.samples);
  Descriptor const file(open_unit(folder, number));
  bool is_read = file.is_open();
  std::uint64_t array_begin = sizeof(Head);
  for (auto const& array : film.arrays()) {
    std::uint64_t const row_bytes = array.size() / std::size_t(count);
    std::uint64_t const begin = array_begin + row_bytes * std::uint64_t(first);
    is_read = is_read && ::lseek(file.number(), off_t(begin), SEEK_SET) >= 0 &&
              read_exactly(file, array.data(), array.size());
    array_begin += row_bytes * std::uint64_t(unit.region.height);
  }
  if (is_read) return film;
  throw Error(ErrorKind::try_again,
              fmt::format("cannot read '{}' any more: was it changed?", folder.unit_file(number).string()));
}

bool looks_whole(PlanFolder const& folder, std::int64_t number, std::string_view allowed_class) {
  Descriptor const file(open_unit(folder, number));
  Head head;
  return file.is_open() && bytes_of(file) == unit_file_bytes(folder.plan(), folder.plan().unit(number)) &&
         read_exactly(file, &head, sizeof head) && problem_of(head, folder, number).empty() &&
         is_allowed(head, allowed_class);
}

std::uint64_t unit_file_bytes(Plan const& plan, Unit const& unit) {
  std::uint64_t pixel_bytes = 0;
  // How many sums Film::of_samples has of each value does not hang on the size.
  for (auto const& array : Film::of_samples({0, 0, 1, 1}, plan.planes, unit.samples).arrays())
    pixel_bytes += array.size();
  return sizeof(Head) + hash_digits +
         pixel_bytes * std::uint64_t(unit.region.width) * std::uint64_t(unit.region.height);
}

fs::path set_aside(PlanFolder const& folder, std::int64_t number) {
  fs::path const path = folder.unit_file(number);
  fs::path aside = path;
  aside.replace_extension(".bad");
  if (::rename(path.c_str(), aside.c_str()) == 0) return aside;
  // A folder takes no file's place, nor a file a folder's.
  aside += fmt::format(".{:x}", ::getpid());
  if (::rename(path.c_str(), aside.c_str()) != 0) cannot_write(aside);
  return aside;
}

}  // namespace lichtraum::farm
