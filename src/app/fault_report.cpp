#include "app/fault_report.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include "core/quoted_for_shell.hpp"

namespace lichtraum::app {
namespace {

std::string operating_system() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown system";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

}  // namespace

std::string fault_report(std::string_view what, std::vector<std::string> const& command_line) {
  std::string command;
  for (std::string const& word : command_line) command += " " + quoted_for_shell(word);
  return fmt::format(
      "this is a fault in lichtraum: {}\n"
      "  command:{}\n"
      "  version: lichtraum {} on {}\n"
      "  Please report it, with these lines and the scene if you can, to {}",
      what, command, LICHTRAUM_VERSION, operating_system(), LICHTRAUM_REPORT_TO);
}

}  // namespace lichtraum::app
