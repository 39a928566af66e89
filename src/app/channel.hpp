#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace lichtraum::app {

/// Hands values from one thread to another, one at a time: a sender that is ahead waits.
template <class Value>
class Channel {
 public:
  /// Waits until the value before this one was taken. False when nobody will take it.
  bool send(Value value) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !value_ || is_closed_; });
    if (is_closed_) return false;
    value_ = std::move(value);
    changed_.notify_all();
    return true;
  }

  /// Waits for a value, but not longer than `patience`.
  std::optional<Value> receive(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return value_.has_value(); });
    if (!value_) return std::nullopt;
    std::optional<Value> value = std::move(value_);
    value_.reset();
    changed_.notify_all();
    return value;
  }

  /// The receiver wants no more: the sender stops waiting.
  void close() {
    std::lock_guard const lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Value> value_;
  bool is_closed_ = false;
};

}  // namespace lichtraum::app
