#include "source_files.hpp"

#include "app/files_read.hpp"

namespace lichtraum::python {

void SourceFiles::add(std::filesystem::path const& file) {
  std::error_code not_there;
  auto const name = std::filesystem::canonical(file, not_there);
  if (!not_there) names_.insert(name);
}

void SourceFiles::refuse_to_overwrite(std::filesystem::path const& output) const {
  app::FilesRead files;
  for (std::filesystem::path const& name : names_) files.add(name);
  files.refuse_to_overwrite(output);
}

}  // namespace lichtraum::python
