#pragma once

#include <map>

#include "io/file_finder.hpp"
#include "io/image/decode_all.hpp"
#include "io/obj/mtl_file.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::obj {

/// The pictures that MTL files name, each read and decoded once. The folder of an MTL file is as seen from the model's.
class Pictures {
 public:
  using Path = std::filesystem::path;

  /// All of them must outlive this.
  Pictures(std::optional<Path> const& folder, ModelOptions const& options, FileFinder& finder)
      : folder_(folder), options_(options), finder_(finder) {}

  void read(MtlTexture const& texture, Path const& mtl_folder, TexelContent content);
  /// What was read; returns what decode_images does.
  [[nodiscard]] std::string decode();
  /// Null where there is none, after a warning. Also tells of a file that was taken for another.
  std::shared_ptr<TextureImage const> image_of(MtlTexture const& texture, Path const& mtl_folder,
                                               Diagnostics& diagnostics);

 private:
  struct Picture {
    std::size_t job = 0;
    std::optional<FoundFile> found;  // where it was not as named
    bool is_told = false;
    std::string hint;
  };

  static std::string path_of(MtlTexture const& texture, Path const& mtl_folder);
  std::optional<std::string> bytes_of(std::string const& path, std::string& reason) const;
  void tell(MtlTexture const& texture, FoundFile const& found, Diagnostics& diagnostics);

  std::optional<Path> const& folder_;
  ModelOptions const& options_;
  FileFinder& finder_;
  std::vector<ImageJob> jobs_;
  std::map<std::string, std::size_t> job_numbers_;             // by the path of what was read
  std::map<std::string, Picture> pictures_;                    // by the path as named
  std::map<Diagnostics const*, std::size_t> first_elsewhere_;  // the finding about it
};

}  // namespace lichtraum::obj
