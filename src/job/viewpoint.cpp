#include "job/viewpoint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "core/float3.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/orbit.hpp"
#include "lichtraum/turntable.hpp"

namespace lichtraum {
namespace {

void require(bool holds, std::string const& message) {
  if (!holds) throw Error(ErrorKind::usage, message);
}

std::string text_of(Vec3 const& v) { return fmt::format("{:g},{:g},{:g}", v.x, v.y, v.z); }

void check_fov(char const* option, std::optional<double> const& degrees) {
  require(!degrees || (*degrees > 0 && *degrees < 180),
          fmt::format("{} {:g}: an opening angle lies between 0 and 180 degrees", option, degrees.value_or(0)));
}

/// The frame of a camera at `eye`. `direction` is not zero.
Transform look_along(Vec3 const& eye, Vec3 const& direction, Vec3 const& up) {
  try {
    return Transform::look_along(eye, direction, up);
  } catch (std::invalid_argument const&) {
    char const* const other = std::abs(up.y) > std::abs(up.z) ? "0,0,-1" : "0,1,0";
    throw Error(ErrorKind::usage,
                fmt::format("--up {} is parallel to the direction in which the camera looks, {}: another one, such as "
                            "--up {}, says which side is up",
                            text_of(up), text_of(direction), other));
  }
}

/// The same, of one that looks at `target`: what --look-at says, or else the middle of what is in view.
Transform look_at(Vec3 const& eye, Vec3 const& target, Vec3 const& up, bool is_said) {
  require(target != eye,
          is_said ? fmt::format("--look-at {} is where the camera stands, so it has no direction", text_of(target))
                  : fmt::format("--eye {} is the middle of what is in view, which the camera is to look at: --look-at "
                                "says where else",
                                text_of(eye)));
  return look_along(eye, target - eye, up);
}

/// What is in view: what the camera frames, else what is so where it stands.
Bounds subject_of(Camera const& camera, Job const& job, Scene const& scene) {
  if (camera.fit() && camera.fit()->framed) return camera.fit()->framed->box;
  Bounds const box = bounds_in_view(job, scene, camera);
  return box.is_empty() ? Bounds{Vec3(-1), Vec3(1)} : box;
}

CameraFit fit_of(Camera const& camera, JobView const& view) {
  CameraFit fit = camera.fit().value_or(CameraFit{CameraFit::Side::width, camera.fov_x_degrees(), {}, camera.width()});
  if (view.fov_x_degrees) fit = {CameraFit::Side::width, *view.fov_x_degrees, fit.framed};
  if (view.fov_y_degrees) fit = {CameraFit::Side::height, *view.fov_y_degrees, fit.framed};
  return fit;
}

/// What a camera that stands where it will looks at.
Vec3 looked_at(Camera const& camera, Job const& job, Scene const& scene) {
  return job.view.look_at ? *job.view.look_at : subject_of(camera, job, scene).center();
}

/// How far the point lies before the camera, along its axis in units of the world; negative: behind it.
double distance_ahead(Camera const& camera, Vec3 const& point) {
  Transform const& world_from_camera = camera.world_from_camera();
  return glm::dot(point - world_from_camera.point(Vec3(0)), glm::normalize(world_from_camera.vector({0, 0, -1})));
}

/// How long the side that `fit` keeps is where the camera, which stands where it will, looks: in its own frame.
double extent_of(Camera const& camera, CameraFit const& fit, Job const& job, Scene const& scene) {
  if (fit.framed) return 1;  // it takes what it needs
  double const ahead = distance_ahead(camera, looked_at(camera, job, scene));
  require(ahead > 0,
          "--orthographic: the middle of what is in view is not before the camera: --look-at says what the "
          "picture is to be as wide as");
  double const unit_length = glm::length(camera.world_from_camera().vector({0, 0, -1}));
  return Camera("", fit.fov_degrees).width_at(ahead / unit_length);
}

/// Of a camera that stands where it will.
Lens lens_of(Camera const& camera, Job const& job, Scene const& scene) {
  JobView const& view = job.view;
  Lens lens = camera.lens();
  bool const has_focus = lens.aperture > 0;
  if (view.aperture) lens.aperture = *view.aperture;
  require(lens.aperture > 0 || !view.focus,
          "--focus: without a lens everything is sharp; --aperture says how wide it is, in units of the scene");
  if (lens.aperture == 0) return lens;
  auto const* const distance = view.focus ? std::get_if<double>(&*view.focus) : nullptr;
  if (distance) lens.focus_distance = *distance;
  if (distance || (has_focus && !view.focus)) return lens;
  Vec3 const point = view.focus ? std::get<Vec3>(*view.focus) : looked_at(camera, job, scene);
  double const ahead = distance_ahead(camera, point);
  require(ahead > 0, view.focus ? fmt::format("--focus {} is not before the camera", text_of(point))
                                : "--aperture: the middle of what is in view is not before the camera: --focus "
                                  "says at what distance the picture is sharp");
  lens.focus_distance = ahead;
  return lens;
}

}  // namespace

Vec3 JobView::up_in(Scene const& scene) const { return up.value_or(scene.up); }

void check_view(JobView const& view) {
  auto const check_point = [](char const* option, std::optional<Vec3> const& v) {
    require(!v || is_finite(*v), fmt::format("{}: its numbers must be finite", option));
  };
  check_point("--eye", view.eye);
  check_point("--look-at", view.look_at);
  check_point("--up", view.up);
  require(!view.up || *view.up != Vec3(0), "--up 0,0,0: it has no direction");
  check_fov("--fov-x", view.fov_x_degrees);
  check_fov("--fov-y", view.fov_y_degrees);
  require(!view.fov_x_degrees || !view.fov_y_degrees,
          "--fov-x and --fov-y cannot be combined: pixels are square, so one of them decides the other");
  require(!view.eye || !view.orbit, "--eye and --orbit cannot be combined: both say where the camera stands");
  require(!view.aperture || (*view.aperture >= 0 && std::isfinite(*view.aperture)),
          "--aperture: a lens has a diameter of at least 0");
  if (view.focus) {
    auto const* const point = std::get_if<Vec3>(&*view.focus);
    double const distance = point ? 1 : std::get<double>(*view.focus);
    require(distance > 0 && std::isfinite(distance), "--focus: a distance must be above 0");
    if (point) check_point("--focus", *point);
  }
  if (!view.orbit) return;
  auto const& [azimuth, elevation, distance] = *view.orbit;
  require(std::isfinite(azimuth), "--orbit: its azimuth must be finite");
  require(std::abs(elevation) <= 90,
          fmt::format("--orbit: an elevation lies between -90 and 90 degrees, not at {:g}", elevation));
  require(!distance || (*distance > 0 && std::isfinite(*distance)), "--orbit: a distance must be above 0");
}

Camera viewpoint(Camera camera, Job const& job, Scene const& scene, Resolution const& size) {
  JobView const& view = job.view;
  check_view(view);
  Vec3 const up = view.up_in(scene);
  CameraFit fit = fit_of(camera, view);
  auto const fitted = [&] {
    if (fit.framed && job.turn_degrees) fit.framed->turn_axis = up;
    if (view.orthographic && fit.extent == 0) fit.extent = extent_of(camera, fit, job, scene);
    camera.set_fit(fit);
    return camera.fitted(size);
  };
  if (view == JobView()) return camera.fit() ? fitted() : camera;
  bool const is_automatic = fit.framed.has_value();
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  if (view.eye) {
    Camera moved = camera;
    moved.set_world_from_camera(Transform::translation(*view.eye));
    Vec3 const target = looked_at(moved, job, scene);
    camera.set_world_from_camera(look_at(*view.eye, target, up, view.look_at.has_value()));
    fit.framed.reset();
  } else if (view.orbit || (is_automatic && (view.look_at || view.up))) {
    Bounds const subject = subject_of(camera, job, scene);
    Vec3 const center = view.look_at.value_or(subject.center());
    Orbit const orbit =
        view.orbit ? Orbit{view.orbit->azimuth_degrees, view.orbit->elevation_degrees} : three_quarter_view;
    Transform const rotation = orbit_rotation(orbit, up);
    double const distance = view.orbit ? view.orbit->distance.value_or(0) : 0;
    Vec3 const back = rotation.vector(Vec3(0, 0, 1));
    camera.set_world_from_camera(Transform::translation(center + distance * back) * rotation);
    fit.framed = distance > 0 ? std::nullopt : std::optional(CameraFit::Framed{subject, view.look_at});
  } else if (view.look_at) {
    camera.set_world_from_camera(look_at(eye, *view.look_at, up, true));
  } else if (view.up) {
    camera.set_world_from_camera(look_along(eye, camera.world_from_camera().vector(Vec3(0, 0, -1)), up));
  }
  camera = fitted();
  camera.set_lens(lens_of(camera, job, scene));
  return camera;
}

}  // namespace lichtraum
