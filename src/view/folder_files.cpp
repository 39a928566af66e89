#include "view/folder_files.hpp"

#include <strings.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/input_list.hpp"
#include "core/folder_entries.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::view {
namespace {

bool is_readable(std::filesystem::path const& file) {
  return ::strcasecmp(file.extension().c_str(), ".sdf") == 0 || is_model_file(file);
}

std::vector<std::string> readable_names(std::filesystem::path const& folder) {
  std::vector<std::string> names;
  for_each_entry(folder.empty() ? "." : folder, [&](std::filesystem::directory_entry const& entry) {
    std::error_code unknown;
    if (is_readable(entry.path()) && entry.is_regular_file(unknown)) names.push_back(entry.path().filename());
  });
  std::sort(names.begin(), names.end(), app::comes_before);
  return names;
}

/// The file itself need not be one of them.
std::optional<std::filesystem::path> neighbor(std::filesystem::path const& file, int direction) {
  std::filesystem::path const folder = file.parent_path();
  std::string const name = file.filename();
  std::vector<std::string> const names = readable_names(folder);
  if (names.empty()) return std::nullopt;
  std::string found;
  if (direction > 0) {
    auto const next = std::upper_bound(names.begin(), names.end(), name, app::comes_before);
    found = next == names.end() ? names.front() : *next;
  } else {
    auto const next = std::lower_bound(names.begin(), names.end(), name, app::comes_before);
    found = next == names.begin() ? names.back() : *std::prev(next);
  }
  if (found == name) return std::nullopt;
  return folder / found;
}

}  // namespace

void FolderFiles::open(std::filesystem::path const& file) {
  file_ = file;
  direction_ = 0;
}

std::optional<std::filesystem::path> FolderFiles::step(int direction) {
  auto const next = neighbor(file_, direction);
  if (!next) return next;
  start_ = std::exchange(file_, *next);
  direction_ = direction;
  return next;
}

std::optional<std::filesystem::path> FolderFiles::skip() {
  if (direction_ == 0) return std::nullopt;
  auto const next = neighbor(file_, direction_);
  // Files come and go: what lies at or behind the start, seen in this direction, has been tried.
  bool const is_round = !next || *next == start_;
  if (is_round) direction_ = 0;
  file_ = is_round ? start_ : *next;
  return file_;
}

}  // namespace lichtraum::view
