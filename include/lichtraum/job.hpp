#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/denoise.hpp"
#include "lichtraum/environment.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/image_io.hpp"
#include "lichtraum/model.hpp"
#include "lichtraum/renderer.hpp"

namespace LICHTRAUM_API lichtraum {

/// How a scene or a model is read, as far as that decides its pictures.
struct SceneReading {
  EsdfDialect dialect;
  ModelChoice model;
  EnvironmentChoice environment;
  std::vector<std::filesystem::path> allowed_paths;  ///< folders outside the file's that may be read
  friend bool operator==(SceneReading const&, SceneReading const&) = default;
};

/// From where a job's picture is seen. What is left open is as the camera has it.
struct JobView {
  /// Around what is looked at. Without a distance, from where all of it is seen.
  struct Orbit {
    double azimuth_degrees = 0;    ///< as in lichtraum::Orbit
    double elevation_degrees = 0;  ///< -90..90
    std::optional<double> distance;
    friend bool operator==(Orbit const&, Orbit const&) = default;
  };

  std::optional<Vec3> eye;              ///< where the camera stands; not with `orbit`
  std::optional<Vec3> look_at;          ///< else, where the camera is moved, the middle of what is in view
  std::optional<Vec3> up;               ///< of any length but 0; else, where the camera is moved or turned, Scene::up
  std::optional<double> fov_x_degrees;  ///< 0 < fov < 180
  std::optional<double> fov_y_degrees;  ///< the same; not with `fov_x_degrees`
  std::optional<Orbit> orbit;
  /// Makes the camera's rays parallel: it sees as much across as it did at the distance of what is looked at, or, where
  /// it frames that, just all of it.
  bool orthographic = false;
  /// What is sharp: a distance along the view, in units of the world, or a point.
  using Focus = std::variant<double, Vec3>;
  std::optional<double> aperture;  ///< of the lens, see lichtraum::Lens
  std::optional<Focus> focus;      ///< only with an aperture, the camera's or this one; else what is looked at
  Vec3 up_in(Scene const& scene) const;
  friend bool operator==(JobView const&, JobView const&) = default;
};

/// Throws Error{usage} that names the option for what no camera can have: numbers that are none, an opening angle
/// outside 0..180 degrees, a camera in the point it looks at, options that exclude each other.
void check_view(JobView const& view);

/// What rays see that hit nothing.
struct JobBackground {
  std::optional<Background> shown;  ///< nothing: the picture is transparent there
  friend bool operator==(JobBackground const&, JobBackground const&) = default;
};

/// One picture: all that decides its bytes, but for the format of its file, which the file's name tells, and the
/// device. What is left open comes from the scene. A value: it can be compared, written as JSON and read back.
struct Job {
  std::string scene;                ///< path of a scene or a model; with `text`, what messages call that
  std::optional<std::string> text;  ///< an eSDF scene, instead of the file
  SceneReading reading;
  int picture = 0;  ///< of those that the scene asks for (eSDF `render`), from 0

  std::string camera;  ///< name, or else number from 0
  JobView view;
  std::string root;                    ///< the shape that is drawn, with all below it; empty: everything
  std::optional<double> turn_degrees;  ///< the camera is carried around what is looked at, see `orbited`
  std::optional<Resolution> size;
  std::optional<Region> region;          ///< else the whole picture
  std::optional<Integrator> integrator;  ///< else see chosen_integrator
  std::optional<Sampling> sampling;
  std::optional<SampleRange> samples;  ///< of those of `sampling`; else all
  /// Fewer samples than `sampling` says will do once so little noise is left, 0 < noise <= 1: see render_to_noise.
  std::optional<double> noise;
  std::optional<int> max_depth;        ///< see RenderRequest::max_depth
  std::optional<double> max_indirect;  ///< else all, see RenderRequest::max_indirect
  std::uint64_t seed = 0;              ///< of the random samples
  PlaneSet planes{FilmPlane::radiance};
  std::optional<JobBackground> background;
  Ground ground = Ground::none;
  Denoising denoising = Denoising::automatic;  ///< of pictures that are developed; films stay as they are

  double exposure_ev = 0;
  ToneMap tone_map = ToneMap::automatic;
  /// Else srgb for models, and for scenes without a tone map that are drawn by paths in an environment that the job
  /// asks for; linear for the rest.
  std::optional<Transfer> transfer;
  ValueEncoding encoding;

  friend bool operator==(Job const&, Job const&) = default;
};

/// What a job's numbers may be, on command lines as in JSON.
namespace job_limits {
inline constexpr int grid_side = 1024;
inline constexpr int samples = grid_side * grid_side;
inline constexpr int depth = 1000;
inline constexpr double exposure_ev = 100;          ///< darker, too
inline constexpr double environment_degrees = 1e6;  ///< either way
inline constexpr double environment_brightness = max_environment_brightness;
inline constexpr int texture_side = 65536;
inline constexpr double least_point_size = 1e-6, point_size = 1000;  ///< thousandths of the model
inline constexpr int jpeg_quality = 100;
inline constexpr int pictures = 1'000'000;  ///< of all scenes of a run together
}  // namespace job_limits

/// What draws models, or scene files, on a device unless a job or the file says otherwise: models by path, but on the
/// reference tracer, which follows paths too slowly for pictures; scenes by whitted.
Integrator usual_integrator(bool is_model, DeviceKind device = DeviceKind::cpu);

/// What the job itself decides: the integrator that it names, or path where it asks for what only paths show.
std::optional<Integrator> asked_integrator(Job const& job);

/// What draws a picture, and why.
struct IntegratorChoice {
  Integrator integrator;
  std::string_view reason;  ///< reads on after "drawn by path, as "
};

/// The job's integrator; else that of the scene's `render`; else path for a scene that holds what only paths show (an
/// environment, a lamp with a size, a material with emission) or a job that asks for a ground; else usual_integrator.
/// Throws Error{usage} for a picture that there is not.
IntegratorChoice chosen_integrator(Job const& job, Scene const& scene, DeviceKind device = DeviceKind::cpu);

/// What is done about noise in a picture of that integrator: `asked`, unless that is `automatic`. Whitted's rays make
/// none, or through a lens little.
Denoising decided(Denoising asked, Integrator integrator);

/// The planes that the job asks for, and alpha, which a transparent background needs besides.
PlaneSet shown_planes(Job const& job);
/// These, and what denoising goes by: albedo and normals.
PlaneSet traced_planes(Job const& job);

/// The job with camera (by its name; empty where the scene has none and the job's view says where one stands), size,
/// region, integrator, sampling, depth and denoising decided: by the job itself, else by the scene's `render` statement
/// number `picture`, else by the camera, else by the scene's defaults, else 640x480; whitted: one sample a pixel, 64
/// with a lens, depth 5; path: 64 samples, of models 16, depth 64; 4096 at most where a limit of noise is set, which
/// only radiance has. `scene` is that at the end of its file. A job that is decided stays as it is. Throws Error{usage}
/// for what the job asks for and cannot have, Error{scene} for a scene without cameras, or with a `render` that names
/// an unknown one.
Job resolved(Job job, Scene const& scene);

/// What to trace for the job. `scene` is what is drawn, of which the camera is taken: for the picture of a `render`,
/// the scene as defined up to there. The camera is moved as the job's view says, and fitted to the size of the picture.
/// Same exceptions as `resolved`, also Error{usage} where the camera would look along `up`. Renderer::prepare refuses
/// an unknown root; so does this where it has to look at what is drawn.
/// `turn_center`: what the camera is carried around unless the job's view looks at something, for those who know it;
/// else turn_center_of finds it, which takes a walk through the scene.
RenderRequest request_of(Job const& job, Scene const& scene, std::optional<Vec3> const& turn_center = {});

/// The box around what is in view of the job's camera, as bounds_of_interest has it: for a job with an orbit, which
/// says only from which side to look, without regard to where the camera stands.
Bounds bounds_in_view(Job const& job, Scene const& scene, Camera const& camera);

/// The middle of that box, around which a job turns that looks at nothing in particular; the world's origin when
/// nothing is drawn.
Vec3 turn_center_of(Job const& job, Scene const& scene, Camera const& camera);

/// What to look at first when someone wants to look around: the job's camera, in the size of its picture, whole, one
/// sample a pixel unless the job says otherwise, radiance only, and black where it would be transparent.
/// Same exceptions as request_of.
RenderRequest view_of(Job job, Scene const& scene);

/// How radiance becomes the job's picture. `automatic` is what the scene says, but `neutral` where paths draw a model
/// (`none` where all of it is unlit), or a scene that has no curve in an environment that was asked for: highlights are
/// beyond any display, and `neutral` keeps the colours of the rest.
Development development_of(Job const& job, Scene const& scene);

/// A JSON object with a key for each member that is not left open; docs/JOB.md lists them. Throws Error{usage} when a
/// text in it is not UTF-8, as JSON must be, and for what job_from_json refuses, such as no scene.
std::string to_json(Job const& job);

/// The job that such text holds. Throws Error{usage} for text that is not JSON (with line and column), and for unknown
/// keys, values of a wrong type or out of range, with their place as a JSON pointer (RFC 6901): "/region/2: expected a
/// whole number from 1 to 2147483647". May be given text that nobody trusts. Whether the values suit the scene is found
/// out by `resolved`.
Job job_from_json(std::string_view text);

}  // namespace lichtraum
