#include "lichtraum.hpp"

#include <sstream>

Process Lichtraum::process(std::string const& words) const {
  Process process;
  process.arguments = {LICHTRAUM_PROGRAM};
  std::istringstream in(words);
  for (std::string word; in >> word;) process.arguments.push_back(word);
  process.folder = folder.path();
  return process;
}

ProcessResult Lichtraum::operator()(std::string const& words, std::string const& input) const {
  Process what = process(words);
  what.input = input;
  return run_process(what);
}

ProcessResult Lichtraum::render(std::string const& words, std::string const& input) const {
  return (*this)("render --device reference " + words, input);
}
