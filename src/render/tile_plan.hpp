#pragma once

#include <algorithm>

#include "lichtraum/renderer.hpp"
#include "shared/frame.h"

namespace lichtraum {

/// Cuts a region of pixels, with all their samples, into tiles of about as much work as asked for. Pixels come in bands
/// from the top, and within a band from the left; the samples of a tile's pixels may be spread over several tiles that
/// follow each other.
class TilePlan {
 public:
  /// Tiles start and end at multiples of this (counted from the region's corner), except at the region's border.
  static constexpr int granularity = 8;

  /// Of the samples [first_sample, first_sample + sample_count). `launch_pixels`: how many a tile has, if its budget
  /// allows one sample of each; with 0, as many as it allows all samples of.
  TilePlan(Region const& region, int sample_count, int first_sample = 0, double launch_pixels = 0)
      : region_(region), sample_count_(sample_count), first_sample_(first_sample), launch_pixels_(launch_pixels) {}

  bool is_done() const { return band_y_ >= region_.height; }
  /// Whether all samples of the pixels traced so far are in.
  bool is_between_pixels() const { return sample_ == 0; }
  /// The pixels whose samples are being traced.
  Region current_pixels() const { return {region_.x + x_, region_.y + band_y_, width_, height_}; }

  /// Not to be called when done. `budget`: pixels times samples.
  device::Tile next(double budget) {
    if (sample_ == 0) choose_pixels(budget);
    double const pixels = double(width_) * double(height_);
    int const samples = int(std::clamp(budget / pixels, 1.0, double(sample_count_ - sample_)));
    device::Tile const tile{device::uint(region_.x + x_),
                            device::uint(region_.y + band_y_),
                            device::uint(width_),
                            device::uint(height_),
                            device::uint(first_sample_ + sample_),
                            device::uint(samples),
                            {0, 0}};
    advance(samples);
    return tile;
  }

 private:
  static int rounded(double length, int available) {
    double const steps = std::max(1.0, length / granularity);
    return steps * granularity >= available ? available : int(steps) * granularity;
  }

  void choose_pixels(double budget) {
    double const pixels = launch_pixels_ > 0 ? std::min(budget, launch_pixels_) : budget / sample_count_;
    if (x_ == 0) height_ = rounded(pixels / double(region_.width), region_.height - band_y_);
    width_ = rounded(pixels / double(height_), region_.width - x_);
  }

  void advance(int samples) {
    sample_ += samples;
    if (sample_ < sample_count_) return;
    sample_ = 0;
    x_ += width_;
    if (x_ < region_.width) return;
    x_ = 0;
    band_y_ += height_;
  }

  Region region_;
  int sample_count_;
  int first_sample_;
  double launch_pixels_;
  int band_y_ = 0;
  int x_ = 0;
  int width_ = 0;
  int height_ = 0;
  int sample_ = 0;
};

}  // namespace lichtraum
