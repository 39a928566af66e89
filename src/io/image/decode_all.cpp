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

}  // namespace

void decode_images(std::span<ImageJob> jobs, int max_size) {
  std::atomic<std::size_t> next{0};
  std::atomic<std::uint64_t> decoded_bytes{0};
  auto const work = [&](std::size_t) {  // each thread takes the next picture until none is left
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      ImageJob& job = jobs[i];
      if (!job.is_wanted || !job.reason.empty()) continue;
      if (decoded_bytes > max_decoded_bytes) {
        job.reason =
            fmt::format("the pictures need more than {} bytes; a smaller --max-texture helps", max_decoded_bytes);
        continue;
      }
      try {
        if (auto image = decode_image(job.bytes, max_size, job.reason)) {
          decoded_bytes += image->rgba.size();
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
