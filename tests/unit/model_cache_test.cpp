#include <algorithm>
#include <thread>

#include "io/model_cache.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/obj.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "view/file_watch.hpp"
#include "view/worker.hpp"

using namespace lichtraum;

namespace {

constexpr char const* painted_triangle = "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n";
constexpr char const* scene_text =
    "define material red 1 0 0 1 0 0 0 0 0 1\n"
    "define shape mesh plain model.obj\n"
    "define shape mesh painted model.obj red\n"
    "define camera eye 45 64 48\n"
    "render eye a.png\n"
    "transform plain translate 1 0 0\n"
    "render eye b.png\n";

struct Folder : TemporaryFolder {
  Folder() {
    write("model.obj", painted_triangle);
    write("paint.mtl", "newmtl paint\nKd 0 1 0\nmap_Kd missing.png\n");
    write("scene.sdf", scene_text);
  }
  std::string scene_file() const { return *this / "scene.sdf"; }
};

Mesh const& model_mesh(Scene const& scene, char const* name) {
  auto const& model = dynamic_cast<Composite const&>(**scene.shapes.find(name));
  auto const& file = dynamic_cast<Composite const&>(*model.children().at(0));
  return dynamic_cast<Mesh const&>(*file.children().at(0));
}

}  // namespace

TEST_CASE("a model that several scenes include is read once, until it changes", "[unit][esdf][watch]") {
  Folder const folder;
  EsdfOptions options;
  options.models = make_model_cache();
  std::vector<std::string> files;
  options.on_read = [&](std::filesystem::path const& file) { files.push_back(file.filename().string()); };
  EsdfScript const first = EsdfScript::from_file(folder.scene_file(), options);
  // Every file is told of, also those of a model that is there already, and one that is missing.
  for (char const* const name : {"scene.sdf", "model.obj", "paint.mtl", "missing.png"}) {
    INFO(name);
    CHECK(std::count(files.begin(), files.end(), name) >= 1);
  }
  auto const geometry = model_mesh(first.scene(), "plain").geometry();
  CHECK(model_mesh(first.scene(), "plain").material()->name() == "paint");
  CHECK(model_mesh(first.scene(), "painted").material()->name() == "red");

  files.clear();
  EsdfScript const again = EsdfScript::from_file(folder.scene_file(), options);
  CHECK(std::count(files.begin(), files.end(), "paint.mtl") >= 1);
  CHECK(model_mesh(again.scene(), "plain").geometry() == geometry);
  // Its nodes are its own: what a script moves does not move in another one.
  CHECK(&model_mesh(again.scene(), "plain") != &model_mesh(first.scene(), "plain"));
  // A material that replaces the model's is the script's own.
  CHECK(model_mesh(again.scene(), "painted").material() == *again.scene().materials.find("red"));

  folder.write("paint.mtl", "newmtl paint\nKd 0 0 1\nKa 1 1 1\n");
  EsdfScript const changed = EsdfScript::from_file(folder.scene_file(), options);
  CHECK(model_mesh(changed.scene(), "plain").geometry() != geometry);
  CHECK(model_mesh(changed.scene(), "plain").material()->kd().z > 0.5);
}

TEST_CASE("a script that is played again does not read its models again", "[unit][esdf][watch]") {
  Folder const folder;
  EsdfScript const script = EsdfScript::from_file(folder.scene_file());
  auto const geometry = model_mesh(script.scene(), "plain").geometry();
  std::vector<double> places;
  script.play([&](Scene const& played, RenderCommand const&) {
    CHECK(model_mesh(played, "plain").geometry() == geometry);
    places.push_back((*played.shapes.find("plain"))->world_from_object().point(Vec3(0)).x);
    return true;
  });
  CHECK(places == std::vector<double>{0, 1});
}

TEST_CASE("models that no script includes any more are forgotten", "[unit][esdf][watch]") {
  Folder const folder;
  EsdfOptions options;
  options.models = make_model_cache();
  std::weak_ptr<MeshGeometry const> geometry;
  {
    EsdfScript const script = EsdfScript::from_file(folder.scene_file(), options);
    geometry = model_mesh(script.scene(), "plain").geometry();
  }
  EsdfScript::from_text("define camera eye 45\n", "next", options);
  CHECK(!geometry.expired());
  EsdfScript::from_text("define camera eye 45\n", "the one after", options);
  CHECK(geometry.expired());
}

TEST_CASE("a watch notices what was written, and what appears", "[unit][view][watch]") {
  Folder const folder;
  view::FileWatch watch;
  watch.add(folder / "paint.mtl");
  watch.add(folder / "missing.png");
  CHECK(!watch.has_changed());
  folder.write("paint.mtl", "longer than before, whatever the clock says: newmtl paint\n");
  CHECK(watch.has_changed());
  watch = {};
  watch.add(folder / "paint.mtl");
  watch.add(folder / "missing.png");
  std::filesystem::remove(folder / "paint.mtl");
  CHECK(!watch.has_changed());
  folder.write("missing.png", "here");
  CHECK(watch.has_changed());
}

TEST_CASE("a window that watches reads a scene again when a model's material changes", "[unit][view][watch]") {
  Folder const folder;
  app::SceneSource const source(folder.scene_file());
  app::RenderOptions options;
  options.device = "reference";
  app::Console const console;
  view::Worker worker(source, options, true, console, [] {});
  auto const comes = [&](auto const& what) {
    for (int i = 0; i < 2000; ++i) {
      if (what(worker.news())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  REQUIRE(comes([](view::Worker::News const& news) { return news.scene.has_value(); }));
  folder.write("paint.mtl", "newmtl paint\nKd 0 0 1\nKa 1 1 1\n");
  CHECK(comes([](view::Worker::News const& news) { return news.scene.has_value(); }));
  folder.write("scene.sdf", "nonsense");
  CHECK(comes([](view::Worker::News const& news) { return news.problem && !news.problem->empty(); }));
}
