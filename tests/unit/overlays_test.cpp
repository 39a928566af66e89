#include "view/overlays.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "lichtraum/esdf.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "view/display_pixels.hpp"

using namespace lichtraum;
using namespace lichtraum::view;

namespace {

constexpr int side = 96;

/// A ball of radius 1 at the origin, and a box beside it on the level of -1; a camera before them, a bit above.
struct Picture {
  Scene scene = load_scene();
  RenderRequest request;
  Film film;
  Bounds bounds{{-1, -1, -1}, {3, 1, 1}};

  static Scene load_scene() {
    return std::move(EsdfScript::from_text("define material m 1 1 1 1 1 1 0 0 0 1\n"
                                           "define shape sphere ball 0 0 0 1 m\n"
                                           "define shape box block 1.5 -1 -1 3 0.5 1 m\n"
                                           "define camera eye 50\n"
                                           "transform eye rotate -15 1 0 0\n"
                                           "transform eye translate 0 2 8\n",
                                           "overlays"))
        .take_scene();
  }

  explicit Picture(Overlays const& overlays) {
    request.camera = *scene.cameras.begin();
    request.resolution = {side, side};
    request.region = whole_picture(request.resolution);
    request.planes = overlays.planes();
    auto const renderer = make_reference_renderer();
    renderer->set_scene(scene);
    renderer->render(request, film);
  }

  std::vector<unsigned char> drawn(Overlays const& overlays, unsigned char grey) const {
    std::vector<unsigned char> pixels(4 * side * side, grey);
    OverlayLayer(overlays, film, request.camera, bounds).draw_on(pixels);
    return pixels;
  }
};

std::array<int, 3> at(std::vector<unsigned char> const& pixels, int x, int y) {
  std::size_t const i = 4 * (std::size_t(y) * side + std::size_t(x));
  return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

/// The pixel that a point is seen in.
std::pair<int, int> pixel_of(Picture const& picture, Vec3 const& point) {
  std::pair<int, int> best;
  double nearest = 1e9;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      Ray const ray = picture.request.camera.generate_ray(x + 0.5, y + 0.5, {side, side});
      double const distance = glm::length(glm::cross(point - ray.origin, ray.direction));
      if (distance < nearest) best = {x, y};
      nearest = std::min(nearest, distance);
    }
  }
  return best;
}

}  // namespace

TEST_CASE("without overlays a picture stays as it is", "[unit][view]") {
  Overlays const none;
  CHECK(none.planes().is_empty());
  std::vector<unsigned char> pixels(4 * side * side, 77);
  auto const before = pixels;
  OverlayLayer().draw_on(pixels);
  CHECK(pixels == before);
}

TEST_CASE("axes begin at the origin, in their colours, and hide behind what is before them", "[unit][view]") {
  Overlays overlays;
  overlays.axes = true;
  Picture const picture(overlays);
  auto const pixels = picture.drawn(overlays, 0);
  auto const color_at = [&](Vec3 const& point) {
    auto const [x, y] = pixel_of(picture, point);
    return at(pixels, x, y);
  };
  auto const up = color_at({0, 1.5, 0}), forth = color_at({0, 0, 2});
  CHECK((up[1] > 100 && up[1] > up[0] && up[1] > up[2]));
  CHECK((forth[2] > 100 && forth[2] > forth[0] && forth[2] > forth[1]));
  auto const right = color_at({1.25, 0, 0});  // between ball and box
  CHECK((right[0] > 100 && right[0] > right[1] && right[0] > right[2]));
  CHECK(color_at({0, 0.5, 0}) == std::array{0, 0, 0});   // within the ball
  CHECK(color_at({2.2, 0, 0}) == std::array{0, 0, 0});   // within the box
  CHECK(color_at({-1.5, 0, 0}) == std::array{0, 0, 0});  // it goes one way only
}

TEST_CASE("the grid lies on the lowest level, dark on light and light on dark", "[unit][view]") {
  Overlays overlays;
  overlays.grid = true;
  Picture const picture(overlays);
  auto const dark = picture.drawn(overlays, 0), light = picture.drawn(overlays, 255);
  auto const on = [&](std::vector<unsigned char> const& pixels, Vec3 const& point) {
    auto const [x, y] = pixel_of(picture, point);
    return at(pixels, x, y)[0];
  };
  // The bounds' diagonal is 4.9, so that lines are 1 apart.
  CHECK(on(dark, {-2, -1, 2.5}) > 40);
  CHECK(on(light, {-2, -1, 2.5}) < 215);
  CHECK(on(dark, {-1.5, -1, 2.5}) == 0);
  CHECK(on(dark, {-1.5, -1, 3}) > 40);
  CHECK(on(dark, {0, -1, -3}) == 0);  // behind the ball
}

TEST_CASE("the grid is level with what is called up", "[unit][view]") {
  Overlays overlays;
  overlays.grid = true;
  overlays.up = {0, 0, 3};  // it stands behind everything
  Picture const picture(overlays);
  auto const pixels = picture.drawn(overlays, 0);
  auto const on = [&](Vec3 const& point) {
    auto const [x, y] = pixel_of(picture, point);
    return at(pixels, x, y)[0];
  };
  CHECK(on({-2, 1.5, -1}) > 40);
  CHECK(on({-1.5, 1.5, -1}) == 0);
  CHECK(on({-1.5, 2, -1}) > 40);
  CHECK(on({0, 0, -1}) == 0);  // behind the ball
}

TEST_CASE("edges are where objects end, and where their surfaces turn", "[unit][view]") {
  Overlays overlays;
  overlays.edges = true;
  Picture const picture(overlays);
  auto const pixels = picture.drawn(overlays, 255);
  auto const is_dark_near = [&](Vec3 const& point) {
    auto const [x, y] = pixel_of(picture, point);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (at(pixels, x + dx, y + dy)[0] < 100) return true;
      }
    }
    return false;
  };
  CHECK(is_dark_near({1.5, -0.5, 1}));        // the box's edge towards the ball
  CHECK(is_dark_near({2.2, 0.5, 1}));         // between its front and its top
  CHECK_FALSE(is_dark_near({2.2, -0.2, 1}));  // within its front
  CHECK_FALSE(is_dark_near({2.2, 0.5, 0.2}));
  CHECK_FALSE(is_dark_near({0, 0, 1}));  // the ball is smooth
  CHECK_FALSE(is_dark_near({-3, 0, 0}));
}
