#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lichtraum/pbr_model.hpp"
#include "scene/texture_lookup.hpp"

namespace lichtraum {

/// A picture on its way: where its bytes are, and what became of them.
struct ImageJob {
  std::string name;  ///< for people
  bool is_wanted = false;
  TexelContent content = TexelContent::data;  ///< colours if it is used for both
  std::shared_ptr<std::string const> owned;   ///< what keeps `bytes`, if nobody else does; let go after decoding
  std::string_view bytes;                     ///< of a PNG, JPEG, WebP, BMP or TGA
  std::shared_ptr<TextureImage const> image;  ///< the result
  std::string reason;                         ///< or why there is none; a job that has one already is left alone
};

/// What the pictures of a model may take in memory: an eighth of the machine's, from 512 MiB, which all models can
/// count on everywhere, to 2 GiB.
std::uint64_t max_picture_bytes();

/// Decodes what is wanted, on all cores, see decode_image. Where all of it together would take more than `max_bytes`,
/// the largest pictures are halved until it does not. Returns what to tell people about that; empty: nothing.
[[nodiscard]] std::string decode_images(std::span<ImageJob> jobs, int max_size,
                                        std::uint64_t max_bytes = max_picture_bytes());

}  // namespace lichtraum
