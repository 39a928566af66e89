#include "io/model_file.hpp"

#include <fmt/format.h>

#include "core/read_file.hpp"
#include "io/text/diagnostics.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/sandboxed_path.hpp"

namespace lichtraum {

std::optional<std::filesystem::path> find_model_file(std::optional<std::filesystem::path> const& folder,
                                                     std::span<std::filesystem::path const> allowed,
                                                     FileObserver const& on_read, std::string const& name,
                                                     std::string& reason) {
  if (!folder) {
    reason =
        fmt::format("cannot use {}: the model comes from no file, so there is no folder to look in", in_quotes(name));
    return std::nullopt;
  }
  SandboxedPath const path = resolve_sandboxed(*folder, name, allowed);
  if (!path) {
    reason = fmt::format("cannot use {}: {}", in_quotes(name), path.reason);
    return std::nullopt;
  }
  if (on_read) on_read(path.path);
  std::error_code error;
  if (std::filesystem::exists(path.path, error) && !std::filesystem::is_regular_file(path.path, error)) {
    reason = fmt::format("cannot use {}: it is not a regular file", in_quotes(name));
    return std::nullopt;
  }
  return path.path;
}

std::optional<std::string> read_found_file(std::filesystem::path const& path, std::string& reason) {
  try {
    return read_file(path);
  } catch (Error const& failure) {
    reason = failure.what();
    return std::nullopt;
  }
}

std::optional<std::string> read_model_file(std::optional<std::filesystem::path> const& folder,
                                           std::span<std::filesystem::path const> allowed, FileObserver const& on_read,
                                           std::string const& name, std::string& reason) {
  auto const path = find_model_file(folder, allowed, on_read, name, reason);
  return path ? read_found_file(*path, reason) : std::nullopt;
}

std::string hint_for_place(std::optional<std::filesystem::path> const& folder,
                           std::span<std::filesystem::path const> allowed, std::string const& name,
                           std::string_view whose) {
  bool const is_outside = folder && resolve_sandboxed(*folder, name, allowed).is_outside;
  if (!is_outside) return {};
  return fmt::format("--allow-path <folder> permits files outside of the {} folder", whose);
}

}  // namespace lichtraum
