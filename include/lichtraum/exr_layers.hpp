#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/camera.hpp"

namespace LICHTRAUM_API lichtraum {

/// All channels of an OpenEXR picture of one part, whoever wrote it, with its header.
class ExrLayers {
 public:
  /// `bytes` are the file's, `name` is what messages call it. Throws Error{scene} for what is no OpenEXR file, is cut
  /// short, has several parts, or channels of other sizes than the picture's; and where it does not fit into memory.
  ExrLayers(std::string const& bytes, std::string const& name);
  ~ExrLayers();
  ExrLayers(ExrLayers&&) noexcept;
  ExrLayers& operator=(ExrLayers&&) noexcept;

  Resolution size() const;
  /// In the order of the file: the alphabet's.
  std::vector<std::string> channels() const;
  bool has(std::vector<std::string_view> const& channels) const;

  /// height x width x channels, whatever numbers the file has. Throws std::invalid_argument for one that is not there.
  std::vector<float> values(std::vector<std::string_view> const& channels) const;
  /// Replaces channels, which become 32-bit floats. Throws std::invalid_argument for another number of values.
  void set_values(std::vector<std::string_view> const& channels, std::vector<float> const& values);

  /// A file with all channels and attributes; not the fingerprint, as it is another picture now.
  std::string encode() const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace lichtraum
