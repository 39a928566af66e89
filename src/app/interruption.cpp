#include "app/interruption.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace lichtraum::app {
namespace {

// A signal handler can reach nothing but globals: these are the program's only ones.
volatile sig_atomic_t graceful = 0;
volatile sig_atomic_t signalled = 0;
std::atomic<UnfinishedFile const*> unfinished = nullptr;
static_assert(decltype(unfinished)::is_always_lock_free);

extern "C" void on_signal(int) {
  if (graceful == 0 || signalled != 0) {
    remove_unfinished_file();
    _exit(130);
  }
  signalled = 1;
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

UnfinishedFile::UnfinishedFile(pid_t writer, std::filesystem::path path) : writer_(writer), path_(std::move(path)) {
  unfinished = this;
}
UnfinishedFile::~UnfinishedFile() { unfinished = nullptr; }

void remove_unfinished_file() {
  if (UnfinishedFile const* const file = unfinished) file->remove();
}

// Calls only what is async-signal-safe (POSIX, 2.4.3).
void UnfinishedFile::remove() const {
  // One that has been waited for already is no longer a child: its number may be another process's.
  if (::waitpid(writer_, nullptr, WNOHANG) == 0) {
    ::kill(writer_, SIGKILL);
    while (::waitpid(writer_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::unlink(path_.c_str());
}

}  // namespace lichtraum::app
