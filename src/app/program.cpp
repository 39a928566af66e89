#include "app/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <new>

#include "app/exit_code.hpp"
#include "app/interruption.hpp"

namespace lichtraum::app {
namespace {

/// A file opened later must not become standard output because that was closed.
void open_standard_streams() {
  for (int descriptor = ::open("/dev/null", O_RDWR); descriptor >= 0; descriptor = ::dup(descriptor)) {
    if (descriptor <= STDERR_FILENO) continue;
    ::close(descriptor);
    return;
  }
}

}  // namespace

int run_program(std::function<int(Console&)> const& work) {
  open_standard_streams();
  handle_signals();
  Console console;
  try {
    return work(console);
  } catch (SceneError const& error) {
    console.show(error.diagnostics());
    return exit_code(error.kind());
  } catch (Error const& error) {
    console.error(error.what());
    return exit_code(error.kind());
  } catch (std::bad_alloc const&) {
    console.error("there is not enough memory");
    return exit_code(ErrorKind::internal);
  } catch (std::exception const& error) {
    console.error(fmt::format("this is a fault in lichtraum: {}", error.what()));
    return exit_code(ErrorKind::internal);
  }
}

}  // namespace lichtraum::app
