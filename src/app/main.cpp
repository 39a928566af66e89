#include <fmt/format.h>
#include <unistd.h>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/lack_of_memory.hpp"
#include "app/program.hpp"
#include "core/quoted_for_shell.hpp"

using namespace lichtraum;
using namespace lichtraum::app;

namespace {

std::string help() {
  std::string text =
      "lichtraum draws scenes and models by ray tracing.\n\nUsage: lichtraum COMMAND [OPTION]...\n\nCommands:\n";
  for (Command const& command : commands) {
    text += fmt::format("  {:<28}{}\n", fmt::format("{} {}", command.name, command.arguments), command.summary);
  }
  return text +
         "\n"
         "Options:\n"
         "  -h,--help         this text; 'lichtraum COMMAND --help' explains a command\n"
         "  -V,--version      the version\n"
         "\n"
         "Examples:\n"
         "  lichtraum render hello.sdf               draw the scene to the file it names\n"
         "  lichtraum render hello.sdf -o hello.png  draw it to hello.png\n"
         "  lichtraum check *.sdf                    look for mistakes\n"
         "  lichtraum doctor                         test this machine\n";
}

[[noreturn]] void refuse(std::string const& word) {
  std::vector<std::string> names;
  for (Command const& command : commands) names.emplace_back(command.name);
  std::string const near = nearest(word, names);
  bool const is_file =
      word == "-" || word.find_first_of("./") != std::string::npos || ::access(word.c_str(), F_OK) == 0;
  std::string const advice = word.substr(0, 1) == "-" && word != "-"
                                 ? "options follow a command: lichtraum render --help"
                             : is_file ? fmt::format("to draw a scene: lichtraum render {}", quoted_for_shell(word))
                             : !near.empty() ? fmt::format("did you mean 'lichtraum {}'?", near)
                                             : "lichtraum --help lists the commands";
  throw Error(ErrorKind::usage, fmt::format("'{}' is not a command: {}", word, advice));
}

int run(Arguments arguments, Console& console) {
  if (arguments.empty()) throw Error(ErrorKind::usage, "a command is missing: lichtraum --help lists them");
  std::string const word = arguments.front();
  arguments.erase(arguments.begin());
  if (word == "--version" || word == "-V") {
    write_standard_output(fmt::format("lichtraum {}\n", LICHTRAUM_VERSION));
    return 0;
  }
  if (word == "help" && !arguments.empty()) return run({arguments.front(), "--help"}, console);
  if (word == "--help" || word == "-h" || word == "help") {
    write_standard_output(help());
    return 0;
  }
  for (Command const& command : commands) {
    if (command.name == word) return command.run(arguments, console);
  }
  refuse(word);
}

}  // namespace

int main(int argc, char* argv[]) {
  handle_lack_of_memory();
  Arguments const arguments(argv + 1, argv + argc);
  Arguments command_line{"lichtraum"};
  command_line.insert(command_line.end(), arguments.begin(), arguments.end());
  return run_program(command_line, [&](Console& console) { return run(arguments, console); });
}
