#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/camera.hpp"
#include "lichtraum/image.hpp"
#include "lichtraum/tone_map.hpp"

namespace LICHTRAUM_API lichtraum {

/// What a film can hold of each pixel. The order is that of the device's planes (kernels/shared/film.h).
enum class FilmPlane {
  radiance,  ///< linear red, green, blue
  alpha,     ///< share of the samples that hit something, 0..1; with it, radiance leaves out the background that the
             ///< camera sees. With a ground, also how much the scene darkens it, minus how much it brightens it
  albedo,    ///< how much of white light the first surface reflects and lets through, and (path) what it emits, or
             ///< where there is none, what the picture shows of the background; linear, 0..1
  normal,    ///< x, y, z in the world, as shaded (smooth, bumpy): on the camera's side, but where whitted shades bumps
             ///< that face away; unit length in each sample
  depth,     ///< distance of the first surface from the camera, in units of the world; infinity where nothing is
  position,  ///< of the first surface, in the world; 0, 0, 0 where nothing is
  object,    ///< the object's number, see DrawnObjects; 0 where nothing is
  instance,  ///< of what is shown several times, the occurrence's number from 1; else 0
  material,  ///< the material's number from 1, in the order in which the shapes use them; 0 where nothing is
};
inline constexpr std::size_t plane_count = std::size_t(FilmPlane::material) + 1;

/// How a plane's samples become a pixel.
enum class PlaneRule {
  mean,    ///< of all samples
  center,  ///< what the ray through the pixel's middle finds, whatever the samples
};

struct PlaneInfo {
  std::string_view name;  ///< "radiance"
  PlaneRule rule;
  bool is_number;                          ///< 32-bit unsigned integers; else 32-bit floats
  std::vector<std::string_view> channels;  ///< as OpenEXR names them: {"R", "G", "B"}
};

/// By the plane's place in the enumeration.
std::span<PlaneInfo const> plane_infos();
inline PlaneInfo const& info_of(FilmPlane plane) { return plane_infos()[std::size_t(plane)]; }

/// Some of the planes.
class PlaneSet {
 public:
  PlaneSet() = default;
  PlaneSet(std::initializer_list<FilmPlane> planes) {
    for (FilmPlane const plane : planes) add(plane);
  }
  void add(FilmPlane plane) { bits_ |= 1u << unsigned(plane); }
  bool has(FilmPlane plane) const { return (bits_ >> unsigned(plane) & 1u) != 0; }
  bool is_empty() const { return bits_ == 0; }
  /// Whether it has one of that rule.
  bool has(PlaneRule rule) const;
  /// In the order of the enumeration.
  std::vector<FilmPlane> list() const;
  std::uint32_t bits() const { return bits_; }
  friend bool operator==(PlaneSet const&, PlaneSet const&) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// A rectangle of pixels; x and y count from the picture's top left corner.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(Region const&, Region const&) = default;
};

inline Region whole_picture(Resolution const& size) { return {0, 0, size.width, size.height}; }

/// The samples first, first + 1, ... end - 1 of each pixel.
struct SampleRange {
  int first = 0;
  int end = 0;
  int count() const { return end - first; }
  friend bool operator==(SampleRange const&, SampleRange const&) = default;
};

/// The samples of a region of a picture, plane by plane, before they are developed. As large as the region.
///
/// Sums grow in blocks of 16 samples (0..15, 16..31, ...): those of a block are added in their order, then the blocks
/// in theirs. So ranges of samples that were traced apart, one after the other or on other machines, merge to the very
/// bytes of all of them traced at once, if each but the last ends where a block does.
class Film {
 public:
  static constexpr int block_size = 16;

  Film() = default;
  /// Without samples yet; the next one is `first_sample`, a multiple of block_size. All planes hold 0. Throws
  /// std::invalid_argument for another one, and for a region with a negative side.
  Film(Region const& region, PlaneSet const& planes, int first_sample = 0);

  Region const& region() const { return region_; }
  Resolution size() const { return {region_.width, region_.height}; }
  PlaneSet const& planes() const { return planes_; }
  SampleRange const& samples() const { return samples_; }
  bool is_empty() const { return samples_.count() == 0; }

  /// Adds the samples that follow on this film's. Throws std::invalid_argument unless region and planes are the same,
  /// and `next` begins where this film ends, at a block's border. The film is the same to the byte as if all had been
  /// traced into it.
  void merge(Film const& next);

  /// The value of a pixel of the region's row `y` and column `x` (0, 0: its top left corner), a channel each. Planes of
  /// rule `center` are only in films that begin with sample 0. Throws std::invalid_argument for a plane that is not
  /// there.
  float value(FilmPlane plane, int x, int y, int channel = 0) const;
  std::uint32_t number(FilmPlane plane, int x, int y) const;
  /// All values of a plane: height x width x channels.
  std::vector<float> values(FilmPlane plane) const;

  // For who traces into it.

  /// height x width x channels: of rule `mean`, the sum of the last block's samples so far (a block that is full stays
  /// here until the next one begins); of rule `center`, the value.
  std::span<float> floats(FilmPlane plane);
  std::span<std::uint32_t> numbers(FilmPlane plane);
  std::span<std::uint32_t const> numbers(FilmPlane plane) const;
  /// All samples before `end` are in.
  void set_end(int end);
  /// Puts the last block to those before, and begins another.
  void close_block();
  /// Forgets the samples of the last block, which may be there in part.
  void drop_last_block();
  /// The sums of all samples, of a plane of rule `mean` that the film then no longer has.
  std::vector<float> take_sums(FilmPlane plane);
  /// Drops all other planes.
  void keep(PlaneSet const& planes);

  // For who stores it.

  /// A film that has those samples, all arrays of it 0. `samples` begins where a block does.
  static Film of_samples(Region const& region, PlaneSet const& planes, SampleRange const& samples);
  /// The bytes of all that it holds: as many arrays, of the same sizes, for every film of these planes and samples with
  /// as many pixels. Each is height x width x a size for each pixel.
  std::vector<std::span<std::byte>> arrays();
  /// Puts a part of the picture in its place. Throws std::invalid_argument unless planes and samples are the same, and
  /// its region lies within this film's.
  void place(Film part);

 private:
  struct Sums {
    std::vector<float> open;                 // of the last block
    std::vector<float> closed;               // of those before, where sample 0 is among them
    std::vector<std::vector<float>> blocks;  // else each of them
  };
  static std::vector<float> sums_of_all(Sums sums);
  std::size_t value_count(FilmPlane plane) const;
  std::size_t pixel_index(int x, int y) const;

  Region region_;
  PlaneSet planes_;
  SampleRange samples_;
  std::array<Sums, plane_count> sums_;
  std::array<std::vector<std::uint32_t>, plane_count> numbers_;
};

/// How radiance becomes what a picture stores.
struct Development {
  double exposure_ev = 0;            ///< radiance is multiplied by 2 to the power of this
  ToneMap tone_map = ToneMap::none;  ///< `automatic` is for Renderer::develop
  Transfer transfer = Transfer::linear;
};

/// The picture that a film with radiance holds; nothing is clamped. With alpha, the picture has it too, and colours are
/// straight, not premultiplied. Renderer::develop gives the same bytes.
/// Throws std::invalid_argument for a film without radiance, or without samples, and for `automatic`.
Image develop(Film film, Development const& development);

/// Planes other than radiance as something to look at, 0..1: depth from white (the nearest in the picture) to dark (the
/// farthest), coordinates of normals from -1..1 as red, green and blue, positions within their box, a colour of its own
/// for each number, alpha as it is, and albedo, a colour, as `transfer` stores it. Black where nothing is.
Image show_plane(Film const& film, FilmPlane plane, Transfer transfer = Transfer::linear);

}  // namespace lichtraum
