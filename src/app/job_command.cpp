#include <fmt/format.h>

#include "app/arguments.hpp"
#include "app/job_commands.hpp"
#include "core/counted.hpp"

namespace lichtraum::app {
namespace {

constexpr Command job_commands[] = {
    {"plan", "SCENE... -o DIR", "cut pictures into units, in a shared folder", job_plan_command},
    {"work", "DIR", "draw units that are missing", job_work_command},
    {"status", "DIR", "tell how many units are done", job_status_command},
    {"merge", "DIR -o FILE", "put the units together to pictures", job_merge_command},
    {"script", "QUEUE DIR", "print what a queue needs to draw them", job_script_command},
};

std::string job_help() {
  std::string text =
      "Draws pictures on many machines that share a folder. Each machine runs 'work';\n"
      "the picture has the bytes that 'lichtraum render' would write.\n"
      "\n"
      "Usage: lichtraum job COMMAND [OPTION]...\n"
      "\n"
      "Commands:\n";
  for (Command const& command : job_commands) {
    text += fmt::format("  {:<28}{}\n", fmt::format("{} {}", command.name, command.arguments), command.summary);
  }
  return text +
         "\n"
         "General:\n"
         "  -h,--help                   Show this help; 'lichtraum job COMMAND --help'\n"
         "                              explains a command\n"
         "\n"
         "Examples:\n"
         "  lichtraum job plan hello.sdf --size 4000x3000 -o work\n"
         "  lichtraum job work work     (on every machine)\n"
         "  lichtraum job merge work -o hello.png\n";
}

}  // namespace

int job_command(Arguments const& arguments, Console& console) {
  if (arguments.empty()) throw Error(ErrorKind::usage, "a command is missing: lichtraum job --help lists them");
  std::string const& word = arguments.front();
  if (word == "--help" || word == "-h" || word == "help") {
    write_standard_output(job_help());
    return 0;
  }
  std::vector<std::string> names;
  for (Command const& command : job_commands) {
    if (command.name == word) return command.run({arguments.begin() + 1, arguments.end()}, console);
    names.emplace_back(command.name);
  }
  std::string const near = nearest(word, names);
  throw Error(ErrorKind::usage, fmt::format("'job {}' is not a command: {}", word,
                                            near.empty() ? "lichtraum job --help lists them"
                                                         : fmt::format("did you mean 'lichtraum job {}'?", near)));
}

std::string unit_text(std::int64_t count) { return counted(std::uint64_t(count), "unit"); }

}  // namespace lichtraum::app
