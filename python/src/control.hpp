#pragma once

#include <atomic>

#include "lichtraum/renderer.hpp"

namespace lichtraum::python {

/// What one thread tells another that draws: to stop; and what that tells it: how far it is.
class Control {
 public:
  void stop() { stops_ = true; }
  bool stops() const { return stops_; }
  double fraction() const { return fraction_; }  ///< 0..1

  /// For the thread that draws.
  ProgressFunction progress() {
    return [this](RenderProgress const& now) {
      fraction_ = now.fraction;
      return !stops_;
    };
  }

 private:
  std::atomic<bool> stops_ = false;
  std::atomic<double> fraction_ = 0;
};

}  // namespace lichtraum::python
