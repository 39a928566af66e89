#include "app/interruption.hpp"

#include <signal.h>
#include <unistd.h>

namespace lichtraum::app {
namespace {

// A signal handler can reach nothing but globals: these two are the program's only ones.
volatile sig_atomic_t graceful = 0;
volatile sig_atomic_t signalled = 0;

extern "C" void on_signal(int) {
  if (graceful == 0 || signalled != 0) _exit(130);
  signalled = 1;
}

}  // namespace

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

GracefulScope::GracefulScope() { graceful = 1; }
GracefulScope::~GracefulScope() { graceful = 0; }

bool interrupted() { return signalled != 0; }

}  // namespace lichtraum::app
