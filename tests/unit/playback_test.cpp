#include "view/playback.hpp"

#include "support/catch.hpp"

using namespace lichtraum::view;

TEST_CASE("an animation plays round and round, from where it was paused", "[unit][view]") {
  Playback playback(2, 0.5);
  CHECK_FALSE(playback.advance(100));
  CHECK(playback.time() == 0.5);
  playback.play(100);
  CHECK(playback.advance(101));
  CHECK(playback.time() == Approx(1.5));
  CHECK(playback.advance(102));
  CHECK(playback.time() == Approx(0.5));
  playback.pause();
  CHECK_FALSE(playback.advance(103));
  CHECK(playback.time() == Approx(0.5));
  playback.play(110);
  playback.advance(110.25);
  CHECK(playback.time() == Approx(0.75));
}

TEST_CASE("an animation that is at its end plays from its start", "[unit][view]") {
  Playback playback(2, 7);
  CHECK(playback.time() == 2);
  playback.play(50);
  playback.advance(50.5);
  CHECK(playback.time() == Approx(0.5));
}

TEST_CASE("frames are stepped through one by one, beyond either end to the other", "[unit][view]") {
  Playback playback(1, 0);
  playback.play(0);
  playback.step(1, 4);
  CHECK_FALSE(playback.is_playing());
  CHECK(playback.time() == 0.25);
  for (int i = 0; i < 3; ++i) playback.step(1, 4);
  CHECK(playback.time() == 1);
  playback.step(1, 4);
  CHECK(playback.time() == 0);
  playback.step(-1, 4);
  CHECK(playback.time() == 1);
  playback.go_to(0.3);  // between two frames
  playback.step(-1, 4);
  CHECK(playback.time() == 0);
  Playback uneven(0.9, 0);  // ends between two frames
  uneven.step(-1, 4);
  CHECK(uneven.time() == 0.75);
}

TEST_CASE("an animation of no length stands still", "[unit][view]") {
  Playback playback;
  playback.play(3);
  CHECK_FALSE(playback.advance(4));
  playback.step(1, 25);
  CHECK(playback.time() == 0);
}

TEST_CASE("a model is at rest until its animation is played, or goes somewhere", "[unit][view]") {
  Playback const untouched(2, std::nullopt);
  CHECK_FALSE(untouched.has_begun());
  CHECK(untouched.time() == 0);
  CHECK(Playback(2, 0).has_begun());
  Playback playback = untouched;
  playback.advance(1);
  CHECK_FALSE(playback.has_begun());
  playback.go_to(0);
  CHECK(playback.has_begun());
  playback = untouched;
  playback.play(1);
  CHECK(playback.has_begun());
}
