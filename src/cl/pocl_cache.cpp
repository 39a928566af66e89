#include "cl/pocl_cache.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace lichtraum {
namespace {

namespace fs = std::filesystem;

std::string environment(char const* name) {
  char const* const value = std::getenv(name);
  return value ? value : "";
}

/// As PoCL has it (lib/CL/pocl_cache.c); empty where it takes /tmp by itself.
fs::path usual_folder() {
  if (auto const folder = environment("POCL_CACHE_DIR"); !folder.empty()) return folder;
  if (auto const folder = environment("XDG_CACHE_HOME"); !folder.empty()) return fs::path(folder) / "pocl/kcache";
  if (auto const home = environment("HOME"); !home.empty()) return fs::path(home) / ".cache/pocl/kcache";
  return {};
}

/// Makes it where it is missing, as PoCL would.
bool is_writable(fs::path const& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

/// Machine code from there is run: nobody else may have made the folder, or may write to it.
bool is_private(fs::path const& folder) {
  struct stat status {};
  return ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() &&
         (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

}  // namespace

std::optional<std::string> ensure_pocl_cache() {
  if (environment("POCL_CACHE_DIR").empty()) ::unsetenv("POCL_CACHE_DIR");  // PoCL aborts where it is set and empty
  fs::path const usual = usual_folder();
  if (!usual.empty() && is_writable(usual)) return std::nullopt;

  std::error_code error;
  fs::path const own = fs::temp_directory_path(error) / fmt::format("lichtraum-{}", ::geteuid());
  if (!error) ::mkdir(own.c_str(), S_IRWXU);
  if (!error && is_private(own) && is_writable(own)) {
    ::setenv("POCL_CACHE_DIR", own.c_str(), 1);
    return std::nullopt;
  }
  std::string const tried = error ? "the temporary directory" : own.string();
  return fmt::format(
      "PoCL needs a folder for the programs that it compiles, and neither {} nor {} can be written: set POCL_CACHE_DIR "
      "to one that can",
      usual.empty() ? "$HOME/.cache" : usual.string(), tried);
}

}  // namespace lichtraum
