#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lichtraum/bounds.hpp"
#include "lichtraum/camera.hpp"
#include "lichtraum/device.hpp"
#include "lichtraum/image.hpp"
#include "lichtraum/scene.hpp"
#include "lichtraum/scene_edits.hpp"
#include "lichtraum/traversal.hpp"

namespace lichtraum {

/// A rectangle of pixels; x and y count from the top left corner.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Where in a pixel its samples lie. One sample is the pixel's centre.
struct Sampling {
  enum class Pattern {
    grid,    ///< count = N * N, in the middles of N x N equal cells
    seeded,  ///< uniform in the pixel, drawn from (pixel, sample, seed) only
  };
  Pattern pattern = Pattern::grid;
  int count = 1;  ///< per pixel; a square number for a grid
};

/// What a pixel holds. All but the picture are about the first surface that the ray through the pixel's middle meets,
/// as it is: samples, depth, tone map and transfer play no role. (Renderers call these AOVs, arbitrary output
/// variables.)
enum class Aov {
  picture,    ///< radiance
  depth,      ///< in all three channels: the surface's distance from the camera, in units of the world; else infinity
  normal,     ///< x, y and z in the world, unit length, on the camera's side, as shaded (smooth, bumpy); else 0, 0, 0
  object_id,  ///< in all three channels: the object's number (see DrawnObjects), exact up to 2^24; else 0
};

/// Which picture of a scene to compute: a region of pixels times a range of samples.
struct RenderRequest {
  Camera camera;
  Resolution resolution;
  Region region;  ///< within the resolution
  Sampling sampling;
  int max_depth = 5;  ///< how often a ray may be mirrored or refracted; 0: not at all
  std::uint64_t seed = 0;
  /// Applied to each finished pixel. These two leave linear radiance; `automatic` is the scene's.
  ToneMap tone_map = ToneMap::none;
  Transfer transfer = Transfer::linear;
  Aov aov = Aov::picture;
};

struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;    ///< mirror and glass
  std::uint64_t camera_hits = 0;  ///< camera rays that hit something
  std::uint64_t total() const { return camera + shadow + secondary; }
  RayCounts& operator+=(RayCounts const& other) {
    camera += other.camera;
    shadow += other.shadow;
    secondary += other.secondary;
    camera_hits += other.camera_hits;
    return *this;
  }
};

struct RenderStatistics {
  RayCounts rays;
  double program_ms = 0;  ///< getting the device's program: from the library, a cache, or compiled
  double trace_ms = 0;    ///< tracing alone
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
};
/// Returns false to stop: render then returns with `complete` false.
using ProgressFunction = std::function<bool(RenderProgress const&)>;

/// The samples that a picture has so far, for Renderer::refine.
struct Accumulation {
  int count = 0;  ///< of each pixel
  Image sums;     ///< of their radiance, linear
};

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
  /// A hash of everything that decides what rays see. Equal for equal scenes, whatever the device and the traversal,
  /// except that the reference tracer has its own.
  std::string fingerprint;
};

/// A hash of all that decides a picture's pixels, with lichtraum's version: 32 hexadecimal digits.
std::string picture_fingerprint(PreparedScene const& scene, RenderRequest const& request);

/// Traces pictures of one scene at a time on one device.
class Renderer {
 public:
  virtual ~Renderer() = default;

  virtual DeviceInfo const& device() const = 0;

  /// Takes apart what is drawn of `scene`: all roots, or the shape called `root` with all below it. The scene is not
  /// changed and no longer needed afterwards. What is the same in `previous` (a scene that this renderer prepared, or
  /// null) is taken from there. May be called from any thread, also while a picture is traced.
  /// Throws Error{usage} for an unknown root.
  virtual std::shared_ptr<PreparedScene const> prepare(
      Scene const& scene, std::string_view root = {},
      std::shared_ptr<PreparedScene const> const& previous = {}) const = 0;

  /// The same shapes in another light: nothing but tables of materials and lights is made, so this takes no time
  /// however large the scene is. `prepared` comes from prepare. May be called from any thread.
  virtual std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                                    SceneEdits const& edits) const = 0;

  /// Makes a scene that this renderer prepared the one to draw. Throws Error{no_device} with the numbers when it does
  /// not fit the device.
  virtual SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) = 0;
  /// Both in one.
  SceneStatistics set_scene(Scene const& scene, std::string_view root = {}) { return set_scene(prepare(scene, root)); }

  /// Traces request.region of the picture into `image` (size: request.resolution; other pixels are left alone). The
  /// same request gives the same bytes, however the work is cut. When stopped early, finished tiles are in `image`, the
  /// others are black (of an Aov: all may be) and `result.complete` is false.
  virtual RenderResult render(RenderRequest const& request, Image& image, ProgressFunction const& progress = {}) = 0;

  /// The same picture, to the byte, with what was traced before: `sums` has the first samples of a request that differs
  /// from this one in sampling.count only, and gets the others. Only seeded samples can go on like this; for a grid, or
  /// one sample, `sums` is emptied. A renderer may also trace all anew. When stopped early, `sums` is emptied and
  /// `image` holds nothing of use.
  virtual RenderResult refine(RenderRequest const& request, Accumulation& sums, Image& image,
                              ProgressFunction const& progress = {}) {
    sums = {};
    return render(request, image, progress);
  }
};

/// For a device of `list` (see select_device). `traversal`: nothing for the device's default. The reference tracer has
/// one way to trace only.
std::unique_ptr<Renderer> make_renderer(DeviceInfo const& device, std::optional<Traversal> traversal = {});

}  // namespace lichtraum
