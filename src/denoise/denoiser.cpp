#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

#include "lichtraum/denoise.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

std::string note(std::string const& why) {
  return fmt::format("noise is filtered by lichtraum's own filter, as Open Image Denoise cannot be used: {}", why);
}

}  // namespace

PlaneSet with_guides(PlaneSet planes) {
  if (!planes.has(FilmPlane::radiance)) return planes;
  planes.add(FilmPlane::albedo);
  planes.add(FilmPlane::normal);
  return planes;
}

NoisyPicture noisy_picture(Film const& film) {
  if (!film.planes().has(FilmPlane::radiance) || film.is_empty()) {
    throw std::invalid_argument("only a film with samples of radiance can be denoised");
  }
  auto const values = [&](FilmPlane plane) {
    return film.planes().has(plane) ? film.values(plane) : std::vector<float>();
  };
  return {film.size(), values(FilmPlane::radiance), values(FilmPlane::albedo), values(FilmPlane::normal),
          values(FilmPlane::depth)};
}

Denoiser::Denoiser(Filter builtin) : builtin_(std::move(builtin)) {}

std::string Denoiser::name(Denoising denoising) {
  auto const library = denoising == Denoising::on ? this->library() : nullptr;
  return library ? library->name() : "the built-in filter";
}

std::string Denoiser::take_note() {
  std::unique_lock const lock(mutex_);
  return std::exchange(note_, {});
}

std::vector<float> Denoiser::denoised(NoisyPicture const& picture, Denoising denoising) {
  if (auto const library = denoising == Denoising::on ? this->library() : nullptr) {
    try {
      return library->filter_noise(picture);
    } catch (Error const& error) {
      give_up(error.what());
    } catch (std::bad_alloc const&) {
      give_up("there is not enough memory");
    }
  }
  return builtin_(picture);
}

Film Denoiser::denoised(Film const& film, Denoising denoising, NoiseBesides const& besides) {
  PlaneSet planes{FilmPlane::radiance};
  if (film.planes().has(FilmPlane::alpha)) planes.add(FilmPlane::alpha);
  Film result(film.region(), planes);
  NoisyPicture picture = noisy_picture(film);
  picture.has_noisy_guides = besides.in_guides;
  std::ranges::copy(denoised(picture, denoising), result.floats(FilmPlane::radiance).begin());
  if (planes.has(FilmPlane::alpha)) {
    std::vector<float> alpha = film.values(FilmPlane::alpha);
    if (besides.in_alpha) {
      for (std::size_t i = 0; i < picture.radiance.size(); ++i) picture.radiance[i] = std::max(alpha[i / 3], 0.0f);
      std::vector<float> const smooth = denoised(picture, denoising);
      for (std::size_t i = 0; i < alpha.size(); ++i) {
        if (alpha[i] != 1) alpha[i] = std::clamp(smooth[3 * i], 0.0f, 1.0f);
      }
    }
    std::ranges::copy(alpha, result.floats(FilmPlane::alpha).begin());
  }
  result.set_end(1);
  return result;
}

std::shared_ptr<OpenImageDenoise const> Denoiser::library() {
  std::unique_lock const lock(mutex_);
  if (!has_looked_) {
    has_looked_ = true;
    try {
      library_ = std::make_shared<OpenImageDenoise>();
    } catch (Error const& error) {
      note_ = note(error.what());
    }
  }
  return library_;
}

void Denoiser::give_up(std::string const& why) {
  std::unique_lock const lock(mutex_);
  if (library_) note_ = note(why);
  library_.reset();
}

}  // namespace lichtraum
