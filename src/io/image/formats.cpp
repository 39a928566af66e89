#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/ascii.hpp"
#include "io/image/encoders.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

std::string known_extensions() {
  std::string list;
  for (ImageFormat const& format : image_formats()) {
    for (std::string_view const extension : format.extensions)
      list += fmt::format("{}{}", list.empty() ? "" : ", ", extension);
  }
  return list;
}

std::string known_names() {
  std::string list;
  for (ImageFormat const& format : image_formats()) list += fmt::format("{}{}", list.empty() ? "" : ", ", format.name);
  return list;
}

}  // namespace

std::span<ImageFormat const> image_formats() {
  constexpr int any = std::numeric_limits<int>::max();
  static std::array<ImageFormat, 5> const formats{{
      {"png", {".png"}, 16, any, true, encode_png, nullptr, 1, begin_png, nullptr, read_png_fingerprint},
      {"ppm", {".ppm"}, 16, any, false, encode_ppm, nullptr, 1, begin_ppm, nullptr, nullptr},
      {"jpg", {".jpg", ".jpeg"}, 8, 65500, false, encode_jpeg, nullptr, 1, nullptr, nullptr, nullptr},
      {"exr", {".exr"}, 32, any, true, nullptr, encode_exr, plane_count, nullptr, begin_exr, read_exr_fingerprint},
      {"pfm", {".pfm"}, 32, any, false, nullptr, encode_pfm, 1, nullptr, begin_pfm, nullptr},
  }};
  return formats;
}

ImageFormat const* find_image_format(std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  for (ImageFormat const& format : image_formats()) {
    if (std::count(format.extensions.begin(), format.extensions.end(), extension) != 0) return &format;
  }
  return nullptr;
}

ImageFormat const& image_format_for(std::filesystem::path const& path) {
  if (ImageFormat const* const format = find_image_format(path)) return *format;
  std::string const extension = path.extension().string();
  throw Error(ErrorKind::usage, extension.empty()
                                    ? fmt::format("'{}' has no extension that names a picture format; known ones: {}",
                                                  path.string(), known_extensions())
                                    : fmt::format("no picture format has the extension '{}' ('{}'); known ones: {}",
                                                  extension, path.string(), known_extensions()));
}

ImageFormat const& image_format_named(std::string_view name) {
  for (ImageFormat const& format : image_formats()) {
    if (format.name == name) return format;
  }
  throw Error(ErrorKind::usage, fmt::format("no picture format is called '{}'; known ones: {}", name, known_names()));
}

}  // namespace lichtraum
