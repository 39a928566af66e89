#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh_format.hpp"
#include "lichtraum/file_stamp.hpp"

namespace lichtraum {

/// Models that scenes include. One that was read before, and none of whose files has changed since, is not read again.
/// For scenes that are read with the same options; from any thread.
class ModelCache {
 public:
  /// A new script begins: what neither the one before nor this one includes is forgotten.
  void begin_script();

  /// The model as one shape called `name`, of nodes of its own, which moves as one. It stands where its file says, also
  /// where that is far away. Same exceptions as format.import.
  std::shared_ptr<Shape> shape(MeshFormat const& format, std::filesystem::path const& path, ModelOptions const& options,
                               std::string name);

 private:
  using Key = std::pair<std::filesystem::path, bool>;  // and whether a material replaces the model's own
  struct Entry {
    std::vector<std::pair<std::filesystem::path, std::optional<FileStamp>>> files;
    std::vector<std::shared_ptr<Shape const>> roots;
    Vec3 origin{0};  // that their coordinates lack
    std::size_t last_script = 0;

    bool is_up_to_date() const;
  };

  std::mutex mutex_;
  std::map<Key, Entry> entries_;
  std::size_t script_ = 0;
};

}  // namespace lichtraum
