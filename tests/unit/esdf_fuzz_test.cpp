#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"

// Damaged scenes: whatever the damage, the result is a scene or a SceneError with at least one error in it.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::string const sample =
    "# a scene with every statement\n"
    "define material red 1 0 0 1 0 0 1 0 0 10\n"
    "define material glass 0 0 0 .1 .1 .1 1 1 1 50 reflect=.1 transmit=.8 ior=1.5\n"
    "define material old 1 0 0 1 0 0 1 0 0 10 .5 1.5\n"
    "define shape sphere s 0 0 -10 1 red\n"
    "define shape box b -1 -1 -1 1 1 1 glass\r\n"
    "define shape triangle t 0 0 0 1 0 0 0 1 0 red\n"
    "define shape composite c s b t s\n"
    "define shape composite root c\n"
    "define light sun 0 10 0 .1 .1 .1 .9 .9 .9\n"
    "define light ambient a .1 .1 .1\n"
    "define light diffuse d 0 10 0 1 1 1\n"
    "define light l 0 10 0 1 1 1 10\n"
    "ambient .1 .1 .1\n"
    "define camera eye 45 0 0 0 0 0 -1 0 1 0\n"
    "camera eve 45 640 480\n"
    "transform c rotate 45 0 1 0\n"
    "transform c rotate 45 y\n"
    "transform c scale 1 2 3\n"
    "transform eye translate 0 0 1e2\n"
    "define background .1 .1 .1\n"
    "define filename out.png\n"
    "define resolution 16 16\n"
    "render eye a.ppm 640 480 4 2\n"
    "render eve image . ppm\n";

// Damaged before anything else happens to it.
std::string const faulty =
    "define shape mesh m model.glb red\n"
    "define shape composite c c nobody\n"
    "define camera eye 45\n"
    "{{x}} <<<<<<< \xC3\xBC\n";

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string damaged(std::string text) {
    for (std::size_t n = 1 + below(6); n > 0 && !text.empty(); --n) damage(text);
    return text;
  }
  bool coin() { return below(2) == 0; }

 private:
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }

  void damage(std::string& text) {
    std::size_t const at = below(text.size());
    std::size_t const length = 1 + below(below(4) == 0 ? 200 : 4);
    static std::vector<std::string> const pieces = {"#",     "\r",          std::string(1, '\0'),
                                                    "\xFF",  "=",           "//",
                                                    "\n",    " ",           "1e39",
                                                    "-",     "nan",         "0",
                                                    "{{a}}", "define ",     "composite ",
                                                    "red",   "\n=======\n", "\xEF\xBB\xBF",
                                                    "\t",    "f",           ",",
                                                    "1e-400"};
    switch (below(6)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text[at] = static_cast<char>(below(256));
        break;
      case 3:
        std::swap(text[at], text[below(text.size())]);
        break;
      case 4:
        text.insert(at, pieces[below(pieces.size())]);
        break;
      default: {  // a line to another place
        std::size_t const begin = text.rfind('\n', at) + 1;
        std::string const line = text.substr(begin, text.find('\n', begin) - begin) + "\n";
        std::size_t const to = text.find('\n', below(text.size()));
        text.insert(to == std::string::npos ? text.size() : to + 1, line);
      }
    }
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("damaged scenes end in a scene or in a SceneError", "[unit][esdf][hostile]") {
  Mutator mutator(2015);
  int loaded = 0;
  for (int i = 0; i < 20'000; ++i) {
    EsdfOptions options;
    options.strict = i % 7 == 0;
    options.keep_going = mutator.coin();
    if (mutator.coin()) options.transform_order = TransformOrder::local;
    if (mutator.coin()) options.material_extras = {MaterialExtra::opacity, MaterialExtra::ior};
    std::string const text = mutator.damaged(mutator.coin() ? sample : faulty + sample);
    try {
      EsdfScript const script = EsdfScript::from_text(text, "s.sdf", options);
      ++loaded;
      std::size_t frames = 0;
      script.play([&](Scene const& scene, RenderCommand const& command) {
        ++frames;
        return scene.cameras.contains(command.camera);
      });
      if (frames != script.scene().renders.size()) FAIL(text);
      for (Diagnostic const& diagnostic : script.diagnostics()) {
        if (format_diagnostic(diagnostic).empty() || diagnostic.severity == Severity::error) FAIL(text);
      }
    } catch (SceneError const& error) {
      if (count_errors(error.diagnostics()) == 0 || std::string(error.what()).empty()) FAIL(text);
    }
  }
  CHECK(loaded > 5'000);  // else nearly nothing gets past the first check
}
