#include "io/esdf/named_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "lichtraum/sandboxed_path.hpp"

namespace lichtraum::esdf {

std::optional<std::filesystem::path> find_named_file(Interpreter& interpreter, Token name) {
  SandboxedPath const path =
      resolve_sandboxed(interpreter.source.folder, std::filesystem::path(name), interpreter.options.allowed_paths);
  if (!path) {
    interpreter.error(Code::file_outside, name, fmt::format("cannot use {}: {}", in_quotes(name), path.reason),
                      "--allow-path <folder> permits files outside of the scene's folder");
    return std::nullopt;
  }
  std::error_code error;
  auto const status = std::filesystem::status(path.path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    interpreter.error(Code::unreadable_file, name,
                      fmt::format("cannot read {}: it is not a regular file", in_quotes(name)));
    return std::nullopt;
  }
  return path.path;
}

}  // namespace lichtraum::esdf
