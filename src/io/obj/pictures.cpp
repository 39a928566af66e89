#include "io/obj/pictures.hpp"

#include <fmt/format.h>

#include "io/model_file.hpp"

namespace lichtraum::obj {

/// As seen from the model's folder.
std::string Pictures::path_of(MtlTexture const& texture, Path const& mtl_folder) {
  Path const path = texture.file;
  return path.is_absolute() ? texture.file : (mtl_folder / path).string();
}

std::optional<std::string> Pictures::bytes_of(std::string const& path, std::string& reason) const {
  return read_model_file(folder_, options_.allowed_paths, options_.on_read, path, reason);
}

void Pictures::read(MtlTexture const& texture, Path const& mtl_folder, TexelContent content) {
  if (texture.file.empty()) return;
  std::string path = path_of(texture, mtl_folder);
  auto const [at, is_new] = pictures_.try_emplace(path);
  if (!is_new) {
    if (content == TexelContent::color) jobs_[at->second.job].content = content;
    return;
  }
  Picture& picture = at->second;
  ImageJob job;
  auto bytes = bytes_of(path, job.reason);
  if (!bytes) {
    Path const homes[] = {mtl_folder, ""};
    picture.found = finder_.find(texture.bare_file, homes);
    if (picture.found) path = picture.found->path;
  }
  auto const [number, is_new_file] = job_numbers_.emplace(path, jobs_.size());
  picture.job = number->second;
  if (!is_new_file) {
    if (content == TexelContent::color) jobs_[picture.job].content = content;
    return;
  }
  job.content = content;
  if (picture.found) {
    job.reason.clear();
    bytes = bytes_of(path, job.reason);
  }
  if (!bytes) picture.hint = hint_for_place(folder_, options_.allowed_paths, path);
  job.name = texture.file;
  job.is_wanted = true;
  if (bytes) {
    job.owned = std::make_shared<std::string const>(std::move(*bytes));
    job.bytes = *job.owned;
  }
  jobs_.push_back(std::move(job));
}

std::string Pictures::decode() { return decode_images(jobs_, options_.max_texture); }

std::shared_ptr<TextureImage const> Pictures::image_of(MtlTexture const& texture, Path const& mtl_folder,
                                                       Diagnostics& diagnostics) {
  if (texture.file.empty()) return nullptr;
  Picture& picture = pictures_.at(path_of(texture, mtl_folder));
  ImageJob const& job = jobs_[picture.job];
  diagnostics.begin_line(texture.line);
  if (picture.found && !picture.is_told) tell(texture, *picture.found, diagnostics);
  picture.is_told = true;
  if (!job.image) {
    diagnostics.add(Severity::warning, DiagnosticCode::texture_left_out, {},
                    fmt::format("the picture is left out: {}", job.reason), picture.hint);
  }
  return job.image;
}

/// One warning stands for all pictures of an MTL file that are elsewhere, as often none is where it says. Notes name
/// the others.
void Pictures::tell(MtlTexture const& texture, FoundFile const& found, Diagnostics& diagnostics) {
  std::string message = used_instead(texture.file, found);
  auto const first = first_elsewhere_.find(&diagnostics);
  if (found.is_elsewhere && first == first_elsewhere_.end()) {
    diagnostics.add(Severity::warning, DiagnosticCode::file_elsewhere, {}, std::move(message));
    first_elsewhere_.emplace(&diagnostics, diagnostics.last());
    return;
  }
  if (found.is_elsewhere) diagnostics.add_again(first->second);
  diagnostics.add(Severity::note, DiagnosticCode::none, {}, std::move(message));
}

}  // namespace lichtraum::obj
