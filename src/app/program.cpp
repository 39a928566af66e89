#include "app/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <new>
#include <system_error>

#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/thread_stacks.hpp"

namespace lichtraum::app {
namespace {

/// A file opened later must not become standard output because that was closed. What is written there fails all the
/// same, while messages that nobody reads do no harm.
void open_standard_streams() {
  for (int descriptor = 0; descriptor <= STDERR_FILENO; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    ::open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_RDWR);  // the lowest number that is free
  }
}

}  // namespace

int run_program(std::vector<std::string> const& command_line, std::function<int(Console&)> const& work) {
  open_standard_streams();
  handle_signals();
  ensure_thread_stacks();
  Console console(command_line);
  try {
    return work(console);
  } catch (Error const& error) {
    console.show(error);
    return exit_code(error.kind());
  } catch (std::bad_alloc const&) {
    console.error("there is not enough memory");
    return exit_code(ErrorKind::internal);
  } catch (std::system_error const& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) {
      console.error("the system starts no more threads: see ulimit -u, or the container's limit of processes");
    } else {
      console.fault(error.what());
    }
    return exit_code(ErrorKind::internal);
  } catch (std::exception const& error) {
    console.fault(error.what());
    return exit_code(ErrorKind::internal);
  }
}

}  // namespace lichtraum::app
