#include "lichtraum/exr_layers.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <fmt/format.h>
#include <half.h>

#include <cstring>
#include <map>
#include <stdexcept>

#include "core/memory.hpp"
#include "io/file_signature.hpp"
#include "io/image/check_exr.hpp"
#include "io/image/exr_streams.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

std::size_t bytes_of(Imf::PixelType type) { return type == Imf::HALF ? 2 : 4; }

/// A value of the file, as a float.
float read_value(char const* bytes, Imf::PixelType type) {
  if (type == Imf::HALF) {
    half value;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
  }
  if (type == Imf::UINT) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes, sizeof(value));
    return float(value);
  }
  float value = 0;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

}  // namespace

struct ExrLayers::Contents {
  struct Channel {
    Imf::PixelType type;
    std::vector<char> bytes;  // height x width values
  };
  Imf::Header header;
  Resolution size;
  std::map<std::string, Channel> channels;

  Channel const& channel(std::string_view name) const {
    auto const found = channels.find(std::string(name));
    if (found == channels.end()) throw std::invalid_argument(fmt::format("there is no channel '{}'", name));
    return found->second;
  }

  Imf::FrameBuffer frame() {
    Imf::FrameBuffer frame;
    for (auto& [name, channel] : channels) {
      std::size_t const bytes = bytes_of(channel.type);
      frame.insert(name, Imf::Slice::Make(channel.type, channel.bytes.data(), header.dataWindow(), bytes,
                                          bytes * std::size_t(size.width)));
    }
    return frame;
  }

  /// Makes room for what the header says there is.
  void allocate(std::string const& name) {
    auto const& window = header.dataWindow();
    double const width = double(window.max.x) - window.min.x + 1, height = double(window.max.y) - window.min.y + 1;
    double pixel_bytes = 0;
    auto const& list = header.channels();
    for (auto it = list.begin(); it != list.end(); ++it) {
      Imf::Channel const& channel = it.channel();
      if (channel.xSampling != 1 || channel.ySampling != 1) {
        throw Error(ErrorKind::scene, fmt::format("'{}': the channel '{}' is of another size than the picture: it has "
                                                  "a value for each {}x{} pixels",
                                                  name, it.name(), channel.xSampling, channel.ySampling));
      }
      pixel_bytes += double(bytes_of(channel.type));
    }
    double const available = double(usable_memory_bytes());
    if (2 * pixel_bytes * width * height > available) {
      throw Error(ErrorKind::scene,
                  fmt::format("'{}': its {:.0f}x{:.0f} pixels do not fit into memory", name, width, height));
    }
    size = {int(width), int(height)};
    for (auto it = list.begin(); it != list.end(); ++it) {
      Imf::PixelType const type = it.channel().type;
      channels.emplace(it.name(), Channel{type, std::vector<char>(bytes_of(type) * std::size_t(size.width) *
                                                                  std::size_t(size.height))});
    }
  }
};

ExrLayers::ExrLayers(std::string const& bytes, std::string const& name) : contents_(std::make_unique<Contents>()) {
  try {
    check_exr_header(bytes, bytes.size());
    StringInput counted(bytes, name);
    int const parts = Imf::MultiPartInputFile(counted, 0).parts();
    if (parts != 1) {
      throw Error(ErrorKind::scene, fmt::format("'{}' has {} parts: layers are read from a file of one", name, parts));
    }
    StringInput input(bytes, name);
    Imf::InputFile file(input, 0);
    contents_->header = file.header();
    contents_->allocate(name);
    file.setFrameBuffer(contents_->frame());
    auto const& window = file.header().dataWindow();
    file.readPixels(window.min.y, window.max.y);
  } catch (Error const&) {
    throw;
  } catch (std::exception const& error) {
    if (auto const other = recognise_signature(bytes)) {
      throw Error(ErrorKind::scene, fmt::format("'{}' is {}, not an OpenEXR file", name, other->what));
    }
    throw Error(ErrorKind::scene, fmt::format("'{}' cannot be read as an OpenEXR file: {}", name, error.what()));
  }
}

ExrLayers::~ExrLayers() = default;
ExrLayers::ExrLayers(ExrLayers&&) noexcept = default;
ExrLayers& ExrLayers::operator=(ExrLayers&&) noexcept = default;

Resolution ExrLayers::size() const { return contents_->size; }

std::vector<std::string> ExrLayers::channels() const {
  std::vector<std::string> names;
  for (auto const& [name, channel] : contents_->channels) names.push_back(name);
  return names;
}

bool ExrLayers::has(std::vector<std::string_view> const& channels) const {
  for (std::string_view const name : channels) {
    if (!contents_->channels.contains(std::string(name))) return false;
  }
  return true;
}

std::vector<float> ExrLayers::values(std::vector<std::string_view> const& channels) const {
  std::size_t const pixels = std::size_t(size().width) * std::size_t(size().height);
  std::vector<float> values(channels.size() * pixels);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    Contents::Channel const& channel = contents_->channel(channels[c]);
    for (std::size_t i = 0; i < pixels; ++i) {
      values[channels.size() * i + c] = read_value(&channel.bytes[i * bytes_of(channel.type)], channel.type);
    }
  }
  return values;
}

void ExrLayers::set_values(std::vector<std::string_view> const& channels, std::vector<float> const& values) {
  std::size_t const pixels = std::size_t(size().width) * std::size_t(size().height);
  if (values.size() != channels.size() * pixels) {
    throw std::invalid_argument("layers need a number for each channel of each pixel");
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    Contents::Channel channel{Imf::FLOAT, std::vector<char>(sizeof(float) * pixels)};
    for (std::size_t i = 0; i < pixels; ++i) {
      std::memcpy(&channel.bytes[sizeof(float) * i], &values[channels.size() * i + c], sizeof(float));
    }
    std::string const name(channels[c]);
    contents_->header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    contents_->channels[name] = std::move(channel);
  }
}

std::string ExrLayers::encode() const {
  try {
    Imf::Header header;
    for (auto it = contents_->header.begin(); it != contents_->header.end(); ++it) {
      std::string_view const name = it.name();
      if (name != exr_fingerprint_key && name != "tiles") header.insert(it.name(), it.attribute());
    }
    if (header.hasType()) header.setType(Imf::SCANLINEIMAGE);
    header.lineOrder() = Imf::INCREASING_Y;
    header.compression() = Imf::ZIP_COMPRESSION;  // without loss, whatever it was before
    StringOutput output;
    {
      Imf::OutputFile file(output, header, 0);
      file.setFrameBuffer(contents_->frame());
      file.writePixels(size().height);
    }
    return output.take();
  } catch (std::exception const& error) {
    throw Error(ErrorKind::internal, std::string("OpenEXR: ") + error.what());
  }
}

}  // namespace lichtraum
