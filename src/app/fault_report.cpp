#include "app/fault_report.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cctype>

namespace lichtraum::app {
namespace {

std::string quoted_for_shell(std::string const& word) {
  constexpr std::string_view harmless = "-_./,:=+@%";
  bool const is_harmless = !word.empty() && std::all_of(word.begin(), word.end(), [&](unsigned char c) {
    return std::isalnum(c) || harmless.find(char(c)) != std::string_view::npos;
  });
  if (is_harmless) return word;
  std::string text = "'";
  for (char const c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

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
