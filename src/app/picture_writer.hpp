#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/render_statistics.hpp"
#include "app/video.hpp"

namespace lichtraum::app {

/// What the file of a picture is made of: the planes as they were traced, for formats that have encode_film; else
/// something to look at.
using Drawn = std::variant<Film, Image>;

/// Removes what an interruption left of a picture that is whole now. A whole picture of that name stays, as far as its
/// format tells.
void remove_partial(Output const& output);

/// Puts pictures where their plans say: files, standard output, or one film.
class PictureWriter {
 public:
  explicit PictureWriter(double frames_per_second) : frames_per_second_(frames_per_second) {}

  /// Fills in the report's `written_to` and `write_ms`. A picture that is not complete goes to a file beside; it is
  /// left out of films and standard output. Throws Error{cannot_create}, Error{io}, and what Video throws.
  void write(Drawn const& drawn, PictureReport& picture);

  struct FilmReport {
    std::string path;
    int frame_count = 0;
    Resolution size;
  };
  /// Ends the film, if one was begun. One that is not complete is called film.partial.mp4.
  std::optional<FilmReport> finish_film(bool is_complete);

 private:
  void add_to_film(Image const& image, PictureReport const& picture);

  double frames_per_second_;
  Output film_output_;
  std::optional<Video> film_;
};

}  // namespace lichtraum::app
