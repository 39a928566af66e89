#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/interruption.hpp"
#include "core/descriptor.hpp"
#include "core/temporary_file.hpp"
#include "lichtraum/camera.hpp"

namespace lichtraum::app {

/// One row of the table of film formats.
struct FilmFormat {
  std::string_view extension;                  ///< lower case with the dot: ".mp4"
  std::string_view container;                  ///< ffmpeg's name for it
  bool needs_even_size;                        ///< colours are stored for 2 x 2 pixels
  double most_frames_per_second;               ///< beyond which players show it slower
  std::vector<std::string> encoder_arguments;  ///< for ffmpeg
};

std::span<FilmFormat const> film_formats();
/// By extension, in any case; null when it names no film.
FilmFormat const* find_film_format(std::filesystem::path const& path);

/// Throws Error{usage} for more pictures a second than a film of that name is shown with.
void check_frame_rate(std::filesystem::path const& film, double frames_per_second);

/// Before the first picture. Throws Error{usage} when the format cannot have that size, and Error{cannot_create} where
/// something is that is no file: ffmpeg goes back in what it writes.
void check_film(std::filesystem::path const& film, Resolution size);

/// A film being made by the ffmpeg program, which must be installed. It is written beside its target and renamed when
/// it is whole.
class Video {
 public:
  /// Throws Error{unavailable} when there is no ffmpeg, Error{usage} when the format cannot have that size or rate, and
  /// Error{cannot_create}.
  Video(std::filesystem::path path, Resolution size, double frames_per_second);
  /// Leaves nothing behind unless it was finished.
  ~Video();
  Video(Video const&) = delete;
  Video& operator=(Video const&) = delete;

  Resolution size() const { return size_; }
  int frame_count() const { return frame_count_; }

  /// The next picture: 8 bits a channel, RGB, first row at the top. Throws Error{io} with ffmpeg's last lines.
  void add(std::string_view pixels);

  /// Waits for ffmpeg and gives the film its name. Throws Error{io} with ffmpeg's last lines.
  void finish() { finish_as(path_); }
  void finish_as(std::filesystem::path const& path);

 private:
  [[noreturn]] void fail();
  int wait_for_ffmpeg();

  std::filesystem::path path_;
  Resolution size_;
  int frame_count_ = 0;
  int process_ = -1;
  std::optional<UnfinishedFile> removed_on_signal_;
  std::optional<TemporaryFile> unfinished_;
  Descriptor messages_;  // a file without a name that holds what ffmpeg said
  Descriptor pixels_;    // what ffmpeg reads
};

/// Throws Error{unavailable} that names the package when the ffmpeg program is not there.
void check_ffmpeg();

}  // namespace lichtraum::app
