#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cstring>
#include <list>

#include "io/image/encoders.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

/// A file in memory. OpenEXR goes back to fill in its table of line offsets.
class StringStream final : public Imf::OStream {
 public:
  StringStream() : OStream("picture.exr") {}

  void write(char const data[], int size) override {
    auto const end = position_ + std::size_t(size);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, data, std::size_t(size));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

constexpr char const* fingerprint_key = "lichtraumFingerprint";

}  // namespace

std::string read_exr_fingerprint(std::filesystem::path const& path) {
  try {
    Imf::InputFile file(path.c_str(), 1);
    auto const* const fingerprint = file.header().findTypedAttribute<Imf::StringAttribute>(fingerprint_key);
    if (!fingerprint || !file.isComplete()) return {};
    // What is cut off at its end lacks the last lines, and throws here.
    char const* lines = nullptr;
    int size = 0;
    file.rawPixelData(file.header().dataWindow().max.y, lines, size);
    return fingerprint->value();
  } catch (std::exception const&) {  // no OpenEXR file
    return {};
  }
}

std::string encode_exr(Film const& film, ImageEncoding const& encoding) {
  StringStream stream;
  try {
    auto const [width, height] = film.size();
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;
    if (!encoding.fingerprint.empty()) {
      header.insert(fingerprint_key, Imf::StringAttribute(encoding.fingerprint));
    }
    Imf::FrameBuffer frame;
    std::list<std::vector<float>> kept;
    for (FilmPlane const plane : film.planes().list()) {
      PlaneInfo const& info = info_of(plane);
      Imf::PixelType const type = info.is_number ? Imf::UINT : Imf::FLOAT;
      void const* const values = info.is_number ? static_cast<void const*>(film.numbers(plane).data())
                                                : kept.emplace_back(film.values(plane)).data();
      for (std::size_t c = 0; c < info.channels.size(); ++c) {
        std::string const name(info.channels[c]);
        std::size_t const pixel_bytes = 4 * info.channels.size();
        header.channels().insert(name, Imf::Channel(type));
        char* const base = static_cast<char*>(const_cast<void*>(values)) + 4 * c;  // only read from
        frame.insert(name, Imf::Slice(type, base, pixel_bytes, pixel_bytes * std::size_t(width)));
      }
    }
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  } catch (std::exception const& error) {
    throw Error(ErrorKind::internal, std::string("OpenEXR: ") + error.what());
  }
  return stream.take();
}

}  // namespace lichtraum
