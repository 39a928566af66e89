#include "view/refinement.hpp"

#include <vector>

#include "support/catch.hpp"
#include "view/display_pixels.hpp"

using namespace lichtraum;
using namespace lichtraum::view;

TEST_CASE("a view is refined from coarse to smooth", "[unit][view]") {
  RenderRequest view;
  view.resolution = {101, 50};
  Refinement refinement;
  for (int const first_side : {8, 5, 1}) {
    refinement.restart(first_side, {Sampling::Pattern::seeded, 100});
    double last_work = 0;
    std::vector<int> counts;
    while (auto const pass = refinement.next()) {
      RenderRequest const request = Refinement::request(view, *pass);
      double const work = double(request.resolution.width) * request.resolution.height * request.sampling.count;
      CHECK(pass->is_first == (last_work == 0));
      if (pass->is_first) {
        CHECK(pass->pixel_side == first_side);
        CHECK(request.resolution == Resolution{(100 + first_side) / first_side, (49 + first_side) / first_side});
      }
      CHECK(work > last_work);
      CHECK(request.region.width == request.resolution.width);
      last_work = work;
      if (pass->pixel_side == 1) counts.push_back(pass->sampling.count);
    }
    CHECK(counts == std::vector{1, 2, 4, 8, 16, 32, 64, 100});
  }
}

TEST_CASE("a grid of samples comes all at once, one sample is the end", "[unit][view]") {
  Refinement refinement;
  refinement.restart(1, {Sampling::Pattern::grid, 16});
  CHECK(refinement.next()->sampling.count == 1);
  auto const last = refinement.next();
  CHECK(last->sampling.count == 16);
  CHECK(last->sampling.pattern == Sampling::Pattern::grid);
  CHECK(!refinement.next());
  refinement.restart(2, {Sampling::Pattern::grid, 1});
  CHECK(refinement.next()->pixel_side == 2);
  CHECK(refinement.next()->pixel_side == 1);
  CHECK(!refinement.next());
}

TEST_CASE("the first pass of a moved view takes the time it has", "[unit][view]") {
  Resolution const view{1000, 500};
  CHECK(Refinement::first_side_for(view, 1e-9, 0.02) == 1);
  CHECK(Refinement::first_side_for(view, 1e-7, 0.02) == 2);  // all pixels: 50 ms; a quarter of them: 12.5
  CHECK(Refinement::first_side_for(view, 1e-6, 0.02) == 5);
  CHECK(Refinement::first_side_for(view, 1, 0.02) == Refinement::coarsest_side);
}

TEST_CASE("what a screen cannot show is clamped", "[unit][view]") {
  Image image({2, 1});
  image.data() = {0, 0.5f, 1, -1, 2, std::nanf("")};
  CHECK(display_pixels(image) == std::vector<unsigned char>{0, 128, 255, 255, 0, 255, 0, 255});
}
