#include "io/image/decode_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <new>
#include <thread>

#include "core/start_threads.hpp"
#include "io/image/decode.hpp"

namespace lichtraum {
namespace {

/// A small file can hold a very large picture.
constexpr std::uint64_t max_decoded_bytes = std::uint64_t(1) << 29;

/// The first that fit, in their order: which these are must not depend on what is decoded when.
void refuse_what_is_too_much(std::span<ImageJob> jobs, int max_size) {
  std::uint64_t sum = 0;
  for (ImageJob& job : jobs) {
    if (!job.is_wanted || !job.reason.empty()) continue;
    std::uint64_t const bytes = decoded_bytes(job.bytes, max_size);
    if (sum + bytes <= max_decoded_bytes) {
      sum += bytes;
    } else {
      job.reason =
          fmt::format("the pictures need more than {} bytes; a smaller --max-texture helps", max_decoded_bytes);
    }
  }
}

}  // namespace

void decode_images(std::span<ImageJob> jobs, int max_size) {
  refuse_what_is_too_much(jobs, max_size);
  std::atomic<std::size_t> next{0};
  auto const work = [&](std::size_t) {  // each thread takes the next picture until none is left
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      ImageJob& job = jobs[i];
      if (!job.is_wanted || !job.reason.empty()) continue;
      try {
        if (auto image = decode_image(job.bytes, max_size, job.reason)) {
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
  std::size_t const thread_count = std::min<std::size_t>(wanted, std::max(1u, std::thread::hardware_concurrency()));
  if (thread_count == 0) return;
  auto const threads = start_threads(thread_count - 1, work);
  work(threads.size());
}

}  // namespace lichtraum
