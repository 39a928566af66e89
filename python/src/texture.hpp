#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lichtraum/pbr_model.hpp"
#include "source_files.hpp"

namespace lichtraum::python {

/// A picture for materials that are made in Python.
struct MadeTexture {
  std::shared_ptr<Texture const> texture;
  bool has_alpha = false;  ///< some of it is not opaque
  SourceFiles files;       ///< that it was read from
};

/// `wrap`: "repeat", "mirror" or "clamp"; `filter`: "linear" or "nearest". Throws Error{usage} for others.
/// `rgba`: height x width x 4, first row at the top.
MadeTexture make_texture(std::uint8_t const* rgba, int width, int height, std::string const& wrap,
                         std::string const& filter);
/// Of a PNG, JPEG, WebP, BMP or TGA file. What cannot be read is an Error{no_input} or Error{io}.
MadeTexture read_texture(std::string const& path, std::string const& wrap, std::string const& filter);

}  // namespace lichtraum::python
