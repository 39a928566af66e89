#include "app/input_list.hpp"

#include <fmt/format.h>
#include <glob.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "lichtraum/error.hpp"

namespace lichtraum::app {
namespace {

std::vector<std::string> matches(std::string const& pattern) {
  struct Glob {
    glob_t list{};
    ~Glob() { ::globfree(&list); }
  } found;
  int const code = ::glob(pattern.c_str(), GLOB_NOSORT | GLOB_NOESCAPE, nullptr, &found.list);
  if (code == GLOB_NOMATCH) {
    bool const is_deep = pattern.find("**") != std::string::npos;
    throw Error(ErrorKind::no_input, fmt::format("no file matches '{}'{}", pattern,
                                                 is_deep ? ": * stays within one folder, and so does **" : ""));
  }
  if (code != 0) throw Error(ErrorKind::no_input, fmt::format("cannot look for '{}'", pattern));
  std::vector<std::string> files(found.list.gl_pathv, found.list.gl_pathv + found.list.gl_pathc);
  std::sort(files.begin(), files.end(), comes_before);
  return files;
}

}  // namespace

bool comes_before(std::string const& a, std::string const& b) {
  int const order = ::strverscmp(a.c_str(), b.c_str());
  return order != 0 ? order < 0 : a < b;
}

std::vector<std::string> expand_patterns(std::vector<std::string> const& arguments) {
  std::vector<std::string> inputs;
  for (std::string const& argument : arguments) {
    bool const is_pattern = argument.find_first_of("*?[") != std::string::npos;
    if (!is_pattern || ::access(argument.c_str(), F_OK) == 0) {
      inputs.push_back(argument);
      continue;
    }
    for (std::string& file : matches(argument)) inputs.push_back(std::move(file));
  }
  return inputs;
}

}  // namespace lichtraum::app
