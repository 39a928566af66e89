#include "app/test_scene.hpp"

#include "lichtraum/esdf.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* text = R"(
define material red    0.4 0.1 0.1  0.8 0.2 0.2  0.5 0.5 0.5  20
define material floor  0.2 0.2 0.2  0.7 0.7 0.7  0 0 0  1
define material mirror 0.1 0.1 0.1  0.2 0.2 0.2  0.8 0.8 0.8  80 reflect=0.7
define material glass  0 0 0  0.1 0.1 0.1  0.9 0.9 0.9  120 transmit=0.8 reflect=0.1 ior=1.5

define shape box ground -10 -1.2 -12  10 -1 2 floor
define shape sphere ball 0 0 0 0.6 red
define shape box cube -0.4 -0.4 -0.4  0.4 0.4 0.4 mirror
define shape triangle sail 0 0 0  1.2 0 0  0.6 1.5 0 red
define shape sphere lens 0.3 -0.4 -2.6 0.4 glass
transform cube rotate 30 1 1 0
transform cube scale 1 1.5 0.7
transform cube translate 1.3 -0.2 0

define shape composite pair ball cube
define shape composite left pair
define shape composite right pair
transform pair translate 0 0 -5
transform left translate -1.8 0 0
transform right rotate 20 0 1 0
transform right translate 0.5 0.3 -1.5
transform sail translate -0.4 0.2 -6

define light ambient sky 0.3 0.3 0.35
define light diffuse sun 4 6 2  0.7 0.7 0.6
define light diffuse lamp -5 3 -1  0.3 0.3 0.4
define background 0.1 0.15 0.25
define camera eye 50
)";

}  // namespace

TestScene make_test_scene() {
  TestScene test;
  test.scene = EsdfScript::from_text(text, "test scene").take_scene();
  test.request.camera = test.scene.cameras.front();
  test.request.resolution = {160, 120};
  test.request.region = whole_picture(test.request.resolution);
  return test;
}

}  // namespace lichtraum::app
