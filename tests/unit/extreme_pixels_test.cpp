#include "app/extreme_pixels.hpp"

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

Development const plain;

/// A row of so many pixels, and half as many again that are black.
Image row(int count, Rgb const& color) {
  Image image({count + count / 2, 1});
  for (int x = 0; x < count; ++x) {
    for (int c = 0; c < 3; ++c) image.pixel(x, 0)[c] = float(color[c]);
  }
  return image;
}

double share_of(Rgb const& color, Development const& development = plain) {
  app::ExtremePixels pixels;
  pixels.add(row(200, color), development);
  return pixels.white_share(1, Rgb(0), development);
}

}  // namespace

TEST_CASE("white is what all channels are too bright for", "[unit][extreme_pixels]") {
  CHECK(share_of(Rgb(1.01)) == Approx(2.0 / 3));
  CHECK(share_of(Rgb(1)) == 0);  // just what can be stored
  CHECK(share_of(Rgb(9, 9, 1)) == 0);
  Development mapped;
  mapped.tone_map = ToneMap::agx;
  CHECK(share_of(Rgb(1), mapped) == Approx(2.0 / 3));
  CHECK(share_of(Rgb(0.99), mapped) == 0);
}

TEST_CASE("the share of white is that of the pixels that show the scene", "[unit][extreme_pixels]") {
  app::ExtremePixels pixels;
  CHECK(pixels.white_share(0, Rgb(0), plain) == 0);
  pixels.add(row(100, Rgb(2)), plain);
  pixels.add(row(0, Rgb(2)), plain);
  pixels.add(row(100, Rgb(0.5)), plain);  // 100 of 300 are white
  CHECK(pixels.white_share(1, Rgb(0), plain) == Approx(1.0 / 3));
  CHECK(pixels.white_share(0.5, Rgb(0), plain) == Approx(2.0 / 3));
  CHECK(pixels.white_share(0.1, Rgb(0), plain) == 1);
  CHECK(pixels.white_share(0.005, Rgb(0), plain) == 0);
  CHECK(pixels.white_share(0.5, Background::environment(), plain) == Approx(1.0 / 3));
}

TEST_CASE("a white background is none of what shows the scene", "[unit][extreme_pixels]") {
  app::ExtremePixels pixels;
  pixels.add(row(200, Rgb(2)), plain);  // 200 of 300
  CHECK(pixels.white_share(1.0 / 3, Rgb(2), plain) == Approx(0).margin(1e-12));
  CHECK(pixels.white_share(1.0 / 3, Background(Rgb(0), Rgb(2)), plain) == Approx(0).margin(1e-12));
  CHECK(pixels.white_share(2.0 / 3, Rgb(2), plain) == Approx(0.5));
  CHECK(pixels.white_share(2.0 / 3, Rgb(1), plain) == 1);  // stored as it is, so not counted
  Development darker;
  darker.exposure_ev = -2;
  CHECK(pixels.white_share(2.0 / 3, Rgb(2), darker) == 1);
}

TEST_CASE("black is what nobody sees, and the share of it is that of the pixels that show the scene",
          "[unit][extreme_pixels]") {
  app::ExtremePixels pixels;
  pixels.add(row(200, Rgb(0.005, 0.5, 0.005)), plain);  // 100 of 300
  CHECK(pixels.black_share(1, Rgb(1), plain) == Approx(1.0 / 3));
  CHECK(pixels.black_share(0.5, Rgb(1), plain) == Approx(2.0 / 3));
  CHECK(pixels.black_share(1, Background::environment(), plain) == Approx(1.0 / 3));
  CHECK(pixels.black_share(2.0 / 3, Rgb(0), plain) == Approx(0).margin(1e-12));  // all that is black is background
  app::ExtremePixels dim;
  dim.add(row(200, Rgb(0.009)), plain);
  CHECK(dim.black_share(1, Rgb(1), plain) == 1);
  app::ExtremePixels grey;
  grey.add(row(200, Rgb(0.0099)), plain);  // 2.5 of 255 is 0.0098
  CHECK(grey.black_share(1, Rgb(1), plain) == Approx(1.0 / 3));
}
