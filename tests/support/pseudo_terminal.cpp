#include "support/pseudo_terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

[[noreturn]] void become(Process const& process) {
  if (::chdir(process.folder.c_str()) != 0) ::_exit(126);
  for (auto const& [name, value] : process.environment) ::setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> arguments;
  for (std::string const& argument : process.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

}  // namespace

ProcessResult run_in_terminal(PseudoTerminal const& terminal, Process const& process) {
  winsize const size{static_cast<unsigned short>(terminal.rows), static_cast<unsigned short>(terminal.columns),
                     static_cast<unsigned short>(terminal.columns * terminal.cell_width),
                     static_cast<unsigned short>(terminal.rows * terminal.cell_height)};
  int ours = -1;
  auto const start = Clock::now();
  pid_t const child = ::forkpty(&ours, nullptr, nullptr, &size);
  if (child < 0) throw std::runtime_error("no terminal");
  if (child == 0) become(process);

  ProcessResult result;
  std::size_t answered = 0;
  for (;;) {
    if (seconds_since(start) > process.timeout_seconds) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      ::close(ours);
      throw std::runtime_error("the program did not end in time; it said: " + result.out);
    }
    pollfd event{ours, POLLIN, 0};
    ::poll(&event, 1, 10);
    if ((event.revents & (POLLIN | POLLHUP | POLLERR)) != 0) {
      std::array<char, 65536> buffer;
      ssize_t const count = ::read(ours, buffer.data(), buffer.size());
      if (count > 0) result.out.append(buffer.data(), static_cast<std::size_t>(count));
      if (count <= 0 && errno != EINTR) break;  // EIO: the program has ended
    }
    while (answered < terminal.answers.size() &&
           result.out.find(terminal.answers[answered].first) != std::string::npos) {
      std::string const& answer = terminal.answers[answered++].second;
      [[maybe_unused]] ssize_t const written = ::write(ours, answer.data(), answer.size());
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ours);
  result.seconds = seconds_since(start);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}
