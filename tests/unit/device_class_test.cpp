#ifdef __SSE2__
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include "app/device_class.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;

TEST_CASE("a device that takes denormal numbers for 0 is of another class", "[unit][farm][pictures]") {
  auto const renderer = make_reference_renderer();
  std::string const hash = app::device_class_of(*renderer, "").hash;
  CHECK(app::device_class_of(*renderer, "").hash == hash);
  CHECK(app::device_class_of(*renderer, "wide").hash != hash);
#ifdef __SSE2__
  unsigned const before = _mm_getcsr();  // threads that are started from here take it over
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  std::string const flushing = app::device_class_of(*renderer, "").hash;
  _mm_setcsr(before);
  CHECK(flushing != hash);
#else
  SKIP_TEST("this test switches denormal numbers off on x86 only");
#endif
}
