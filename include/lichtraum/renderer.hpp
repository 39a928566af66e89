#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/background.hpp"
#include "lichtraum/bounds.hpp"
#include "lichtraum/camera.hpp"
#include "lichtraum/denoise.hpp"
#include "lichtraum/device.hpp"
#include "lichtraum/film.hpp"
#include "lichtraum/image.hpp"
#include "lichtraum/integrator.hpp"
#include "lichtraum/scene.hpp"
#include "lichtraum/scene_edits.hpp"
#include "lichtraum/traversal.hpp"

namespace LICHTRAUM_API lichtraum {

/// Where in a pixel its samples lie. One sample is the pixel's centre.
struct Sampling {
  enum class Pattern {
    grid,    ///< count = N * N, in the middles of N x N equal cells
    seeded,  ///< uniform in the pixel, drawn from (pixel, sample, seed) only
  };
  Pattern pattern = Pattern::grid;
  int count = 1;  ///< per pixel; a square number for a grid
  friend bool operator==(Sampling const&, Sampling const&) = default;
};

/// What the scene stands on: a level plane at the lowest point of its shapes (but infinite ones), which only the camera
/// sees. In the open it looks like the background, or is transparent where that is; it shows the scene's shadows, and
/// the light that the scene throws on it.
enum class Ground {
  none,
  matt,
  glossy,  ///< shows what it mirrors, too; not where the background is transparent
};

/// Which picture of a scene to compute: planes of a region of pixels, of a range of samples.
struct RenderRequest {
  Camera camera;
  Resolution resolution;
  Region region;  ///< within the resolution
  Sampling sampling;
  std::optional<SampleRange> samples;  ///< of those of `sampling`; nothing: all. Begins with a block of the film
  Integrator integrator = Integrator::whitted;
  int max_depth = 5;  ///< how often a ray may be mirrored or refracted, a path scattered; 0: not at all
  /// Of paths: what scattered light adds at most each time it is found, in its largest channel. Less noise, but the
  /// picture is darker than it should be, by another amount on the reference tracer, which finds light in other ways.
  /// > 0; infinite: all.
  double max_indirect = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 0;
  PlaneSet planes{FilmPlane::radiance};
  std::optional<Background> background;  ///< instead of the scene's
  Ground ground = Ground::none;          ///< only of paths
};

/// Whether alpha holds shadows as well, and so has noise.
inline bool has_shadows_in_alpha(RenderRequest const& request) {
  return request.ground != Ground::none && request.planes.has(FilmPlane::alpha);
}

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;    ///< mirror and glass
  std::uint64_t camera_hits = 0;  ///< camera rays that hit something
  std::uint64_t not_finite = 0;   ///< samples left out of the film because their radiance is infinite or no number
  std::uint64_t total() const { return camera + shadow + secondary; }
  RayCounts& operator+=(RayCounts const& other) {
    camera += other.camera;
    shadow += other.shadow;
    secondary += other.secondary;
    camera_hits += other.camera_hits;
    not_finite += other.not_finite;
    return *this;
  }
};

struct RenderStatistics {
  RayCounts rays;
  double program_ms = 0;  ///< getting the device's program: from the library, a cache, or compiled
  double trace_ms = 0;    ///< tracing alone
  RenderStatistics& operator+=(RenderStatistics const& other) {
    rays += other.rays;
    program_ms += other.program_ms;
    trace_ms += other.trace_ms;
    return *this;
  }
};

struct SceneStatistics {
  std::uint64_t triangles = 0;  ///< stored; instances do not count again
  std::uint64_t spheres = 0;
  std::uint64_t boxes = 0;
  std::uint64_t instances = 0;
  std::uint64_t bvh_nodes = 0;
  std::uint64_t device_bytes = 0;
  std::uint64_t unrepresentable = 0;  ///< primitives left out because their coordinates do not fit the device's floats
  double flatten_ms = 0;
  double build_ms = 0;   ///< acceleration structures
  double upload_ms = 0;  ///< to the device
};

/// Called from the thread that renders, several times a second.
struct RenderProgress {
  double fraction = 0;     ///< 0..1
  std::uint64_t rays = 0;  ///< so far
  double elapsed_seconds = 0;
  bool is_compiling = false;  ///< the device's compiler begins, which may take seconds; it cannot be stopped
};
/// Returns false to stop: render then returns with `complete` false. What it returns while `is_compiling` does not
/// count.
using ProgressFunction = std::function<bool(RenderProgress const&)>;

struct RenderResult {
  bool complete = true;
  RenderStatistics statistics;
};

/// A scene made ready for a renderer: flat lists, their hierarchies, what shading needs. It no longer needs the Scene
/// it was made from.
class PreparedScene {
 public:
  virtual ~PreparedScene() = default;

  SceneStatistics statistics;  ///< device_bytes and upload_ms are known once a renderer was given the scene
  Bounds bounds;               ///< of all that is drawn, in the world
  /// How far along Scene::up all but infinite planes begins, from the world's origin; infinity: nothing is drawn.
  double lowest_point = std::numeric_limits<double>::infinity();
  /// A hash of all that decides what rays see: shapes as floats, where they are, materials with their textures, lights,
  /// background, tone map; not names. 32 hexadecimal digits. Equal for equal scenes, whichever renderer prepared them
  /// and whether they were written or edited so.
  std::string fingerprint;
};

/// A hash of all that decides a picture's pixels, with lichtraum's version: 32 hexadecimal digits.
std::string picture_fingerprint(PreparedScene const& scene, RenderRequest const& request,
                                Development const& development);

/// Traces pictures of one scene at a time on one device.
class Renderer {
 public:
  virtual ~Renderer() = default;

  virtual DeviceInfo const& device() const = 0;

  /// Takes apart what is drawn of `scene`: all roots, or the shape called `root` with all below it. The scene is not
  /// changed and no longer needed afterwards. What is the same in `previous` (a scene that this renderer prepared, or
  /// null) is taken from there. May be called from any thread, also while a picture is traced.
  /// Throws Error{usage} for an unknown root, std::invalid_argument for an environment without a map, or with one that
  /// is not as large as it says, and for numbers of it and an `up` that are not finite.
  virtual std::shared_ptr<PreparedScene const> prepare(
      Scene const& scene, std::string_view root = {},
      std::shared_ptr<PreparedScene const> const& previous = {}) const = 0;

  /// The same shapes in another light: nothing but tables of materials and lights is made, so this takes no time
  /// however large the scene is. `prepared` comes from prepare. May be called from any thread.
  virtual std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                                    SceneEdits const& edits) const = 0;

  /// Makes a scene that this renderer prepared the one to draw. Throws Error{no_device} with the numbers when it does
  /// not fit the device; then the one before stays.
  virtual SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) = 0;
  /// Both in one.
  SceneStatistics set_scene(Scene const& scene, std::string_view root = {}) { return set_scene(prepare(scene, root)); }

  /// Traces what `film` lacks of the request's samples. A film of other planes, another region or first sample, or of
  /// more samples, is begun anew; else it must be of a request that differs in `samples` only, or (for seeded sampling
  /// of more than one sample) in sampling.count. The same request gives the same bytes, however the work is cut.
  ///
  /// When stopped early, result.complete is false and the film holds the blocks of samples that are whole; where not
  /// one is, what is done of the first, with black for the rest.
  virtual RenderResult render(RenderRequest const& request, Film& film, ProgressFunction const& progress = {}) = 0;

  /// The picture that a film with radiance holds: lichtraum::develop, with the scene's tone map for `automatic`.
  virtual Image develop(Film film, Development const& development) = 0;

  /// lichtraum::filter_noise, with the same bytes.
  virtual std::vector<float> filter_noise(NoisyPicture const& picture) = 0;
};

/// Both in one: request.region, traced and developed.
RenderResult render_image(Renderer& renderer, RenderRequest const& request, Image& image,
                          Development const& development = {}, ProgressFunction const& progress = {});

/// `device`: of find_devices, or reference_device. `traversal`: nothing for the device's default. The reference tracer
/// has one way to trace only.
std::unique_ptr<Renderer> make_renderer(DeviceInfo const& device, std::optional<Traversal> traversal = {});

}  // namespace lichtraum
