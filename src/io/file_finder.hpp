#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichtraum {

/// Where a file is that a model names otherwise.
struct FoundFile {
  std::string path;           ///< as seen from the model's folder
  bool is_elsewhere = false;  ///< in another folder: perhaps not the one that was meant; else only written otherwise
};

/// "instead of 'C:/Users/bob/tex.png', 'textures/tex.png' is used", for people.
std::string used_instead(std::string_view name, FoundFile const& found);

/// Looks for files that are not where a model says. Models are made on other machines, whose folders are not here, and
/// on Windows, where upper and lower case are the same. Looks into folders only where model files may be read, sees at
/// most max_entries in all of them, and remembers these.
class FileFinder {
 public:
  using Path = std::filesystem::path;
  static constexpr std::size_t max_entries = 10000;

  /// `folder` is the model's; without one, nothing is found. Both must outlive this.
  FileFinder(std::optional<Path> const& folder, std::span<Path const> allowed);

  /// The file that a name in quotes, or in other letter case, means: a path from one of the `homes`, which are folders
  /// as seen from the model's. Where the name's own folder is not there, or it has none: a file of just its last part
  /// in a home, or in a folder in it for pictures. What comes first counts first.
  std::optional<FoundFile> find(std::string_view name, std::span<Path const> homes);

  /// The regular file `name` in `home`, its letters in any case: as written where there is such a one.
  std::optional<Path> in_any_case(Path const& home, Path const& name);

 private:
  /// A folder that may be read, with all below it.
  struct Root {
    Path shown;  // as seen from the model's folder
    Path absolute;
  };
  using Names = std::map<std::string, std::set<std::string>>;  // by what they are in lower case

  std::optional<Path> follow(Path const& home, Path const& name);
  std::optional<Path> real(Path const& shown) const;
  Names const& names_in(Path const& shown);

  std::optional<Path> const& folder_;
  std::span<Path const> allowed_;
  std::vector<Root> roots_;
  std::map<Path, Names> names_;
  std::size_t entries_ = 0;  // seen so far
};

}  // namespace lichtraum
