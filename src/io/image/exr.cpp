#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <list>

#include "io/image/encoders.hpp"
#include "io/image/exr_streams.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

std::string read_exr_fingerprint(std::filesystem::path const& path) {
  try {
    Imf::InputFile file(path.c_str(), 1);
    auto const* const fingerprint = file.header().findTypedAttribute<Imf::StringAttribute>(exr_fingerprint_key);
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
  StringOutput stream;
  try {
    auto const [width, height] = film.size();
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;
    if (!encoding.fingerprint.empty()) {
      header.insert(exr_fingerprint_key, Imf::StringAttribute(encoding.fingerprint));
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
