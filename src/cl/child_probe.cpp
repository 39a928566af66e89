#include "cl/child_probe.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <vector>

#include "cl/opencl_devices.hpp"

namespace lichtraum {
namespace {

constexpr auto time_limit = std::chrono::seconds(20);
constexpr std::uint64_t little_memory = std::uint64_t(1) << 30;
constexpr rlim_t little_stack = rlim_t(1) << 18;  // PoCL reads /proc/cpuinfo into 64 KiB of it

/// Of this thread's stack (ulimit -s), where it is little.
std::optional<rlim_t> short_stack() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= little_stack) return std::nullopt;
  return stack.rlim_cur;
}

/// What the child prints until it ends or the time is up; true in the first case.
bool read_until_end(int pipe, std::string& text) {
  auto const deadline = std::chrono::steady_clock::now() + time_limit;
  for (;;) {
    auto const left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    pollfd ready{pipe, POLLIN, 0};
    if (poll(&ready, 1, int(left.count())) <= 0) continue;
    char buffer[4096];
    ssize_t const count = read(pipe, buffer, sizeof buffer);
    if (count == 0) return true;
    if (count > 0) text.append(buffer, std::size_t(count));
  }
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  auto const start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

}  // namespace

bool opencl_may_abort() {
  if (access("/sys/devices/system/cpu/cpu0", R_OK | X_OK) != 0) return true;
  if (short_stack()) return true;
  rlimit address_space{};
  if (getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY) return true;
  struct sysinfo memory {};
  return sysinfo(&memory) != 0 || std::uint64_t(memory.totalram) * memory.mem_unit < little_memory;
}

std::optional<std::string> probe_opencl_in_child() {
  int ends[2];
  if (pipe(ends) != 0) return "a pipe to a child process could not be created";
  pid_t const child = fork();
  if (child == 0) {
    rlimit const no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    std::vector<std::string> warnings;
    find_opencl_devices(warnings);
    _exit(0);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return "a child process could not be started";
  }
  std::string printed;
  bool const ended = read_until_end(ends[0], printed);
  if (!ended) kill(child, SIGKILL);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!ended) return fmt::format("it did not answer within {} seconds", time_limit.count());
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
  auto reason = WIFSIGNALED(status)
                    ? fmt::format("it was killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)))
                    : fmt::format("it exited with status {}", WEXITSTATUS(status));
  if (auto const line = last_line(printed); !line.empty()) reason += ": " + line;
  if (auto const stack = short_stack()) {
    reason += fmt::format("; stacks are limited to {} KiB here: ulimit -s 8192 allows more", *stack / 1024);
  }
  return reason;
}

}  // namespace lichtraum
