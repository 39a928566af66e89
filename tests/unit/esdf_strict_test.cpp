#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

EsdfOptions const strict = [] {
  EsdfOptions options;
  options.strict = true;
  return options;
}();

std::string const base = red + eye + "define shape sphere s 0 0 0 1 red\n";

}  // namespace

TEST_CASE("strict mode accepts the standard and lichtraum's keys", "[unit][esdf]") {
  std::string const text =
      "// a comment\n"
      "define material red 1 0 0 1 0 0 1 0 0 10 # another\n"
      "define material glass 0 0 0 0 0 0 1 1 1 50 transmit=.9 ior=1.5 reflect=.1\n"
      "define shape sphere s 0 0 0 1 red\n"
      "define shape box b 0 0 0 1 1 1 glass\n"
      "define shape triangle t 0 0 0 1 0 0 0 1 0 red\n"
      "define shape composite c s b t s\n"
      "define light sun 0 10 0 .1 .1 .1 .9 .9 .9\n"
      "define light ambient a .1 .1 .1\n"
      "define light diffuse d 0 10 0 1 1 1\n"
      "define background .5 .5 1\n"
      "define backgroundcolor .5 .5 1\n"
      "define camera eye 45\n"
      "camera eve 45 640 480\n"
      "transform c rotate 45 0 1 0\n"
      "transform c translate 0 0 -10\n"
      "transform eye scale 2\n"
      "render eye a.ppm 640 480\n"
      "render eve b.ppm\n";
  CHECK(findings(text, strict).empty());
  CHECK(findings(text).empty());  // and nothing of it is a dialect
}

TEST_CASE("strict mode refuses every dialect, which is accepted otherwise", "[unit][esdf]") {
  for (std::string const line : {"transform s scale 1 2 3",
                                 "transform s rotate 45 x",
                                 "transform s rotate 10 20 30",
                                 "define transform s scale 2",
                                 "define light a 0 0 0 1 1 1 10",
                                 "define light a 0 0 0 1 1 1",
                                 "define light diffuse a 0 0 0 1 1 1 1 1 1",
                                 "define light environment a studio",
                                 "define light environment a 1 1 1 rotation=4 brightness=2",
                                 "define light ambient a 0 0 0 1 1 1 1 1 1",
                                 "define light ambient a 0 0 0 1 1 1",
                                 "define light ambient 0 0 0 1 1 1",
                                 "ambient 1 1 1",
                                 "ambient a 1 1 1",
                                 "define ambient 1 1 1",
                                 "define ambient a 1 1 1",
                                 "define ambient a 1 1 1 .5",
                                 "define ambient .5",
                                 "define camera a 45 0 0 0",
                                 "define camera a 45 0 0 0 0 0 -1",
                                 "define camera a 45 0 0 0 0 0 -1 0 1 0",
                                 "define camera a 45 640 480 0 0 0 0 0 -1",
                                 "define material a 1 0 0 1 0 0 1 0 0 10 emission 1 1 1",
                                 "define material a 1 0 0 1 0 0 1 0 0 10 1",
                                 "define material a 1 0 0 1 0 0 1 0 0 10 1 1 1 1",
                                 "render eye a.ppm 640 480 4",
                                 "define light diffuse lamp 0 0 0 1 1 1 radius=1",
                                 "define camera thick 45 aperture=0.1 focus=5",
                                 "define camera parallel 45 orthographic=5",
                                 "render eye a.ppm 640 480 integrator=path",
                                 "render eye a.ppm 640 480 samples=4",
                                 "render eye a.ppm 640 480 depth=4",
                                 "render eye a.ppm 640 480 4 5",
                                 "render eye image . ppm 640 480",
                                 "render someone a.ppm 640 480",
                                 "render a.ppm 640 480",
                                 "define render eye a.ppm 640 480",
                                 "define renderer eye a.ppm 640 480",
                                 "define filename a.ppm",
                                 "define resolution 640 480",
                                 "define shape cylinder r 0 0 0 0 1 0 1 red",
                                 "define shape cone r 0 0 0 0 1 0 1 red",
                                 "define shape plane r 0 0 0 0 1 0 red",
                                 "define shape sphere r 0 0 0 -1 red"}) {
    INFO(line);
    CHECK(loads(base + line + "\n"));
    auto const found = findings(base + line + "\n", strict);
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == Severity::error);
    CHECK(found[0].location.line == 4);
    CHECK(found[0].location.column > 0);
  }
}

TEST_CASE("what strict mode refuses once, it does not report again where it is used", "[unit][esdf]") {
  CHECK(findings("define camera eye 45 0 0 0 0 0 -1 0 1 0\nrender eye a.ppm 1 1\n", strict).size() == 1);
  CHECK(findings("define material a 1 0 0 1 0 0 1 0 0 10 1\ndefine shape sphere s 0 0 0 1 a\n", strict).size() == 1);
  auto const mesh = findings(base + "define shape mesh m there_is_none.obj\n", strict);
  REQUIRE(mesh.size() == 1);
  CHECK(mesh[0].code == DiagnosticCode::not_standard);
}

TEST_CASE("dialects are noted, for those who want to know", "[unit][esdf]") {
  auto const found = findings(base + "transform s scale 1 2 3\nambient 1 1 1\n");
  REQUIRE(found.size() == 2);
  CHECK(found[0].severity == Severity::note);
  CHECK(found[0].message == "a scale per axis is not part of the standard");
  CHECK(found[0].location.column == 19);
  CHECK(found[0].length == 5);
  CHECK(found[1].message == "'ambient' is not part of the standard");
}

TEST_CASE("strict mode says what would be done without it", "[unit][esdf]") {
  struct Case {
    std::string line;
    std::string message;
    std::string hint;
  };
  for (Case const& c : std::vector<Case>{
           {"define shape sphere t 0 0 0 -1 red", "is negative", "without --strict: its absolute value is taken"},
           {"render nobody a.ppm 1 1", "not defined", "without --strict: using the only one: 'eye'"},
           {"render eye my image.ppm 1 1", "spaces", "without --strict: taken as 'myimage.ppm'"},
           {"render eye a.ppm 1 1 4", "one more number", "without --strict: taken as samples per pixel"},
           {"define light ambient a 0 0 0 1 1 1", "ambient light has no position", "ambient light is written: "},
           {"define material a 1 0 0 1 0 0 1 0 0 10 1", "1 number after m", "without --strict: --material-extras says"},
           {"define shape teapot t 1", "teapot", "the shapes are triangle, sphere, box and composite"}}) {
    INFO(c.line);
    auto const found = findings(base + c.line + "\n", strict);
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, contains_text(c.message) && !contains_text("ignored") && !contains_text("count"));
    CHECK(found[0].hint.substr(0, c.hint.size()) == c.hint);
  }
}
