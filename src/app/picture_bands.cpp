#include "app/picture_bands.hpp"

#include <algorithm>

namespace lichtraum::app {
namespace {

namespace fs = std::filesystem;

/// Larger pictures are drawn in bands: an 8K one takes 0.4 GB in the whole.
constexpr std::int64_t most_pixels_at_once = std::int64_t(1) << 24;
constexpr std::int64_t band_pixels = std::int64_t(1) << 22;
/// Days of work, more likely a slip: refused, as for a whole picture there is no memory.
constexpr std::int64_t most_pixels = std::int64_t(1) << 32;

bool can_be_cut(PicturePlan const& plan, bool is_denoised) {
  Output const& output = plan.output;
  if (is_denoised || plan.job.noise || output.is_film || output.is_standard_output()) return false;
  std::error_code is_missing;
  auto const status = fs::status(output.path, is_missing);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;  // no going back in a pipe
  // Other planes are shown from their least value to their largest.
  return output.format->begin_film || (output.format->begin && plan.job.planes.has(FilmPlane::radiance));
}

}  // namespace

std::vector<Region> bands_of(PicturePlan const& plan, bool is_denoised) {
  Region const& whole = *plan.job.region;
  std::int64_t const pixels = std::int64_t(whole.width) * whole.height;
  if (pixels <= most_pixels_at_once || pixels > most_pixels || !can_be_cut(plan, is_denoised)) return {whole};
  int const height = int(std::max<std::int64_t>(1, band_pixels / whole.width));
  std::vector<Region> bands;
  for (int y = 0; y < whole.height; y += height) {
    bands.push_back({whole.x, whole.y + y, whole.width, std::min(height, whole.height - y)});
  }
  return bands;
}

BandWriter::BandWriter(PicturePlan const& plan, PlaneSet const& planes) : file_(plan.output.path) {
  removed_on_signal_.emplace(std::nullopt, file_.unfinished_path());
  ImageFormat const& format = *plan.output.format;
  ImageEncoding const encoding{plan.job.encoding, plan.fingerprint};
  Resolution const size{plan.job.region->width, plan.job.region->height};
  if (format.begin_film) {
    encoder_ = format.begin_film(size, planes, encoding, file_);
  } else {
    encoder_ = format.begin(size, planes.has(FilmPlane::alpha), encoding, file_);
  }
}

void BandWriter::add(Drawn const& band) {
  if (auto const* const film = std::get_if<Film>(&band)) {
    std::get<std::unique_ptr<RowEncoder<Film>>>(encoder_)->add(*film);
  } else {
    std::get<std::unique_ptr<RowEncoder<Image>>>(encoder_)->add(std::get<Image>(band));
  }
}

void BandWriter::finish() {
  std::visit([](auto& encoder) { encoder->finish(); }, encoder_);
  file_.finish();
}

}  // namespace lichtraum::app
