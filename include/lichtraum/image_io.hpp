#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/film.hpp"
#include "lichtraum/image.hpp"

namespace LICHTRAUM_API lichtraum {

/// How values are stored in a picture's file.
struct ValueEncoding {
  int bits = 8;            ///< per channel; 8 or 16 (16: PNG and PPM only)
  bool ppm_ascii = false;  ///< PPM as text (P3)
  int jpeg_quality = 92;   ///< 1..100
  friend bool operator==(ValueEncoding const&, ValueEncoding const&) = default;
};

struct ImageEncoding : ValueEncoding {
  /// Stored beside the picture where the format has room for it: PNG in a tEXt chunk "lichtraum fingerprint", OpenEXR
  /// in a string attribute "lichtraumFingerprint". Empty: nothing is.
  std::string fingerprint;
};

/// Where an encoder writes to.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Where the last write ended, or the last seek asked for; at first at the beginning.
  virtual void write(std::string_view bytes) = 0;
  /// May go back, or beyond the end.
  virtual void seek(std::uint64_t position) = 0;
};

/// Makes a picture's file of some rows at a time, from the top.
template <class Picture>
class RowEncoder {
 public:
  virtual ~RowEncoder() = default;
  /// The next rows, as wide as the picture, and with all that it has of each pixel.
  virtual void add(Picture const& rows) = 0;
  /// After the last row. What was written is no file of the format before.
  virtual void finish() = 0;
};

/// One row of the table of picture formats.
struct ImageFormat {
  std::string_view name;                     ///< "png"
  std::vector<std::string_view> extensions;  ///< lower case with the dot: {".jpg", ".jpeg"}
  int max_bits;                              ///< per channel
  int max_side;                              ///< pixels
  bool has_alpha;
  /// The file's bytes. Null for formats that store films. Throws std::invalid_argument for an image of no pixels, of
  /// more than max_side, or without all of its values, and for an encoding that the format does not have.
  std::string (*encode)(Image const& image, ImageEncoding const& encoding);
  /// For formats that store the planes of a film as they are, at most max_planes of them: exposure, tone map and
  /// transfer do not apply. Null for the others. Throws std::invalid_argument for a film of no pixels or without
  /// planes, and for planes of the first sample in a film of later ones.
  std::string (*encode_film)(Film const& film, ImageEncoding const& encoding);
  std::size_t max_planes;
  /// The same files by and by, for pictures that memory cannot hold. Null where the format or its library takes whole
  /// pictures only. `sink` must outlive the encoder.
  std::unique_ptr<RowEncoder<Image>> (*begin)(Resolution const& size, bool has_alpha, ImageEncoding const& encoding,
                                              ByteSink& sink);
  std::unique_ptr<RowEncoder<Film>> (*begin_film)(Resolution const& size, PlaneSet const& planes,
                                                  ImageEncoding const& encoding, ByteSink& sink);
  /// The fingerprint in a whole picture; empty when there is none, or the file is of another format, or truncated, or
  /// (PNG) has other bytes than were written to it. Null for formats without.
  std::string (*read_fingerprint)(std::filesystem::path const& path);
};

/// Every format that can be written.
std::span<ImageFormat const> image_formats();

/// By extension (any case); null when there is none or it is unknown.
ImageFormat const* find_image_format(std::filesystem::path const& path);
/// The same. Throws Error{usage} that lists the known ones.
ImageFormat const& image_format_for(std::filesystem::path const& path);
/// By name. Throws Error{usage} that lists the known ones.
ImageFormat const& image_format_named(std::string_view name);

/// Throws Error{cannot_create} that says why when `path` could not be written: its folder is missing or read-only, or
/// it is a folder itself. Leaves nothing behind.
void check_writable(std::filesystem::path const& path);

/// Writes `bytes` to a temporary file beside `path` and renames it: `path` is the old file or the whole new one. When
/// `path` exists and is not a regular file (/dev/stdout, a pipe) it is written directly.
/// Throws Error{cannot_create} or Error{io} and leaves the old file as it was.
void write_file_atomically(std::filesystem::path const& path, std::string_view bytes);

class TemporaryFile;

/// The same of a file that is written by and by; not for streams. Removed again unless it is finished.
class NewFile final : public ByteSink {
 public:
  /// Throws Error{cannot_create}.
  explicit NewFile(std::filesystem::path path);
  ~NewFile() override;
  NewFile(NewFile const&) = delete;
  NewFile& operator=(NewFile const&) = delete;

  /// Both throw Error{io}.
  void write(std::string_view bytes) override;
  void seek(std::uint64_t position) override;
  /// Takes the place of `path`, or of another in the same folder. Throws Error{io}, also when a write had failed.
  void finish() { finish_as(path_); }
  void finish_as(std::filesystem::path const& path);

  /// What it is called until then.
  std::filesystem::path const& unfinished_path() const;

 private:
  void note(int code);

  std::filesystem::path path_;
  std::unique_ptr<TemporaryFile> temporary_;
  int code_ = 0;  // of what failed first
};

}  // namespace lichtraum
