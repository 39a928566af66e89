#include "reference/row_queue.hpp"

namespace lichtraum {

void RowQueue::work(std::stop_token const& stop) {
  try {
    while (!stop.stop_requested()) {
      int const row = next_row_.fetch_add(1, std::memory_order_relaxed);
      if (row >= region_.height || !trace_row(row, stop)) break;
    }
  } catch (...) {
    std::lock_guard const lock(mutex_);
    failure_ = std::current_exception();
  }
  changed_.notify_all();
}

bool RowQueue::wait_for(std::chrono::steady_clock::duration interval) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, interval, [this] { return failure_ || finished_rows_ == region_.height; });
}

double RowQueue::fraction() {
  std::lock_guard const lock(mutex_);
  return double(finished_rows_) / region_.height;
}

RayCounts RowQueue::rays() {
  std::lock_guard const lock(mutex_);
  return rays_;
}

bool RowQueue::finish() {
  if (failure_) std::rethrow_exception(failure_);
  return finished_rows_ == region_.height;
}

bool RowQueue::trace_row(int row, std::stop_token const& stop) {
  RayCounts counts;
  for (int x = region_.x; x < region_.x + region_.width; ++x) {
    if (stop.stop_requested()) return false;
    pixels_.trace(x, region_.y + row, counts);
  }
  std::lock_guard const lock(mutex_);
  rays_ += counts;
  ++finished_rows_;
  return true;
}

}  // namespace lichtraum
