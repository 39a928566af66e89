#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "core/printable.hpp"
#include "io/image/check_exr.hpp"
#include "io/image/environment_decoders.hpp"
#include "io/image/exr_streams.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

/// The channels of red, green and blue.
std::array<char const*, 3> channels_of(EnvironmentFile const& file, Imf::ChannelList const& list) {
  if (list.findChannel("R") && list.findChannel("G") && list.findChannel("B")) return {"R", "G", "B"};
  if (list.findChannel("Y") && !list.findChannel("RY")) return {"Y", "Y", "Y"};
  std::string names;
  for (auto channel = list.begin(); channel != list.end() && names.size() < 200; ++channel) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", printable(channel.name()));
  }
  file.fail(fmt::format("an environment has the channels R, G and B, or Y alone; this file has {}", names));
}

EnvironmentMap decode(EnvironmentFile const& file) {
  check_exr_header(file.bytes, file.bytes.size());
  StringInput stream(file.bytes, file.name);
  Imf::InputFile input(stream, 0);
  Imf::Header const& header = input.header();
  auto const window = header.dataWindow();
  EnvironmentMap map =
      file.sized(std::int64_t(window.max.x) - window.min.x + 1, std::int64_t(window.max.y) - window.min.y + 1);
  if (window != header.displayWindow()) file.fail("only a part of the picture is stored. Save it whole");
  auto const names = channels_of(file, header.channels());
  if (!input.isComplete()) file.fail("rows of pixels are missing: it has been cut short, or was never finished");
  auto const width = std::size_t(map.width), height = std::size_t(map.height);
  map.radiance.resize(3 * width * height);
  Imf::FrameBuffer frame;
  std::size_t const pixel_bytes = 3 * sizeof(float);
  for (std::size_t c = 0; c < 3; ++c) {
    frame.insert(names[c],
                 Imf::Slice::Make(Imf::FLOAT, map.radiance.data() + c, window, pixel_bytes, pixel_bytes * width));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  if (std::strcmp(names[0], "Y") == 0) {  // a frame has each channel once, so it is the last that was read
    for (std::size_t i = 0; i < map.radiance.size(); ++i) map.radiance[i] = map.radiance[i - i % 3 + 2];
  }
  return map;
}

}  // namespace

EnvironmentMap decode_exr(EnvironmentFile const& file) {
  try {
    return decode(file);
  } catch (Error const&) {
    throw;
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& error) {
    file.fail(fmt::format("OpenEXR cannot read it: {}. It has been cut short or is damaged", printable(error.what())));
  }
}

}  // namespace lichtraum
