#include "io/image/decode_all.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <new>
#include <queue>
#include <thread>
#include <utility>
#include <vector>

#include "core/memory.hpp"
#include "core/start_threads.hpp"
#include "io/image/decode.hpp"

namespace lichtraum {
namespace {

/// A small file can hold a very large picture, and a model name it again and again: 512 pictures of 4096 x 4096, as
/// they are in their files. It is a matter of time rather than memory, and the same on every machine.
constexpr std::uint64_t max_bytes_in_files = std::uint64_t(1) << 35;

/// What is to be decoded, by the headers.
struct DecodingPlan {
  std::vector<ImageSize> sizes;     ///< of each job
  std::uint64_t sum = 0;            ///< of their bytes
  std::uint64_t largest_whole = 1;  ///< bytes of the largest, before it is halved
};

/// The first that may be decoded, in their order: which these are must not depend on what is decoded when.
DecodingPlan plan_decoding(std::span<ImageJob> jobs, int max_size) {
  DecodingPlan plan;
  std::uint64_t whole_sum = 0;
  for (ImageJob& job : jobs) {
    ImageSize& size = plan.sizes.emplace_back();
    if (!job.is_wanted || !job.reason.empty()) continue;
    std::uint64_t const whole = decoded_size(job.bytes, std::numeric_limits<int>::max()).bytes();
    if (whole > max_bytes_in_files - whole_sum) {
      job.reason = fmt::format("the pictures before it have {} pixels in all, and {} can be read", whole_sum / 4,
                               max_bytes_in_files / 4);
      continue;
    }
    whole_sum += whole;
    size = decoded_size(job.bytes, max_size);
    plan.sum += size.bytes();
    plan.largest_whole = std::max(plan.largest_whole, whole);
  }
  return plan;
}

/// Halves the largest pictures, of those as large the last, until all fit. Returns how many are smaller than before.
std::size_t make_fit(DecodingPlan& plan, std::uint64_t max_bytes) {
  if (plan.sum <= max_bytes) return 0;
  std::vector<bool> is_halved(plan.sizes.size(), false);
  std::priority_queue<std::pair<std::uint64_t, std::size_t>> by_size;
  for (std::size_t i = 0; i < plan.sizes.size(); ++i) by_size.emplace(plan.sizes[i].bytes(), i);
  while (plan.sum > max_bytes) {
    auto const [bytes, i] = by_size.top();
    ImageSize const half = plan.sizes[i].halved();
    if (half == plan.sizes[i]) break;  // all of them are single pixels
    plan.sum -= bytes - half.bytes();
    plan.sizes[i] = half;
    is_halved[i] = true;
    by_size.pop();
    by_size.emplace(half.bytes(), i);
  }
  return std::size_t(std::count(is_halved.begin(), is_halved.end(), true));
}

/// So many that what they are at work on takes no more than what they make.
std::size_t count_decoders(std::size_t wanted, DecodingPlan const& plan, std::uint64_t max_bytes) {
  std::size_t const fitting = std::max<std::uint64_t>(1, max_bytes / plan.largest_whole);
  return std::min({wanted, fitting, std::size_t(std::max(1u, std::thread::hardware_concurrency()))});
}

std::uint64_t mebibytes(std::uint64_t bytes) { return (bytes + 0xFFFFF) >> 20; }

}  // namespace

std::uint64_t max_picture_bytes() {
  std::uint64_t memory = usable_memory_bytes();
  rlimit limit{};  // thumbnails are made within one
  if (::getrlimit(RLIMIT_DATA, &limit) == 0) memory = std::min<std::uint64_t>(memory, limit.rlim_cur);
  // They are in memory three times while a scene is made: as the model has them, side by side, and on the device, where
  // PoCL's largest buffer is about a sixth of the memory.
  return std::clamp(memory / 8, std::uint64_t(1) << 29, std::uint64_t(1) << 31);
}

std::string decode_images(std::span<ImageJob> jobs, int max_size, std::uint64_t max_bytes) {
  DecodingPlan plan = plan_decoding(jobs, max_size);
  std::uint64_t const sum = plan.sum;
  std::size_t const halved_count = make_fit(plan, max_bytes);
  std::atomic<std::size_t> next{0};
  auto const work = [&](std::size_t) {  // each thread takes the next picture until none is left
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      ImageJob& job = jobs[i];
      if (!job.is_wanted || !job.reason.empty()) continue;
      try {
        if (auto image = decode_image(job.bytes, int(plan.sizes[i].longer_side()), job.content, job.reason)) {
          image->name = job.name;
          job.image = std::make_shared<TextureImage>(std::move(*image));
        }
      } catch (std::bad_alloc const&) {
        job.reason = "not enough memory";
      }
      job.owned = {};
    }
  };
  auto const wanted =
      std::size_t(std::count_if(jobs.begin(), jobs.end(), [](ImageJob const& j) { return j.is_wanted; }));
  std::size_t const thread_count = count_decoders(wanted, plan, max_bytes);
  if (thread_count == 0) return {};
  auto const threads = start_threads(thread_count - 1, work);
  work(threads.size());
  if (halved_count == 0) return {};
  return fmt::format(
      "{} of the pictures are halved, the largest first: all of them need {} MiB, and {} MiB are for them here; a "
      "smaller --max-texture makes that the same everywhere",
      halved_count, mebibytes(sum), max_bytes >> 20);
}

}  // namespace lichtraum
