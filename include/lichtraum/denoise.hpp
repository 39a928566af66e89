#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/film.hpp"

namespace LICHTRAUM_API lichtraum {

/// Whether the noise of few samples is taken out of a picture before it is developed, and by what.
enum class Denoising {
  automatic,  ///< on where the integrator leaves noise
  on,         ///< by Open Image Denoise; by the built-in filter where that cannot be used
  off,
  builtin,  ///< by lichtraum's own filter: the same bytes on every machine
};

/// Filters compute with light up to this: its square is a float.
inline constexpr float largest_filtered_light = 1e18f;

/// What is known of a picture with noise: the means of its samples. All planes are height x width x channels, first row
/// at the top. Values that are not finite count as 0.
struct NoisyPicture {
  Resolution size;
  std::vector<float> radiance;    ///< linear red, green, blue, without a limit; never negative
  std::vector<float> albedo;      ///< of the first surface, linear red, green, blue, 0..1; empty: not known
  std::vector<float> normal;      ///< of the first surface, in the world, each coordinate -1..1; empty: not known
  std::vector<float> depth;       ///< of the first surface, infinity where nothing is; empty: not known
  bool has_noisy_guides = false;  ///< albedo and normals have noise too, as with depth of field
};

/// These planes, and those that denoising goes by where they have radiance: albedo and normals.
PlaneSet with_guides(PlaneSet planes);

/// What of a film has noise besides its radiance.
struct NoiseBesides {
  bool in_guides = false;  ///< see NoisyPicture::has_noisy_guides
  bool in_alpha = false;   ///< as with a ground's shadows
};

/// Of a film with radiance. Throws std::invalid_argument for one without, or without samples.
NoisyPicture noisy_picture(Film const& film);

/// The radiance without noise, height x width x 3: an edge-avoiding wavelet filter (docs/DENOISING.md). The same bytes
/// however many threads there are; Renderer::filter_noise gives them as well.
/// Throws std::invalid_argument for planes of another size than `size`.
std::vector<float> filter_noise(NoisyPicture const& picture);

/// Intel's Open Image Denoise 2, loaded while the program runs.
class OpenImageDenoise {
 public:
  /// The library that the environment variable LICHTRAUM_OIDN names (a file, or the folder it is in); without it the
  /// system's, else the one in ../lib/lichtraum/oidn/lib beside the program's folder (of a library: bin/lichtraum's).
  /// Throws Error{unavailable} that says why there is none.
  OpenImageDenoise();
  ~OpenImageDenoise();

  /// "Open Image Denoise 2.5.1".
  std::string const& name() const { return name_; }

  /// As lichtraum::filter_noise; the same for any number of threads on one machine. Throws Error{unavailable} with the
  /// library's message when it fails.
  std::vector<float> filter_noise(NoisyPicture const& picture) const;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::string name_;
};

/// Takes the noise out of pictures with what can be had. Any thread may ask for the name meanwhile.
class Denoiser {
 public:
  using Filter = std::function<std::vector<float>(NoisyPicture const&)>;
  /// `builtin`: lichtraum::filter_noise, or a renderer's.
  explicit Denoiser(Filter builtin);

  /// What takes the noise out of pictures that ask for `denoising` (not `automatic` or `off`), with its version. Until
  /// something fails, that stays the same.
  std::string name(Denoising denoising);

  /// Why the built-in filter is used instead of the other, for people; empty when it is not, or they were told.
  std::string take_note();

  /// The film's radiance without noise, as the one sample of a film that has alpha as well where `film` has it.
  /// Alpha with noise is treated the same, but where all samples have hit something.
  Film denoised(Film const& film, Denoising denoising, NoiseBesides const& besides = {});
  /// The same for any picture.
  std::vector<float> denoised(NoisyPicture const& picture, Denoising denoising);

 private:
  std::shared_ptr<OpenImageDenoise const> library();
  void give_up(std::string const& why);

  Filter builtin_;
  std::mutex mutex_;  // of what follows
  std::shared_ptr<OpenImageDenoise const> library_;
  bool has_looked_ = false;
  std::string note_;
};

}  // namespace lichtraum
