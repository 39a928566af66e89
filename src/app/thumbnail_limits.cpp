#include "app/thumbnail_limits.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "app/exit_code.hpp"

namespace lichtraum::app {
namespace {

constexpr unsigned most_seconds = 20;
constexpr rlim_t most_bytes = rlim_t(4) << 30;

extern "C" void on_timeout(int) {
  constexpr std::string_view message = "lichtraum: error: no thumbnail after 20 s: lichtraum render has no limit\n";
  [[maybe_unused]] auto const written = ::write(STDERR_FILENO, message.data(), message.size());
  _exit(exit_code(ErrorKind::internal));
}

}  // namespace

void limit_thumbnail() {
  struct sigaction action {};
  action.sa_handler = on_timeout;
  sigaction(SIGALRM, &action, nullptr);
  ::alarm(most_seconds);
  // Not RLIMIT_AS: drivers of graphics cards reserve addresses by the terabyte and use next to none.
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(most_bytes, limit.rlim_max);
  ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace lichtraum::app
