#include "texture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/read_file.hpp"
#include "io/image/decode.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::python {
namespace {

TextureWrap wrap_named(std::string const& name) {
  if (name == "repeat") return TextureWrap::repeat;
  if (name == "mirror") return TextureWrap::mirrored_repeat;
  if (name == "clamp") return TextureWrap::clamp_to_edge;
  throw Error(ErrorKind::usage, fmt::format("wrap: expected 'repeat', 'mirror' or 'clamp', not '{}'", name));
}

TextureFilter filter_named(std::string const& name) {
  if (name == "linear") return TextureFilter::linear;
  if (name == "nearest") return TextureFilter::nearest;
  throw Error(ErrorKind::usage, fmt::format("filter: expected 'linear' or 'nearest', not '{}'", name));
}

MadeTexture texture_of(TextureImage image, std::string const& wrap, std::string const& filter) {
  bool has_alpha = false;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) has_alpha |= image.rgba[i] < 255;
  TextureWrap const both = wrap_named(wrap);
  return {std::make_shared<Texture const>(
              Texture{std::make_shared<TextureImage const>(std::move(image)), both, both, filter_named(filter)}),
          has_alpha,
          {}};
}

}  // namespace

MadeTexture make_texture(std::uint8_t const* rgba, int width, int height, std::string const& wrap,
                         std::string const& filter) {
  std::size_t const size = std::size_t(width) * std::size_t(height) * 4;
  return texture_of({"", width, height, {rgba, rgba + size}}, wrap, filter);
}

MadeTexture read_texture(std::string const& path, std::string const& wrap, std::string const& filter) {
  std::string reason;
  auto image = decode_image(read_file(path), ModelOptions().max_texture, TexelContent::color, reason);
  if (!image) throw Error(ErrorKind::no_input, fmt::format("cannot read '{}' as a picture: {}", path, reason));
  image->name = path;
  MadeTexture made = texture_of(std::move(*image), wrap, filter);
  made.files.add(path);
  return made;
}

}  // namespace lichtraum::python
