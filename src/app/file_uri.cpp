#include "app/file_uri.hpp"

#include <fmt/format.h>

#include "core/ascii.hpp"
#include "core/percent.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum::app {

std::string path_of(std::string const& path_or_uri) {
  constexpr std::string_view scheme = "file:/";
  std::string_view const uri = path_or_uri;
  if (to_lower_ascii(uri.substr(0, scheme.size())) != scheme) return path_or_uri;
  std::string_view rest = uri.substr(scheme.size() - 1);
  if (rest.substr(0, 2) == "//") {
    rest.remove_prefix(2);
    std::string const host = to_lower_ascii(rest.substr(0, rest.find('/')));
    if (!host.empty() && host != "localhost") {
      throw Error(ErrorKind::no_input,
                  fmt::format("'{}' is a file of another machine, '{}': copy it to this one", path_or_uri, host));
    }
    rest.remove_prefix(host.size());
  }
  std::string const path = decode_percent(rest);
  if (path.empty() || path.find('\0') != std::string::npos) {
    throw Error(ErrorKind::no_input, fmt::format("'{}' names no file: file:///folder/scene.sdf does", path_or_uri));
  }
  return path;
}

}  // namespace lichtraum::app
