#pragma once

#include <optional>
#include <string>

#include "app/console.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// "hello.png  [=====>      ]  42 %  12.3 Mrays/s  3 s left" in the last line of a terminal: nothing in a pipe, with
/// --quiet, or when the work takes less than 0.3 seconds. While the device's compiler is at work it says so at once.
class ProgressBar {
 public:
  explicit ProgressBar(Console const& console);
  ~ProgressBar() { clear(); }
  ProgressBar(ProgressBar const&) = delete;
  ProgressBar& operator=(ProgressBar const&) = delete;

  void update(std::string const& title, RenderProgress const& progress);
  /// Makes room for a message.
  void clear();

 private:
  bool is_wanted_;
  double next_seconds_ = 0.3;
  std::optional<double> compiling_since_seconds_;
  double compiling_seconds_ = 0;  // which say nothing of how long the rest takes
  bool is_drawn_ = false;
};

/// The bar's line for a terminal of `columns`.
std::string progress_line(std::string const& title, RenderProgress const& progress, int columns);

}  // namespace lichtraum::app
