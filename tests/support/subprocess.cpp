#include "support/subprocess.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Of all its threads; 0 when it has ended.
double cpu_seconds_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool is_due(Process::Signal const& signal, double seconds, pid_t process) {
  if (seconds < signal.after_seconds) return false;
  return signal.after_cpu_seconds == 0 || cpu_seconds_of(process) >= signal.after_cpu_seconds;
}

/// Both ends of a pipe, or of a terminal.
struct Channel {
  int ours = -1;
  int theirs = -1;
};

Channel make_pipe(bool we_read) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return we_read ? Channel{ends[0], ends[1]} : Channel{ends[1], ends[0]};
}

Channel make_terminal() {
  Channel channel;
  winsize size{24, 80, 0, 0};
  if (::openpty(&channel.ours, &channel.theirs, nullptr, nullptr, &size) != 0) throw std::runtime_error("no terminal");
  ::fcntl(channel.ours, F_SETFD, FD_CLOEXEC);
  return channel;
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

[[noreturn]] void become(Process const& process, int in, int out, int err) {
  ::dup2(in, STDIN_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (process.closes_output) {
    ::close(STDOUT_FILENO);
  } else if (!process.output_file.empty()) {
    ::dup2(::open(process.output_file.c_str(), O_WRONLY | O_CREAT, 0666), STDOUT_FILENO);
  } else {
    ::dup2(out, STDOUT_FILENO);
  }
  if (::chdir(process.folder.c_str()) != 0) ::_exit(126);
  if (process.max_file_bytes) {
    rlimit const limit{*process.max_file_bytes, *process.max_file_bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (auto const& [name, value] : process.environment) ::setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> arguments;
  for (std::string const& argument : process.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

}  // namespace

ProcessResult run_process(Process const& process) {
  Channel in = make_pipe(false);
  Channel out = make_pipe(true);
  Channel err = process.has_terminal ? make_terminal() : make_pipe(true);
  auto const old_handler = ::signal(SIGPIPE, SIG_IGN);
  auto const start = Clock::now();
  pid_t const child = ::fork();
  if (child == 0) {
    ::signal(SIGPIPE, SIG_DFL);
    become(process, in.theirs, out.theirs, err.theirs);
  }
  close_end(in.theirs);
  close_end(out.theirs);
  close_end(err.theirs);
  if (process.stops_reading) close_end(out.ours);
  ::fcntl(in.ours, F_SETFL, O_NONBLOCK);
  if (process.input.empty()) close_end(in.ours);

  ProcessResult result;
  std::size_t written = 0;
  std::size_t sent = 0;
  auto last_sent = start;
  while (out.ours >= 0 || err.ours >= 0) {
    double const now = seconds_since(start);
    if (now > process.timeout_seconds) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      throw std::runtime_error("the program did not end in time; it said: " + result.err);
    }
    if (sent < process.signals.size() && is_due(process.signals[sent], now, child)) {
      ::kill(child, process.signals[sent++].number);
      last_sent = Clock::now();
    }
    std::array<pollfd, 3> events{{{out.ours, POLLIN, 0}, {err.ours, POLLIN, 0}, {in.ours, POLLOUT, 0}}};
    ::poll(events.data(), events.size(), 10);
    auto const read_from = [](int& descriptor, short ready, std::string& text) {
      std::array<char, 65536> buffer;
      if ((ready & (POLLIN | POLLHUP | POLLERR)) == 0) return;
      ssize_t const count = ::read(descriptor, buffer.data(), buffer.size());
      if (count > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EAGAIN) {
        close_end(descriptor);  // a terminal whose other end is closed gives EIO
      }
    };
    if (out.ours >= 0) read_from(out.ours, events[0].revents, result.out);
    if (err.ours >= 0) read_from(err.ours, events[1].revents, result.err);
    if (in.ours >= 0 && (events[2].revents & (POLLOUT | POLLERR)) != 0) {
      ssize_t const count = ::write(in.ours, process.input.data() + written, process.input.size() - written);
      if (count > 0) written += static_cast<std::size_t>(count);
      if (count < 0 || written == process.input.size()) close_end(in.ours);
    }
  }
  close_end(in.ours);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::signal(SIGPIPE, old_handler);
  result.seconds = seconds_since(start);
  result.seconds_after_signal = seconds_since(last_sent);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

bool has_pseudo_terminals() {
  int ours = -1;
  int theirs = -1;
  if (::openpty(&ours, &theirs, nullptr, nullptr, nullptr) != 0) return false;
  ::close(ours);
  ::close(theirs);
  return true;
}

bool is_installed(std::string const& program) {
  Process process;
  process.arguments = {"sh", "-c", "command -v " + program};
  return run_process(process).exit_code == 0;
}
