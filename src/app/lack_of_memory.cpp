#include "app/lack_of_memory.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "app/exit_code.hpp"
#include "app/interruption.hpp"

namespace lichtraum::app {
namespace {

// Handlers can reach nothing but globals.
std::atomic<bool> is_memory_lacking = false;

void on_lack() {
  is_memory_lacking = true;
  throw std::bad_alloc();
}

/// std::terminate also comes for exceptions in destructors, such as of nlohmann::json, which takes memory in its own.
[[noreturn]] void on_terminate() {
  if (!is_memory_lacking) std::abort();
  remove_unfinished_file();
  constexpr std::string_view message = "lichtraum: error: there is not enough memory\n";
  [[maybe_unused]] ssize_t const written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(exit_code(ErrorKind::internal));
}

}  // namespace

void handle_lack_of_memory() {
  std::set_new_handler(on_lack);
  std::set_terminate(on_terminate);
}

}  // namespace lichtraum::app
