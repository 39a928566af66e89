#include "app/terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <string>
#include <string_view>

#include "app/interruption.hpp"

namespace lichtraum::app {
namespace {

/// The terminal, open for asking, with its keys neither shown nor held back until a line is whole.
class RawTerminal {
 public:
  RawTerminal() : descriptor_(::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    // From the background, asking would stop the process.
    is_usable_ = descriptor_ >= 0 && ::tcgetpgrp(descriptor_) == ::getpgrp() && ::tcgetattr(descriptor_, &old_) == 0;
    if (!is_usable_) return;
    termios raw = old_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    is_usable_ = ::tcsetattr(descriptor_, TCSANOW, &raw) == 0;
  }
  ~RawTerminal() {
    // What came too late is not for the shell to read.
    if (is_usable_) ::tcsetattr(descriptor_, TCSAFLUSH, &old_);
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  RawTerminal(RawTerminal const&) = delete;
  RawTerminal& operator=(RawTerminal const&) = delete;

  bool is_usable() const { return is_usable_; }

  bool write(std::string_view text) { return ::write(descriptor_, text.data(), text.size()) == ssize_t(text.size()); }

  /// What comes until `is_enough`, the time is over, or the user interrupts.
  template <class Predicate>
  std::string read_until(Predicate const& is_enough, std::chrono::milliseconds timeout) {
    constexpr std::size_t most_bytes = 4096;
    auto const end = std::chrono::steady_clock::now() + timeout;
    std::string answer;
    while (!is_enough(answer) && answer.size() < most_bytes && !interrupted()) {
      auto const left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      pollfd event{descriptor_, POLLIN, 0};
      if (left.count() <= 0 || ::poll(&event, 1, int(left.count())) <= 0) break;
      char buffer[256];
      ssize_t const count = ::read(descriptor_, buffer, sizeof buffer);
      if (count <= 0) break;
      answer.append(buffer, static_cast<std::size_t>(count));
    }
    return answer;
  }

 private:
  int descriptor_;
  termios old_{};
  bool is_usable_ = false;
};

/// The parameters of an answer to "\x1b[c", as in "\x1b[?62;4;22c"; empty when there is none yet.
std::string_view device_attributes(std::string_view answer) {
  std::size_t const begin = answer.find("\x1b[?");
  if (begin == std::string_view::npos) return {};
  std::size_t const end = answer.find('c', begin);
  return end == std::string_view::npos ? std::string_view() : answer.substr(begin + 3, end - begin - 3);
}

bool has_parameter(std::string_view parameters, std::string_view wanted) {
  while (!parameters.empty()) {
    std::size_t const end = parameters.find(';');
    if (parameters.substr(0, end) == wanted) return true;
    if (end == std::string_view::npos) return false;
    parameters.remove_prefix(end + 1);
  }
  return false;
}

}  // namespace

std::optional<TerminalSize> terminal_size() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) != 1 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return std::nullopt;
  TerminalSize result;
  if (size.ws_col > 0) result.columns = size.ws_col;
  if (size.ws_row > 0) result.rows = size.ws_row;
  if (size.ws_xpixel >= size.ws_col && size.ws_ypixel >= size.ws_row && size.ws_col > 0 && size.ws_row > 0) {
    result.cell_width = size.ws_xpixel / size.ws_col;
    result.cell_height = size.ws_ypixel / size.ws_row;
  }
  return result;
}

TerminalGraphics ask_for_graphics(std::chrono::milliseconds timeout) {
  GracefulScope const graceful;  // Ctrl-C must not leave the terminal as it is now
  RawTerminal terminal;
  // Whether a kitty picture of one pixel could be shown, then what every terminal answers: the device attributes.
  if (!terminal.is_usable() || !terminal.write("\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c")) {
    return TerminalGraphics::blocks;
  }
  std::string const answer =
      terminal.read_until([](std::string const& text) { return !device_attributes(text).empty(); }, timeout);
  if (answer.find("\x1b_Gi=31;OK") != std::string::npos) return TerminalGraphics::kitty;
  return has_parameter(device_attributes(answer), "4") ? TerminalGraphics::sixel : TerminalGraphics::blocks;
}

}  // namespace lichtraum::app
