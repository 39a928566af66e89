#include "app/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace lichtraum::app {
namespace {

constexpr double interval_seconds = 0.1;

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string duration(double seconds) {
  auto const whole = static_cast<long>(std::min(seconds, 1e9) + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

// In one call, so that a terminal never shows half of it.
void write_at_once(std::string const& text) {
  [[maybe_unused]] ssize_t const written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

std::string progress_line(std::string const& title, RenderProgress const& progress, int columns) {
  if (progress.is_compiling) {
    return fmt::format("{}  compiling for the device", title).substr(0, std::size_t(std::max(0, columns - 1)));
  }
  double const fraction = std::clamp(progress.fraction, 0.0, 1.0);
  double const rate = progress.elapsed_seconds > 0 ? 1e-6 * double(progress.rays) / progress.elapsed_seconds : 0;
  std::string const left = fraction > 0 ? duration(progress.elapsed_seconds * (1 - fraction) / fraction) + " left" : "";
  std::string const numbers = fmt::format("{:3}%  {:.1f} Mrays/s  {}", int(100 * fraction), rate, left);
  int const room = columns - 1 - int(numbers.size()) - int(title.size()) - 6;
  if (room < 10) return numbers.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
  auto const width = static_cast<std::size_t>(std::min(room, 40));
  auto const done = static_cast<std::size_t>(fraction * double(width));
  std::string bar(width, ' ');
  std::fill_n(bar.begin(), done, '=');
  if (done < width) bar[done] = '>';
  return fmt::format("{}  [{}]  {}", title, bar, numbers);
}

ProgressBar::ProgressBar(Console const& console) : is_wanted_(console.is_terminal() && !console.is_quiet()) {}

void ProgressBar::clear() {
  if (is_drawn_) write_at_once("\r\x1b[K");
  is_drawn_ = false;
}

void ProgressBar::update(std::string const& title, RenderProgress const& progress) {
  if (progress.is_compiling) {
    compiling_since_seconds_ = progress.elapsed_seconds;
  } else if (compiling_since_seconds_) {
    compiling_seconds_ += progress.elapsed_seconds - *std::exchange(compiling_since_seconds_, std::nullopt);
  }
  bool const is_due = progress.is_compiling || progress.elapsed_seconds >= next_seconds_;
  if (!is_wanted_ || !is_due) return;
  next_seconds_ = progress.elapsed_seconds + interval_seconds;
  is_drawn_ = true;
  // Overwrites the old line and clears what remains after it: no empty line in between, no flicker.
  RenderProgress shown = progress;
  shown.elapsed_seconds -= compiling_seconds_;
  write_at_once("\r" + progress_line(title, shown, terminal_columns()) + "\x1b[K");
}

}  // namespace lichtraum::app
