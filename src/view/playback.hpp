#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace lichtraum::view {

/// Where in an animation a window is. `now` is a clock's, in seconds; so is everything else.
class Playback {
 public:
  Playback() = default;
  /// `time`: nothing where a model stands as its nodes do, not as the animation has it at any time.
  Playback(double duration, std::optional<double> time)
      : duration_(duration), time_(std::clamp(time.value_or(0), 0.0, duration)), has_begun_(time.has_value()) {}

  double duration() const { return duration_; }
  double time() const { return time_; }
  /// Whether it is at that time. Else it was never played nor sent anywhere.
  bool has_begun() const { return has_begun_; }
  bool is_playing() const { return is_playing_; }

  /// From the start again where it stands at the end.
  void play(double now) {
    if (time_ >= duration_) time_ = 0;
    is_playing_ = duration_ > 0;
    has_begun_ = true;
    began_ = now - time_;
  }
  void pause() { is_playing_ = false; }
  /// To a time, and stays there.
  void go_to(double time) {
    is_playing_ = false;
    has_begun_ = true;
    time_ = std::clamp(time, 0.0, duration_);
  }
  /// To the next of so many frames a second, or the one before; beyond either end to the other.
  void step(int direction, double frame_rate) {
    double const frame = std::round(time_ * frame_rate) + direction, last = std::floor(duration_ * frame_rate);
    go_to(frame < 0 ? last / frame_rate : frame > last ? 0 : frame / frame_rate);
  }
  /// To where it is now; round and round. Whether it moves.
  bool advance(double now) {
    if (is_playing_) time_ = std::fmod(now - began_, duration_);
    return is_playing_;
  }

 private:
  double duration_ = 0;
  double time_ = 0;
  bool has_begun_ = false;
  bool is_playing_ = false;
  double began_ = 0;  // when it was at the start, had it not been paused
};

}  // namespace lichtraum::view
