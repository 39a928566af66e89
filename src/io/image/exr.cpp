#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <fstream>
#include <list>
#include <optional>

#include "io/image/check_exr.hpp"
#include "io/image/encoders.hpp"
#include "io/image/exr_streams.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

std::string read_exr_fingerprint(std::filesystem::path const& path) {
  try {
    std::string beginning(1 << 16, '\0');  // our own headers are shorter
    std::ifstream stream(path, std::ios::binary);
    stream.read(beginning.data(), std::streamsize(beginning.size()));
    beginning.resize(std::size_t(stream.gcount()));
    check_exr_header(beginning, std::filesystem::file_size(path));
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

namespace {

/// OpenEXR goes back to fill in its table of line offsets.
class SinkStream final : public Imf::OStream {
 public:
  explicit SinkStream(ByteSink& sink) : OStream("picture.exr"), sink_(sink) {}

  void write(char const data[], int size) override {
    sink_.write({data, std::size_t(size)});
    position_ += std::uint64_t(size);
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override {
    sink_.seek(position);
    position_ = position;
  }

 private:
  ByteSink& sink_;
  std::uint64_t position_ = 0;
};

[[noreturn]] void fail(std::exception const& error) {
  throw Error(ErrorKind::internal, std::string("OpenEXR: ") + error.what());
}

class ExrRows final : public RowEncoder<Film> {
 public:
  ExrRows(Resolution const& size, PlaneSet const& planes, ImageEncoding const& encoding, ByteSink& sink)
      : stream_(sink) {
    Imf::Header header(size.width, size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;
    if (!encoding.fingerprint.empty()) {
      header.insert(exr_fingerprint_key, Imf::StringAttribute(encoding.fingerprint));
    }
    for (FilmPlane const plane : planes.list()) {
      for (std::string_view const name : info_of(plane).channels) {
        header.channels().insert(std::string(name), Imf::Channel(type_of(plane)));
      }
    }
    try {
      file_.emplace(stream_, header, 0);
    } catch (Error const&) {
      throw;
    } catch (std::exception const& error) {
      fail(error);
    }
  }

  void add(Film const& rows) override {
    try {
      Imf::FrameBuffer frame;
      std::list<std::vector<float>> kept;
      for (FilmPlane const plane : rows.planes().list()) {
        PlaneInfo const& info = info_of(plane);
        void const* const values = info.is_number ? static_cast<void const*>(rows.numbers(plane).data())
                                                  : kept.emplace_back(rows.values(plane)).data();
        std::size_t const pixel_bytes = 4 * info.channels.size();
        std::size_t const row_bytes = pixel_bytes * std::size_t(rows.size().width);
        for (std::size_t c = 0; c < info.channels.size(); ++c) {
          // Only read from; the library counts from the picture's first row.
          char* const base = static_cast<char*>(const_cast<void*>(values)) + 4 * c - row_bytes * std::size_t(next_row_);
          frame.insert(std::string(info.channels[c]), Imf::Slice(type_of(plane), base, pixel_bytes, row_bytes));
        }
      }
      file_->setFrameBuffer(frame);
      file_->writePixels(rows.size().height);
      next_row_ += rows.size().height;
    } catch (Error const&) {
      throw;
    } catch (std::exception const& error) {
      fail(error);
    }
  }

  /// It writes its table of lines at the end of its life.
  void finish() override { file_.reset(); }

 private:
  static Imf::PixelType type_of(FilmPlane plane) { return info_of(plane).is_number ? Imf::UINT : Imf::FLOAT; }

  SinkStream stream_;
  std::optional<Imf::OutputFile> file_;
  int next_row_ = 0;
};

}  // namespace

std::unique_ptr<RowEncoder<Film>> begin_exr(Resolution const& size, PlaneSet const& planes,
                                            ImageEncoding const& encoding, ByteSink& sink) {
  return std::make_unique<ExrRows>(size, planes, encoding, sink);
}

std::string encode_exr(Film const& film, ImageEncoding const& encoding) {
  check_encodable(film, "exr");
  MemorySink sink;
  ExrRows rows(film.size(), film.planes(), encoding, sink);
  rows.add(film);
  rows.finish();
  return sink.take();
}

}  // namespace lichtraum
