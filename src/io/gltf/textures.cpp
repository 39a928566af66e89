#include "io/gltf/textures.hpp"

#include <fmt/format.h>

#include "io/gltf/uri.hpp"
#include "io/gltf/values.hpp"
#include "io/image/decode_all.hpp"

namespace lichtraum::gltf {
namespace {

/// EXT_texture_webp and KHR_texture_basisu name a picture that is to be preferred; the plain one is the fallback. What
/// only the extension names is used all the same.
int image_of(tinygltf::Texture const& texture, std::size_t image_count) {
  if (auto const* webp = find_extension(texture.extensions, "EXT_texture_webp")) {
    if (auto const source = index_of(*webp, "source", image_count)) return *source;
  }
  if (texture.source >= 0) return texture.source;
  if (auto const* basisu = find_extension(texture.extensions, "KHR_texture_basisu")) {
    if (auto const source = index_of(*basisu, "source", image_count)) return *source;
  }
  return -1;
}

void fetch(Document const& document, int index, Buffers& buffers, ImageJob& job) {
  ImageSource const& source = document.images[std::size_t(index)];
  if (source.buffer_view >= 0) {
    auto const bytes = buffers.view(source.buffer_view);
    if (bytes) job.bytes = *bytes;
    if (!bytes) job.reason = fmt::format("nothing could be read from buffer view {}", source.buffer_view);
    return;
  }
  if (!source.uri) {
    job.reason = "it has neither uri nor bufferView";
    return;
  }
  if (!is_data_uri(*source.uri)) {
    job.owned = buffers.file(*source.uri, job.reason);
  } else if (auto decoded = decode_data_uri(*source.uri)) {
    job.owned = std::make_shared<std::string const>(std::move(*decoded));
  } else {
    job.reason = "the data URI is malformed";
  }
  if (job.owned) job.bytes = *job.owned;
}

TextureWrap wrap(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp_to_edge;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirrored_repeat : TextureWrap::repeat;
}

}  // namespace

std::vector<std::shared_ptr<Texture const>> read_textures(Document const& document,
                                                          std::vector<std::optional<TexelContent>> const& used,
                                                          int max_size, Buffers& buffers, Findings& findings) {
  auto const& model = document.model;
  std::vector<ImageJob> jobs(document.images.size());
  for (std::size_t i = 0; i < model.textures.size(); ++i) {
    int const image = image_of(model.textures[i], jobs.size());
    if (!used[i] || image < 0) continue;
    jobs[std::size_t(image)].is_wanted = true;
    if (used[i] == TexelContent::color) jobs[std::size_t(image)].content = TexelContent::color;
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].name = document.images[i].name;
    if (jobs[i].is_wanted) fetch(document, int(i), buffers, jobs[i]);
  }
  std::string const halved = decode_images(jobs, max_size);
  if (!halved.empty()) findings.warn(DiagnosticCode::textures_halved, "/images", halved);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!jobs[i].reason.empty()) {
      findings.warn(DiagnosticCode::texture_left_out, fmt::format("/images/{}", i),
                    fmt::format("the picture is left out: {}", jobs[i].reason));
    }
  }

  std::vector<std::shared_ptr<Texture const>> textures(model.textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    int const image = image_of(model.textures[i], jobs.size());
    if (!used[i] || image < 0 || !jobs[std::size_t(image)].image) continue;
    Texture texture{jobs[std::size_t(image)].image};
    int const sampler = model.textures[i].sampler;
    if (sampler >= 0) {
      auto const& source = model.samplers[std::size_t(sampler)];
      texture.wrap_s = wrap(source.wrapS);
      texture.wrap_t = wrap(source.wrapT);
      if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.filter = TextureFilter::nearest;
    }
    textures[i] = std::make_shared<Texture>(std::move(texture));
  }
  return textures;
}

}  // namespace lichtraum::gltf
