#include "app/longer_stems.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/whole_path.hpp"

namespace lichtraum::app {
namespace {

namespace fs = std::filesystem;

std::string longer_stem(fs::path const& file, std::size_t folder_count, bool with_extension) {
  std::string name = file.stem().string();
  fs::path folder = file.parent_path();
  for (std::size_t i = 0; i < folder_count && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
    name = folder.filename().string() + "_" + name;
  }
  if (with_extension && file.has_extension()) name += "_" + file.extension().string().substr(1);
  return name;
}

/// Of different files, in the same order.
std::vector<std::string> tell_apart(std::vector<fs::path> const& files) {
  auto const depth = [](fs::path const& file) { return std::distance(file.begin(), file.end()); };
  auto const deepest = std::size_t(depth(*std::ranges::max_element(files, {}, depth)));
  std::vector<std::string> names;
  for (bool const with_extension : {false, true}) {
    for (std::size_t folders = 0; folders < deepest; ++folders) {
      names.clear();
      for (fs::path const& file : files) names.push_back(longer_stem(file, folders, with_extension));
      if (std::set(names.begin(), names.end()).size() == names.size()) return names;
    }
  }
  return names;
}

}  // namespace

std::map<std::string, std::string> longer_stems(std::vector<std::string> const& inputs) {
  std::map<std::string, std::set<fs::path>> by_stem;
  for (std::string const& input : inputs) {
    if (input != "-") by_stem[fs::path(input).stem().string()].insert(whole_path(input));
  }
  std::map<fs::path, std::string> names;
  for (auto const& [stem, set] : by_stem) {
    if (set.size() == 1) continue;
    std::vector<fs::path> const files(set.begin(), set.end());
    auto const apart = tell_apart(files);
    for (std::size_t i = 0; i < files.size(); ++i) names[files[i]] = apart[i];
  }
  std::map<std::string, std::string> stems;
  for (std::string const& input : inputs) {
    if (input == "-") continue;
    if (auto const found = names.find(whole_path(input)); found != names.end()) stems[input] = found->second;
  }
  return stems;
}

}  // namespace lichtraum::app
