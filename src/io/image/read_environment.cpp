#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "core/printable.hpp"
#include "core/read_file.hpp"
#include "io/image/environment_decoders.hpp"
#include "lichtraum/error.hpp"
#include "scene/studio_environment.hpp"

namespace lichtraum {
namespace {

struct EnvironmentFormat {
  std::string_view first_bytes;
  EnvironmentMap (*decode)(EnvironmentFile const& file);
};

constexpr EnvironmentFormat formats[] = {
    {"#?", decode_hdr}, {"\x76\x2f\x31\x01", decode_exr}, {"PF", decode_pfm}, {"Pf", decode_pfm}};

/// Light that is no number, infinite or negative would spoil every pixel that it reaches. Resampling and sharpening
/// leave some of it in many a sky, and a sun too bright for half floats is infinite; where there is much, it is no
/// light.
void mend_values(EnvironmentFile const& file, EnvironmentMap& map) {
  std::size_t count = 0, first = 0;
  float largest = 0;
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    float const value = map.radiance[i];
    if (value >= 0 && std::isfinite(value)) {
      largest = std::max(largest, value);
    } else if (count++ == 0) {
      first = i;
    }
  }
  if (count == 0) return;
  std::size_t const pixel = first / 3;
  auto const width = std::size_t(map.width);
  char const* const channels[] = {"red", "green", "blue"};
  std::string const what = fmt::format(
      "{} of its {} values cannot be light, as they are negative, infinite or no numbers; the first is "
      "{} of {} in column {}, row {} (from 1, the top)",
      count, map.radiance.size(), map.radiance[first], channels[first % 3], pixel % width + 1, pixel / width + 1);
  constexpr std::size_t most_share = 100;  // one in so many
  if (most_share * count > map.radiance.size()) {
    file.fail(what + ". Replace them in a picture editor, and save the file again");
  }
  for (float& value : map.radiance) {
    if (!(value >= 0)) value = 0;
    if (std::isinf(value)) value = largest;
  }
  map.repairs =
      fmt::format("{}: {}; 0 stands for them, and the largest of the others for infinite ones", file.name, what);
}

}  // namespace

void EnvironmentFile::fail(std::size_t byte, std::string const& what) const {
  throw Error(ErrorKind::scene, fmt::format("{}: at byte {}: {}", name, byte, what));
}

void EnvironmentFile::fail(std::string const& what) const {
  throw Error(ErrorKind::scene, fmt::format("{}: {}", name, what));
}

EnvironmentMap EnvironmentFile::sized(std::int64_t width, std::int64_t height) const {
  if (width <= 0 || height <= 0) fail(fmt::format("it has {} x {} pixels, so no light", width, height));
  if (width > max_pixels / height) {
    fail(
        fmt::format("it has {} x {} pixels, and an environment can have {} (16384 x 8192) at most. Scale it down; "
                    "4096 x 2048 are sharper than most backgrounds need",
                    width, height, max_pixels));
  }
  return {int(width), int(height), {}};
}

EnvironmentMap decode_environment(EnvironmentFile const& file) {
  for (EnvironmentFormat const& format : formats) {
    if (!file.bytes.starts_with(format.first_bytes)) continue;
    try {
      EnvironmentMap map = format.decode(file);
      mend_values(file, map);
      return map;
    } catch (std::bad_alloc const&) {
      file.fail("the environment needs more memory than there is. Scale it down");
    }
  }
  file.fail(file.bytes.empty() ? "the file is empty; an environment is a Radiance (.hdr), OpenEXR (.exr) or PFM (.pfm) "
                                 "file"
                               : "it is not a Radiance (.hdr), OpenEXR (.exr) or PFM (.pfm) file, as environments "
                                 "must be: other pictures cannot hold bright light. 'convert sky.jpg sky.hdr' "
                                 "(ImageMagick) converts the picture, but cannot restore its bright light");
}

EnvironmentMap read_environment(std::filesystem::path const& path) {
  std::string const bytes = read_file(path);
  return decode_environment({bytes, printable(path.string())});
}

std::shared_ptr<EnvironmentMap const> uniform_environment(float red, float green, float blue) {
  return std::make_shared<EnvironmentMap>(EnvironmentMap{1, 1, {red, green, blue}});
}

std::shared_ptr<EnvironmentMap const> environment_map(std::string const& source) {
  return source == "studio" ? studio_environment() : std::make_shared<EnvironmentMap>(read_environment(source));
}

std::optional<EnvironmentLight> chosen_environment(
    EnvironmentChoice const& choice, std::optional<EnvironmentLight> own,
    std::function<std::shared_ptr<EnvironmentMap const>(std::string const&)> const& map) {
  if (choice.source == "none") return std::nullopt;
  if (!choice.source.empty()) own = EnvironmentLight{choice.source, map(choice.source)};
  if (own && choice.rotation_degrees) own->rotation_degrees = *choice.rotation_degrees;
  if (own && choice.brightness) own->brightness = *choice.brightness;
  return own;
}

}  // namespace lichtraum
