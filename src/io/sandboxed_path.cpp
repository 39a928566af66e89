#include "lichtraum/sandboxed_path.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>
#include <vector>

namespace lichtraum {
namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;  // what Linux follows before it reports a loop

// Follows every link, also one whose target does not exist: std::filesystem::weakly_canonical takes such a link for a
// plain name, and opening it would then create a file elsewhere.
std::optional<fs::path> follow_links(fs::path const& absolute, std::string& reason) {
  std::vector<fs::path> pending;  // parts still to walk, the next one last
  auto const push_parts = [&](fs::path const& path) {
    std::vector<fs::path> const parts(path.begin(), path.end());
    pending.insert(pending.end(), parts.rbegin(), parts.rend());
  };
  push_parts(absolute.relative_path());
  fs::path result = absolute.root_path();
  int links = 0;
  while (!pending.empty()) {
    fs::path const part = std::move(pending.back());
    pending.pop_back();
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      result = result.parent_path();
      continue;
    }
    std::error_code error;
    fs::path const next = result / part;
    fs::file_status const status = fs::symlink_status(next, error);
    if (status.type() == fs::file_type::none) {
      reason = error.message();
      return std::nullopt;
    }
    if (status.type() != fs::file_type::symlink) {
      result = next;
      continue;
    }
    fs::path const target = fs::read_symlink(next, error);
    if (error) {
      reason = error.message();
      return std::nullopt;
    }
    if (++links > max_links) {
      reason = "its symbolic links form a loop";
      return std::nullopt;
    }
    if (target.is_absolute()) result = target.root_path();
    push_parts(target.relative_path());
  }
  return result;
}

bool is_below(fs::path const& path, fs::path const& folder) {
  auto const [path_part, folder_part] = std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  return folder_part == folder.end() && path_part != path.end();
}

std::optional<fs::path> real_folder(fs::path const& folder) {
  std::error_code error;
  fs::path const absolute = fs::absolute(folder.empty() ? "." : folder, error);
  std::string ignored;
  return error ? std::nullopt : follow_links(absolute, ignored);
}

}  // namespace

SandboxedPath resolve_sandboxed(fs::path const& base, fs::path const& requested, std::span<fs::path const> allowed) {
  auto const refuse = [](std::string reason) { return SandboxedPath{{}, std::move(reason), false}; };
  auto const refuse_outside = [](std::string reason) { return SandboxedPath{{}, std::move(reason), true}; };
  if (requested.empty()) return refuse("it is empty");
  if (requested.native().find('\0') != std::string::npos) return refuse("it contains a NUL character");

  std::optional<fs::path> const folder = real_folder(base);
  if (!folder) return refuse("the folder '" + base.string() + "' cannot be found");
  std::string reason;
  std::optional<fs::path> const path = follow_links(*folder / requested, reason);
  if (!path) return refuse(reason);

  for (fs::path const& other : allowed) {
    std::optional<fs::path> const real = real_folder(other);
    if (real && is_below(*path, *real)) return {*path, {}, false};
  }
  if (requested.is_absolute()) return refuse_outside("it is an absolute path");
  if (std::find(requested.begin(), requested.end(), "..") != requested.end()) return refuse_outside("it contains '..'");
  if (*path == *folder) return refuse("it is the folder itself");
  if (!is_below(*path, *folder)) return refuse_outside("a symbolic link leads out of '" + folder->string() + "'");
  return {*path, {}, false};
}

}  // namespace lichtraum
