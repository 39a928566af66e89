#include "app/files_read.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <optional>

#include "lichtraum/error.hpp"

namespace lichtraum::app {
namespace {

std::optional<std::pair<dev_t, ino_t>> identity_of(std::filesystem::path const& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
  return std::pair(found.st_dev, found.st_ino);
}

}  // namespace

void FilesRead::add(std::filesystem::path const& file) {
  if (auto const identity = identity_of(file)) files_.insert(*identity);
}

void FilesRead::refuse_to_overwrite(std::filesystem::path const& output) const {
  auto const identity = identity_of(output);
  if (!identity || !files_.contains(*identity)) return;
  throw Error(ErrorKind::cannot_create,
              fmt::format("'{}' is read for this picture, which would take its place: give the picture another name",
                          output.string()));
}

}  // namespace lichtraum::app
