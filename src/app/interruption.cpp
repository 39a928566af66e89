#include "app/interruption.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <ctime>

namespace lichtraum::app {
namespace {

// A signal handler can reach nothing but globals: these are the program's only ones.
volatile sig_atomic_t graceful = 0;
volatile sig_atomic_t signalled = 0;
std::atomic<UnfinishedFile const*> unfinished = nullptr;
std::atomic<std::int64_t> signalled_at_ns = 0;
static_assert(decltype(unfinished)::is_always_lock_free && decltype(signalled_at_ns)::is_always_lock_free);

/// Who sends a signal to a process and then to its group, as timeout does, asks once.
constexpr std::int64_t one_request_ns = 500'000'000;

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

extern "C" void on_signal(int) {
  if (graceful != 0 && signalled == 0) {
    signalled_at_ns = now_ns();
    signalled = 1;
    return;
  }
  if (graceful != 0 && now_ns() - signalled_at_ns < one_request_ns) return;
  remove_unfinished_file();
  _exit(130);
}

}  // namespace

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // Of a terminal that is closed. Who is told not to care, as by nohup, does not.
  struct sigaction hangup {};
  if (sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

GracefulScope::GracefulScope() { graceful = 1; }
GracefulScope::~GracefulScope() { graceful = 0; }

bool interrupted() { return signalled != 0; }

UnfinishedFile::UnfinishedFile(std::optional<pid_t> writer, std::filesystem::path path)
    : writer_(writer), path_(std::move(path)) {
  unfinished = this;
}
UnfinishedFile::~UnfinishedFile() { unfinished = nullptr; }

void remove_unfinished_file() {
  if (UnfinishedFile const* const file = unfinished) file->remove();
}

// Calls only what is async-signal-safe (POSIX, 2.4.3).
void UnfinishedFile::remove() const {
  // One that has been waited for already is no longer a child: its number may be another process's.
  if (writer_ && ::waitpid(*writer_, nullptr, WNOHANG) == 0) {
    ::kill(*writer_, SIGKILL);
    while (::waitpid(*writer_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::unlink(path_.c_str());
}

}  // namespace lichtraum::app
