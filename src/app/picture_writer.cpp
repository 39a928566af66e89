#include "app/picture_writer.hpp"

#include "app/console.hpp"
#include "app/stopwatch.hpp"

namespace lichtraum::app {

namespace {

/// The fingerprint of pictures that are not whole.
constexpr std::string_view unfinished_mark = "unfinished";

std::string encode(Drawn const& drawn, ImageFormat const& format, ImageEncoding const& encoding) {
  Film const* const film = std::get_if<Film>(&drawn);
  return film ? format.encode_film(*film, encoding) : format.encode(std::get<Image>(drawn), encoding);
}

}  // namespace

void remove_partial(Output const& output) {
  if (output.is_standard_output()) return;
  std::error_code ignored;
  std::filesystem::path const partial = output.partial_path();
  if (!std::filesystem::is_regular_file(partial, ignored)) return;
  // Whatever else has that name is somebody's; of formats that say nothing of where a picture comes from, all is.
  auto const read_fingerprint = output.format->read_fingerprint;
  if (read_fingerprint && read_fingerprint(partial) == unfinished_mark) std::filesystem::remove(partial, ignored);
}

void PictureWriter::write(Drawn const& drawn, PictureReport& picture) {
  Stopwatch const stopwatch;
  Output const& output = picture.plan.output;
  bool const is_file = !output.is_standard_output() && !output.is_film;
  if (!picture.is_complete && !is_file) return;  // nobody could tell it from a whole one
  if (output.is_film) {
    add_to_film(std::get<Image>(drawn), picture);
    picture.written_to = output.shown;
    picture.write_ms = stopwatch.milliseconds();
    return;
  }
  std::string const fingerprint = picture.is_complete ? picture.plan.fingerprint : std::string(unfinished_mark);
  std::string const bytes = encode(drawn, *output.format, {picture.plan.job.encoding, fingerprint});
  if (output.is_standard_output()) {
    write_standard_output(bytes);
    picture.written_to = output.shown;
  } else if (picture.is_complete) {
    write_file_atomically(output.path, bytes);
    remove_partial(output);
    picture.written_to = output.shown;
  } else {
    Output shown = output;
    shown.path = output.shown;
    write_file_atomically(output.partial_path(), bytes);
    picture.written_to = shown.partial_path().string();
  }
  picture.write_ms = stopwatch.milliseconds();
}

void PictureWriter::add_to_film(Image const& image, PictureReport const& picture) {
  if (!film_) {
    film_output_ = picture.plan.output;
    film_.emplace(film_output_.path, image.size(), frames_per_second_);
  }
  // A PPM is a header and the pixels as ffmpeg wants them.
  std::string const bytes = picture.plan.output.format->encode(image, ImageEncoding());
  std::size_t const pixel_bytes = 3 * std::size_t(image.width()) * std::size_t(image.height());
  film_->add(std::string_view(bytes).substr(bytes.size() - pixel_bytes));
}

std::optional<PictureWriter::FilmReport> PictureWriter::finish_film(bool is_complete) {
  if (!film_ || film_->frame_count() == 0) return std::nullopt;
  FilmReport report{film_output_.shown, film_->frame_count(), film_->size()};
  if (is_complete) {
    film_->finish();
  } else {
    film_->finish_as(film_output_.partial_path());
    film_output_.path = film_output_.shown;
    report.path = film_output_.partial_path().string();
  }
  film_.reset();
  return report;
}

}  // namespace lichtraum::app
