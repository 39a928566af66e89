#include "app/environment_maps.hpp"

namespace lichtraum::app {

std::shared_ptr<EnvironmentMap const> EnvironmentMaps::find(std::string const& source, FileObserver const& on_read) {
  bool const is_file = source != "studio";
  if (is_file && on_read) on_read(source);
  std::lock_guard const lock(mutex_);
  auto const stamp = is_file ? stamp_of(source) : std::nullopt;
  if (!map_ || source != source_ || stamp != stamp_) {
    map_ = environment_map(source);
    source_ = source;
    stamp_ = stamp;
  }
  return map_;
}

}  // namespace lichtraum::app
