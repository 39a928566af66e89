#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>

#include "io/framing.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/orbit.hpp"
#include "lichtraum/turntable.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"

// From where a picture is seen: cameras that fit the size of their picture, and what a job says instead of the scene.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

Vec3 eye_of(Camera const& camera) { return camera.world_from_camera().point(Vec3(0)); }
Vec3 axis_of(Camera const& camera, Vec3 const& axis) { return camera.world_from_camera().vector(axis); }

bool is_near(Vec3 const& a, Vec3 const& b, double tolerance = 1e-9) { return glm::distance(a, b) < tolerance; }

/// How far a point of the world is from the picture's middle: 1 at its edges, in x and y.
Vec3 place_in_picture(Camera const& camera, Resolution const& size, Vec3 const& point) {
  Vec3 const p = camera.world_from_camera().inverse().point(point);
  REQUIRE(p.z < 0);
  double const half_width = std::tan(glm::radians(camera.fov_x_degrees()) / 2);
  return {p.x / -p.z / half_width, p.y / -p.z / (half_width * size.height / size.width), 0};
}

/// The rectangle around the box's image.
Bounds image_of(Camera const& camera, Resolution const& size, Bounds const& box) {
  Bounds image;
  for (int i = 0; i < 8; ++i) image.add(place_in_picture(camera, size, corner_of(box, i)));
  return image;
}

/// The largest of all corners' distances from the middle.
double extent(Camera const& camera, Resolution const& size, Bounds const& box) {
  double largest = 0;
  for (int i = 0; i < 8; ++i) {
    Vec3 const place = glm::abs(place_in_picture(camera, size, corner_of(box, i)));
    largest = std::max({largest, place.x, place.y});
  }
  return largest;
}

constexpr Resolution sizes[] = {{1024, 768}, {1280, 720}, {1600, 400}, {400, 1600}, {100, 100}, {5000, 1}};

/// A ball of radius 1 at 0, 0, -5 that an eye at the origin looks at.
Scene ball_scene() { return scene_of(red + "define camera eye 45 80 60\ndefine shape sphere ball 0 0 -5 1 red\n"); }

/// A JobView with defaults for what a test leaves out.
struct View {
  std::optional<Vec3> eye{}, look_at{}, up{};
  std::optional<double> fov_x_degrees{}, fov_y_degrees{};
  std::optional<JobView::Orbit> orbit{};
  JobView view() const { return {eye, look_at, up, fov_x_degrees, fov_y_degrees, orbit, false, {}, {}}; }
};

Camera seen_from(View const& view, Scene const& scene = ball_scene()) {
  Job job;
  job.scene = "s.sdf";
  job.view = view.view();
  return request_of(job, scene).camera;
}

std::string refusal(View const& view, Scene const& scene = ball_scene()) {
  try {
    seen_from(view, scene);
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::usage);
    return error.what();
  }
  return "";
}

/// A model's scene: a long box and the camera that frames it.
Scene model_scene() {
  Scene scene;
  Bounds const box{Vec3(-1, 0, -4), Vec3(3, 1, 4)};
  scene.shapes.insert(std::make_shared<Box>("box", box.min, box.max, nullptr));
  scene.cameras.insert(frame_box("default", box));
  return scene;
}

}  // namespace

TEST_CASE("an orbit begins at the front and goes to the right, then up", "[unit][view]") {
  auto const back = [](Orbit const& orbit, Vec3 const& up = {0, 1, 0}) {
    return orbit_rotation(orbit, up).vector(Vec3(0, 0, 1));
  };
  CHECK(is_near(back({0, 0}), {0, 0, 1}));
  CHECK(is_near(back({90, 0}), {1, 0, 0}));
  CHECK(is_near(back({0, 90}), {0, 1, 0}));
  CHECK(is_near(back({180, -30}), {0, -0.5, -std::sqrt(0.75)}));
  CHECK(is_near(orbit_rotation({0, 90}).vector(Vec3(0, 1, 0)), {0, 0, -1}));  // what is far is at the top
  // z up, as in Blender: the front is at -y, the right at +x.
  CHECK(is_near(back({0, 0}, {0, 0, 7}), {0, -1, 0}));
  CHECK(is_near(back({90, 0}, {0, 0, 7}), {1, 0, 0}));
  CHECK(is_near(back({0, 90}, {0, 0, 7}), {0, 0, 1}));
  CHECK(is_near(back({0, 90}, {0, -2, 0}), {0, -1, 0}));
  CHECK(is_near(back({0, 90}, {1, 2, 3}), glm::normalize(Vec3(1, 2, 3))));
  CHECK_THROWS_AS(orbit_rotation({0, 0}, Vec3(0)), std::invalid_argument);
}

TEST_CASE("an automatic camera sees all of a box, and not much more, in pictures of any shape", "[unit][view]") {
  for (Bounds const& box : {Bounds{Vec3(-1), Vec3(1)}, Bounds{Vec3(5, 0, 0), Vec3(5.1, 9, 0.2)},
                            Bounds{Vec3(-1e6, 0, -1e5), Vec3(1e6, 1, 1e5)}, Bounds{Vec3(-1e-7, 0, 0), Vec3(1e-7)}}) {
    Camera const automatic = frame_box("default", box);
    for (Resolution const& size : sizes) {
      INFO(size.width << "x" << size.height << " of " << box.max.x << " " << box.max.y << " " << box.max.z);
      Camera const camera = automatic.fitted(size);
      double const largest = extent(camera, size, box);
      CHECK(largest < 0.98);
      CHECK(largest > 0.94);  // 1 / 1.06, the margin around it
      CHECK(is_near(image_of(camera, size, box).center(), Vec3(0), 1e-6));
      CHECK(!camera.fit());
      double const fov_y =
          glm::degrees(2 * std::atan(std::tan(glm::radians(camera.fov_x_degrees()) / 2) * size.height / size.width));
      CHECK(std::max(camera.fov_x_degrees(), fov_y) == Approx(45));
      Vec3 const back = axis_of(camera, {0, 0, 1});
      CHECK(glm::degrees(std::asin(back.y)) == Approx(20));
      CHECK(glm::degrees(std::atan2(back.x, back.z)) == Approx(35));
    }
  }
  Bounds const point{Vec3(1, 2, 3), Vec3(1, 2, 3)};
  CHECK(glm::distance(eye_of(frame_box("default", point).fitted({9, 9})), point.min) == Approx(1));
  CHECK(eye_of(frame_box("default", {}).fitted({9, 9})).y > 0);
}

TEST_CASE("a camera keeps the opening angle that its fit has", "[unit][view]") {
  Camera camera("eye", 30);
  CHECK(camera.fitted({1, 7}).fov_x_degrees() == 30);
  camera.set_fit({CameraFit::Side::height, 60, {}});
  CHECK(camera.fitted({100, 100}).fov_x_degrees() == Approx(60));
  CHECK(std::tan(glm::radians(camera.fitted({300, 100}).fov_x_degrees()) / 2) ==
        Approx(3 * std::tan(glm::radians(30.0))));
  camera.set_fit({CameraFit::Side::longer, 60, {}});
  CHECK(camera.fitted({300, 100}).fov_x_degrees() == 60);
  CHECK(camera.fitted({100, 300}).fov_x_degrees() < 25);
  camera.set_fit({CameraFit::Side::height, 179.9999999, {}});
  CHECK(camera.fitted({2'000'000'000, 1}).fov_x_degrees() < 180);
  camera.set_fit({CameraFit::Side::height, 1e-9, {}});
  CHECK(camera.fitted({1, 2'000'000'000}).fov_x_degrees() > 0);
  for (double const fov : {0.0, 180.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(camera.set_fit({CameraFit::Side::width, fov, {}}), std::invalid_argument);
  }
}

TEST_CASE("a job without a view has the scene's camera", "[unit][view]") {
  CHECK(seen_from({}).world_from_camera().is_identity());
  CHECK(seen_from({}).fov_x_degrees() == 45);
}

TEST_CASE("a job may put the camera anywhere", "[unit][view]") {
  Camera const moved = seen_from({.eye = Vec3(3, 0, -5)});
  CHECK(eye_of(moved) == Vec3(3, 0, -5));
  CHECK(is_near(axis_of(moved, {0, 0, -1}), {-1, 0, 0}));  // to the ball's middle
  CHECK(moved.fov_x_degrees() == 45);
  Camera const turned = seen_from({.look_at = Vec3(0, 0, 5)});
  CHECK(eye_of(turned) == Vec3(0));
  CHECK(is_near(axis_of(turned, {0, 0, -1}), {0, 0, 1}));
  CHECK(is_near(axis_of(turned, {0, 1, 0}), {0, 1, 0}));
  Camera const both = seen_from({.eye = Vec3(0, 4, 0), .look_at = Vec3(0), .up = Vec3(1, 1, 0)});
  CHECK(is_near(axis_of(both, {0, 0, -1}), {0, -1, 0}));
  CHECK(is_near(axis_of(both, {0, 1, 0}), {1, 0, 0}));
  Camera const rolled = seen_from({.up = Vec3(2, 0, 0)});
  CHECK(is_near(axis_of(rolled, {0, 0, -1}), {0, 0, -1}));
  CHECK(is_near(axis_of(rolled, {0, 1, 0}), {1, 0, 0}));
  CHECK(seen_from({.fov_x_degrees = 70}).fov_x_degrees() == 70);
  CHECK(std::tan(glm::radians(seen_from({.fov_y_degrees = 60}).fov_x_degrees()) / 2) ==
        Approx(4.0 / 3 * std::tan(glm::radians(30.0))));
}

TEST_CASE("parallel rays show as much as the camera saw of what it looks at", "[unit][view]") {
  auto const seen = [](JobView view, std::string const& camera = "define camera eye 90\n") {
    view.orthographic = true;
    Job job;
    job.view = view;
    std::string const ball = "define material red 1 0 0 1 0 0 0 0 0 1\ndefine shape sphere ball 0 0 -5 1 red\n";
    return request_of(job, EsdfScript::from_text(camera + ball, "test", {}).take_scene()).camera;
  };
  Camera const camera = seen({});
  CHECK(camera.is_orthographic());
  CHECK(camera.width() == Approx(10).epsilon(1e-6));  // the ball's middle is 5 away
  CHECK(eye_of(camera) == Vec3(0));
  JobView view;
  view.eye = Vec3(0, 0, 1);
  view.look_at = Vec3(0, 0, -3);
  CHECK(seen(view).width() == Approx(8));
  view.fov_y_degrees = 90;
  CHECK(seen(view).width() == Approx(8 * 4 / 3.0));
  CHECK(seen({}, "define camera eye 90\ntransform eye scale 2\n").width() == Approx(5).epsilon(1e-6));  // own units
  CHECK(seen({}, "define camera eye 90 orthographic=3\n").width() == 3);
  // An orthographic camera with an opening angle is none.
  JobView angle;
  angle.fov_x_degrees = 60;
  Scene const scene = EsdfScript::from_text("define camera eye 90 orthographic=3\n", "test", {}).take_scene();
  Job job;
  job.view = angle;
  CHECK(request_of(job, scene).camera.fov_x_degrees() == 60);
  // From where it sees all of the ball: just that.
  JobView around;
  around.orbit = JobView::Orbit{30, 20, {}};
  CHECK(seen(around).width() > 2 * 4 / 3.0);
  CHECK(seen(around).width() < 5);
  CHECK(glm::distance(eye_of(seen(around)), Vec3(0, 0, -5)) > 2);
  around.orbit->distance = 4;
  CHECK(seen(around).width() == Approx(8));
  CHECK_THROWS_WITH(seen({}, "define camera eye 90\ntransform eye translate 0 0 -9\n"),
                    contains_text("--orthographic: the middle of what is in view is not before the camera"));
}

TEST_CASE("a lens is focused on what is looked at, or what is said", "[unit][view]") {
  auto const lens_of = [](JobView const& view, std::optional<Lens> const& own = {}) {
    Scene scene = ball_scene();
    if (own) {
      Camera camera = scene.cameras.front();
      camera.set_lens(*own);
      scene.cameras = {};
      scene.cameras.insert(camera);
    }
    Job job;
    job.view = view;
    return request_of(job, scene).camera.lens();
  };
  auto const with = [](double aperture, std::optional<JobView::Focus> focus = {}) {
    JobView view;
    view.aperture = aperture;
    view.focus = focus;
    return view;
  };
  CHECK(lens_of({}) == Lens());
  CHECK(lens_of(with(0.5)).aperture == 0.5);
  CHECK(lens_of(with(0.5)).focus_distance == Approx(5));  // the ball's middle
  CHECK(lens_of(with(0.5, 3.0)).focus_distance == 3);
  CHECK(lens_of(with(0.5, Vec3(7, 1, -4))).focus_distance == Approx(4));
  JobView aside = with(0.5);
  aside.eye = Vec3(3, 0, -5);
  aside.look_at = Vec3(1, 0, -5);
  CHECK(lens_of(aside).focus_distance == Approx(2));
  CHECK(lens_of({}, Lens{0.5, 9}) == Lens{0.5, 9});
  CHECK(lens_of(with(0.25), Lens{0.5, 9}) == Lens{0.25, 9});
  CHECK(lens_of(with(0), Lens{0.5, 9}).aperture == 0);
  JobView focused;
  focused.focus = 2.0;
  CHECK(lens_of(focused, Lens{0.5, 9}) == Lens{0.5, 2});
  CHECK_THROWS_WITH(lens_of(focused), contains_text("without a lens everything is sharp"));
  CHECK_THROWS_WITH(lens_of(with(0.5, Vec3(0, 0, 1))), contains_text("--focus 0,0,1 is not before the camera"));
  for (double const wrong : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(lens_of(with(0.5, wrong)), Error);
    CHECK_THROWS_AS(Camera().set_lens({0.5, wrong}), std::invalid_argument);
  }
  CHECK_THROWS_AS(lens_of(with(-1)), Error);
}

TEST_CASE("an orbit is around what is in view, at a distance or where all of it is seen", "[unit][view]") {
  Camera const at = seen_from({.orbit = JobView::Orbit{90, 0, 7}});
  CHECK(is_near(eye_of(at), {7, 0, -5}, 1e-5));  // boxes are rounded outwards
  CHECK(is_near(axis_of(at, {0, 0, -1}), {-1, 0, 0}));
  Camera const elsewhere = seen_from({.look_at = Vec3(1, 2, 3), .orbit = JobView::Orbit{0, 90, 4}});
  CHECK(is_near(eye_of(elsewhere), {1, 6, 3}));
  Bounds const ball{Vec3(-1, -1, -6), Vec3(1, 1, -4)};
  Camera const fitted = seen_from({.orbit = JobView::Orbit{-120, 50, {}}});
  CHECK(fitted.fov_x_degrees() == Approx(45));
  double const largest = extent(fitted, {80, 60}, ball);
  CHECK((largest < 0.98 && largest > 0.75));
  Camera const narrow = seen_from({.fov_x_degrees = 10, .orbit = JobView::Orbit{-120, 50, {}}});
  CHECK(glm::distance(eye_of(narrow), Vec3(0, 0, -5)) > 3 * glm::distance(eye_of(fitted), Vec3(0, 0, -5)));
}

TEST_CASE("views of a model change what is said, and still show all of it", "[unit][view]") {
  Scene const scene = model_scene();
  Bounds const box = scene.cameras.front().fit()->framed->box;
  auto const is_whole = [&](View const& view) {
    double const largest = extent(seen_from(view, scene), {1024, 768}, box);
    return largest < 0.98 && largest > 0.6;
  };
  CHECK(is_whole({}));
  CHECK(is_whole({.fov_x_degrees = 20}));
  CHECK(is_whole({.fov_y_degrees = 100}));
  CHECK(is_whole({.up = Vec3(0, 0, 1)}));
  CHECK(is_whole({.look_at = Vec3(-1, 0, 0)}));
  CHECK(is_near(place_in_picture(seen_from({.look_at = Vec3(-1, 0, 0)}, scene), {1024, 768}, {-1, 0, 0}), Vec3(0)));
  CHECK(is_whole({.orbit = JobView::Orbit{200, -40, {}}}));
  Camera const z_up = seen_from({.up = Vec3(0, 0, 1)}, scene);
  CHECK(axis_of(z_up, {0, 1, 0}).z > 0.9);
  CHECK(eye_of(seen_from({.eye = Vec3(9, 9, 9)}, scene)) == Vec3(9, 9, 9));
}

TEST_CASE("where a job says from where to look, a scene needs no camera", "[unit][view]") {
  Scene scene = ball_scene();
  scene.cameras = {};
  CHECK_THROWS_AS(seen_from({.fov_x_degrees = 30}, scene), Error);
  CHECK(is_near(axis_of(seen_from({.eye = Vec3(0)}, scene), {0, 0, -1}), {0, 0, -1}));
  CHECK(eye_of(seen_from({.orbit = JobView::Orbit{}}, scene)).z > -4);
}

TEST_CASE("what is framed is independent of where the camera stood before", "[unit][view]") {
  // The origin, where a camera that nobody placed stands, is inside of the large ball.
  Scene const scene =
      scene_of(red + "define shape sphere large 0 0 0 2 red\ndefine shape sphere small 3 0 0 0.5 red\n");
  Bounds const both{Vec3(-2), Vec3(3.5, 2, 2)};
  Vec3 const middle = both.center();
  double const largest = extent(seen_from({.orbit = JobView::Orbit{35, 20, {}}}, scene), {640, 480}, both);
  CHECK((largest < 0.98 && largest > 0.75));
  Camera const above = seen_from({.eye = Vec3(0, 0, 15)}, scene);
  CHECK(is_near(axis_of(above, {0, 0, -1}), glm::normalize(middle - Vec3(0, 0, 15)), 1e-5));
  // Inside of the large ball, that is where it looks from, not at.
  CHECK(is_near(axis_of(seen_from({.eye = Vec3(0)}, scene), {0, 0, -1}), {1, 0, 0}, 1e-5));
  // It turns around what it frames, also high above the large ball.
  Job job;
  job.scene = "s.sdf";
  job.view = View{.orbit = JobView::Orbit{0, 89, 9}}.view();
  job.turn_degrees = 180;
  Vec3 const eye = eye_of(request_of(job, scene).camera);
  job.turn_degrees = 0;
  CHECK(is_near((eye + eye_of(request_of(job, scene).camera)) / 2.0, {middle.x, eye.y, middle.z}, 1e-5));
}

TEST_CASE("a turned view goes around what it looks at, and its own up", "[unit][view]") {
  Job job;
  job.scene = "s.sdf";
  job.view = View{.eye = Vec3(0, 3, 2), .look_at = Vec3(0, 0, 2), .up = Vec3(0, 0, 1)}.view();
  job.turn_degrees = 90;
  CHECK(is_near(eye_of(request_of(job, ball_scene()).camera), {-3, 0, 2}));
}

TEST_CASE("what turns is seen whole all around, from one distance", "[unit][view]") {
  Scene const scene = model_scene();
  Bounds const box = scene.cameras.front().fit()->framed->box;
  Resolution const size{320, 180};
  for (View const& view : {View{}, View{.orbit = JobView::Orbit{0, 60, {}}},
                           View{.up = Vec3(0, 0, 1), .orbit = JobView::Orbit{0, -10, {}}}}) {
    Job job;
    job.scene = "s.sdf";
    job.view = view.view();
    job.size = size;
    double largest = 0;
    std::vector<double> distances;
    for (int turn = 0; turn < 360; turn += 7) {
      job.turn_degrees = turn;
      Camera const camera = request_of(job, scene).camera;
      largest = std::max(largest, extent(camera, size, box));
      distances.push_back(glm::distance(eye_of(camera), box.center()));
    }
    CHECK(largest < 0.98);
    CHECK(largest > 0.9);  // no farther away than it has to be
    CHECK(*std::ranges::max_element(distances) == Approx(*std::ranges::min_element(distances)));
  }
  // Where a distance is said, it stays.
  Job job;
  job.scene = "s.sdf";
  job.view = View{.orbit = JobView::Orbit{0, 0, 7}}.view();
  job.turn_degrees = 90;
  CHECK(glm::distance(eye_of(request_of(job, scene).camera), box.center()) == Approx(7));
}

TEST_CASE("a view that no camera has is refused by the option's name", "[unit][view]") {
  double const nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  auto const expect = [](View const& view, std::string const& what) {
    std::string const message = refusal(view);
    INFO(message);
    CHECK(message.find(what) != std::string::npos);
  };
  expect({.eye = Vec3(1, 2, 3), .look_at = Vec3(1, 2, 3)}, "--look-at 1,2,3 is where the camera stands");
  expect({.look_at = Vec3(0)}, "--look-at 0,0,0 is where the camera stands");
  expect({.eye = Vec3(0, 5, 0), .look_at = Vec3(0)},
         "--up 0,1,0 is parallel to the direction in which the camera looks");
  expect({.up = Vec3(0, 0, 3)}, "--up 0,0,3 is parallel");
  expect({.up = Vec3(0)}, "--up 0,0,0");
  expect({.eye = Vec3(0, nan, 0)}, "--eye: its numbers must be finite");
  expect({.look_at = Vec3(infinity, 0, 0)}, "--look-at: its numbers must be finite");
  expect({.up = Vec3(nan)}, "--up: its numbers must be finite");
  for (double const fov : {0.0, 180.0, -3.0, nan}) {
    expect({.fov_x_degrees = fov}, "--fov-x");
    expect({.fov_y_degrees = fov}, "between 0 and 180 degrees");
  }
  expect({.fov_x_degrees = 3, .fov_y_degrees = 3}, "--fov-x and --fov-y cannot be combined");
  expect({.eye = Vec3(1), .orbit = JobView::Orbit{}}, "--eye and --orbit cannot be combined");
  expect({.orbit = JobView::Orbit{nan, 0, {}}}, "--orbit");
  expect({.orbit = JobView::Orbit{0, 91, {}}}, "between -90 and 90 degrees");
  expect({.orbit = JobView::Orbit{0, 0, 0}}, "a distance must be above 0");
  expect({.orbit = JobView::Orbit{0, 0, infinity}}, "a distance must be above 0");
}
