#include "io/file_finder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/ascii.hpp"
#include "core/folder_entries.hpp"
#include "io/text/diagnostics.hpp"
#include "lichtraum/sandboxed_path.hpp"

namespace lichtraum {
namespace {

namespace fs = std::filesystem;

/// Absolute, without dots, and without a slash at its end.
fs::path normal(fs::path const& path) {
  std::error_code error;
  return (fs::absolute(path.empty() ? "." : path, error) / "").lexically_normal().parent_path();
}

std::string_view without_quotes(std::string_view name) {
  bool const has_quotes =
      name.size() > 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'');
  return has_quotes ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

std::string used_instead(std::string_view name, FoundFile const& found) {
  return fmt::format("instead of {}, {} is used", in_quotes(name), in_quotes(found.path));
}

FileFinder::FileFinder(std::optional<Path> const& folder, std::span<Path const> allowed)
    : folder_(folder), allowed_(allowed) {
  if (!folder) return;
  roots_.push_back({"", normal(*folder)});
  for (Path const& other : allowed) roots_.push_back({normal(other), normal(other)});
}

std::optional<FoundFile> FileFinder::find(std::string_view name, std::span<Path const> homes) {
  Path const wanted = Path(without_quotes(name)).lexically_normal();
  for (Path const& home : homes) {
    if (auto const path = in_any_case(home, wanted)) return FoundFile{path->string(), &home != &homes.front()};
  }
  // A folder that is there was meant. A file of that name in another one is another file.
  auto const is_there = [&](Path const& home) { return follow(home, wanted.parent_path()).has_value(); };
  if (wanted.has_parent_path() && std::any_of(homes.begin(), homes.end(), is_there)) return std::nullopt;
  for (char const* const folder : {"", "textures", "tex", "maps"}) {
    for (Path const& home : homes) {
      if (auto const path = in_any_case(home, folder / wanted.filename())) return FoundFile{path->string(), true};
    }
  }
  return std::nullopt;
}

std::optional<fs::path> FileFinder::in_any_case(Path const& home, Path const& name) {
  auto path = follow(home, name);
  auto const file = path ? real(*path) : std::nullopt;
  std::error_code error;
  return file && fs::is_regular_file(*file, error) ? path : std::nullopt;
}

/// Where a path leads, its letters in any case; as seen from the model's folder.
std::optional<fs::path> FileFinder::follow(Path const& home, Path const& name) {
  if (!folder_) return std::nullopt;
  Path const target = normal(*folder_ / home / name);
  for (Root const& root : roots_) {
    auto [in_root, part] = std::mismatch(root.absolute.begin(), root.absolute.end(), target.begin(), target.end());
    if (in_root != root.absolute.end()) continue;
    Path path = root.shown;
    for (; part != target.end(); ++part) {
      Names const& names = names_in(path);
      auto const same = names.find(to_lower_ascii(part->string()));
      if (same == names.end()) break;
      path /= same->second.contains(part->string()) ? part->string() : *same->second.begin();
    }
    if (part == target.end()) return path;
  }
  return std::nullopt;
}

/// Nothing where it may not be read.
std::optional<fs::path> FileFinder::real(Path const& shown) const {
  for (Root const& root : roots_) {
    if (root.shown == shown) return root.absolute;
  }
  SandboxedPath const path = resolve_sandboxed(*folder_, shown, allowed_);
  return path ? std::optional(path.path) : std::nullopt;
}

FileFinder::Names const& FileFinder::names_in(Path const& shown) {
  auto const [found, is_new] = names_.try_emplace(shown);
  Names& names = found->second;
  if (!is_new || entries_ >= max_entries) return names;
  ++entries_;  // the folder itself: there may be many empty ones
  auto const folder = real(shown);
  if (!folder) return names;
  std::size_t const left = max_entries - entries_;
  std::size_t count = 0;
  for_each_entry(
      *folder,
      [&](fs::directory_entry const& entry) {
        std::string name = entry.path().filename().string();
        names[to_lower_ascii(name)].insert(std::move(name));
        ++count;
      },
      left + 1);
  entries_ += count;
  if (count > left) names.clear();  // what a part of it holds is chance
  return names;
}

}  // namespace lichtraum
