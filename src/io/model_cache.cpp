#include "io/model_cache.hpp"

#include <algorithm>

#include "scene/copy_graph.hpp"

namespace lichtraum {

std::shared_ptr<ModelCache> make_model_cache() { return std::make_shared<ModelCache>(); }

bool ModelCache::Entry::is_up_to_date() const {
  return !roots.empty() &&
         std::all_of(files.begin(), files.end(), [](auto const& file) { return stamp_of(file.first) == file.second; });
}

void ModelCache::begin_script() {
  std::lock_guard const lock(mutex_);
  std::erase_if(entries_, [&](auto const& entry) { return entry.second.last_script < script_; });
  ++script_;
}

std::shared_ptr<Shape> ModelCache::shape(MeshFormat const& format, std::filesystem::path const& path,
                                         ModelOptions const& options, std::string name) {
  std::lock_guard const lock(mutex_);
  Entry& entry = entries_[{path, options.material != nullptr}];
  entry.last_script = script_;
  if (entry.is_up_to_date()) {
    for (auto const& [file, stamp] : entry.files) {
      if (options.on_read) options.on_read(file);
    }
  } else {
    entry = {};
    entry.last_script = script_;
    ModelOptions observed = options;
    observed.on_read = [&](std::filesystem::path const& file) {
      if (options.on_read) options.on_read(file);
      entry.files.emplace_back(file, stamp_of(file));
    };
    Model const model = format.import(path, observed);
    entry.roots = model.scene.roots();
    entry.origin = model.origin;
  }
  auto const material_of = [&](Shape const& shape) { return options.material ? options.material : shape.material(); };
  auto model = std::make_shared<Composite>(std::move(name), copy_graph(entry.roots, material_of));
  if (entry.origin != Vec3(0)) model->translate(entry.origin);
  model->set_moves_as_one(true);  // a scene has no names for the model's parts
  return model;
}

}  // namespace lichtraum
