#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>

#include "app/arguments.hpp"
#include "app/render_options.hpp"

// `render --help` is printed, again and again. libFuzzer itself writes to standard error.
extern "C" int LLVMFuzzerInitialize(int*, char***) { return std::freopen("/dev/null", "w", stdout) ? 0 : 1; }

// Any lines are read as the words that follow `lichtraum render`; tools/fuzz runs this.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace lichtraum::app;
  std::istringstream lines(std::string(reinterpret_cast<char const*>(data), size));
  std::vector<std::string> words;
  for (std::string line; std::getline(lines, line);) words.push_back(line.substr(0, line.find('\0')));
  try {
    RenderOptions options;
    auto const parser = make_parser("render", "", "");
    add_inputs(*parser, options.scenes, "SCENE...");
    add_file_options(*parser, options, "Output");
    add_picture_options(*parser, options);
    add_sequence_options(*parser, options);
    add_drawing_options(*parser, options);
    add_input_format_option(*parser, options.input_format);
    if (parse(*parser, words)) {
      OutputNames names(options.output);
      combine(options, options.scenes, names);
      lichtraum::RenderCommand command;
      command.file = "hello.png";
      names.next(command, true);
    }
  } catch (lichtraum::Error const&) {  // what a faulty command line must end in; anything else is a finding
  }
  return 0;
}
