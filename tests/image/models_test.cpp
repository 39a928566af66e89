#include <sstream>

#include "lichtraum/model.hpp"
#include "support/catch.hpp"
#include "support/picture_check.hpp"
#include "support/project_files.hpp"
#include "support/skip.hpp"
#include "support/subprocess.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

// The models of docs/gallery: textures, vertex colours, masks, blends, instances, skins, morphs and spot lights.

namespace {

#ifdef LICHTRAUM_PYTHON
constexpr char const* python = LICHTRAUM_PYTHON;
#else
constexpr char const* python = nullptr;
#endif

std::string make_models(std::string const& words) {
  Process process{{python, project_path("tools/make_models")}};
  std::istringstream in(words);
  for (std::string word; in >> word;) process.arguments.push_back(word);
  process.timeout_seconds = 300;
  auto const result = run_process(process);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

/// Textures without smaller versions of them and edges of masks flicker at this size: a ray beside the other one may
/// see another texel.
constexpr double textured_share = 0.01;

}  // namespace

TEST_CASE("tools/make_models writes the same bytes each time", "[image][models]") {
  if (!python) SKIP_TEST("no python3");
  TemporaryFolder const a, b;
  make_models(a.path().string() + " gears fence");
  make_models(b.path().string() + " gears fence");
  REQUIRE(a.names() == std::vector<std::string>{"fence.glb", "gears.glb"});
  for (std::string const& name : a.names()) CHECK(a.read(name) == b.read(name));
}

TEST_CASE("the models of the gallery look alike on the device and in the reference renderer", "[image][models]") {
  if (!python) SKIP_TEST("no python3");
  REQUIRE_OPENCL_DEVICE();
  TemporaryFolder const folder;
  make_models(folder.path().string());
  std::istringstream names(make_models("--list"));
  std::size_t count = 0;
  for (std::string name; names >> name; ++count) {
    INFO(name);
    ModelOptions options;
    if (name == "tentacle" || name == "flag") options.time_seconds = 1.4;
    Model const model = import_model(folder / (name + ".glb"), options);
    for (auto const& diagnostic : model.diagnostics) UNSCOPED_INFO(diagnostic.message);
    CHECK(model.diagnostics.empty());
    RenderRequest const request = whole_picture(model.scene.cameras.front(), {64, 48});
    Image const expected = render_reference(model.scene, request);
    check_picture(render_on(opencl_devices().front(), model.scene, request), expected, "model_" + name, textured_share);
  }
  CHECK(count >= 12);
}
