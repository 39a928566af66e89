#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>

#include "reference/pixel_tracer.hpp"

namespace lichtraum {

/// One render: threads take rows from the region until none is left or they are told to stop.
class RowQueue {
 public:
  /// `pixels` must outlive it.
  RowQueue(PixelTracer const& pixels, Region const& region) : pixels_(pixels), region_(region) {}

  /// What each thread does.
  void work(std::stop_token const& stop);

  /// Waits for the last row or the interval; true when there is nothing more to wait for.
  bool wait_for(std::chrono::steady_clock::duration interval);
  int count() const { return region_.height; }
  double fraction();
  RayCounts rays();
  /// Once all threads have ended: whether every row is there. Throws what one of them has thrown.
  bool finish();

 private:
  bool trace_row(int row, std::stop_token const& stop);

  PixelTracer const& pixels_;
  Region region_;
  std::atomic<int> next_row_{0};
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  int finished_rows_ = 0;
  RayCounts rays_;
  std::exception_ptr failure_;
};

}  // namespace lichtraum
