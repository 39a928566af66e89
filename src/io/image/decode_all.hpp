#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

/// A picture on its way: where its bytes are, and what became of them.
struct ImageJob {
  std::string name;  ///< for people
  bool is_wanted = false;
  std::string owned;                          ///< when nobody else keeps `bytes`; freed after decoding
  std::string_view bytes;                     ///< of a PNG, JPEG or WebP
  std::shared_ptr<TextureImage const> image;  ///< the result
  std::string reason;                         ///< or why there is none; a job that has one already is left alone
};

/// Decodes what is wanted, on all cores, see decode_image. All of it together may take half a gigabyte.
void decode_images(std::span<ImageJob> jobs, int max_size);

}  // namespace lichtraum
