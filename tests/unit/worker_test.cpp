#include "view/worker.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/gltf_writer.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using view::Worker;

namespace {

/// A ball in the middle of 8x8 pixels.
std::string const scene =
    "define material red 0 0 0  0.8 0.1 0.1  0 0 0  1\n"
    "define shape sphere ball 0 0 -5  2 red\n"
    "define light diffuse lamp 3 4 6  1 1 1\n";
std::string const camera = "define camera eye 50 8 8\n";

/// A triangle with two animations.
std::string moving_model() {
  testing::GltfWriter writer;
  writer.add_mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0});
  int const times = writer.add_accessor<float>("SCALAR", 1, {0, 2});
  for (float const way : {1.0f, 2.0f}) {
    int const places = writer.add_vec3({0, 0, 0, way, 0, 0});
    writer.json["animations"].push_back(
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", times}, {"output", places}}}}});
  }
  return writer.text();
}

app::RenderOptions on_reference_tracer(Job const& job) {
  app::RenderOptions options;
  options.device = "reference";
  options.job = job;
  return options;
}

/// A Worker as a window has it.
class Work {
 public:
  explicit Work(std::filesystem::path const& file, bool is_watching = false, Job const& job = {})
      : options_(on_reference_tracer(job)), worker_(app::SceneSource(file), options_, is_watching, console_, [this] {
          std::lock_guard const lock(mutex_);
          has_news_ = true;
          woken_.notify_all();
        }) {}

  Worker* operator->() { return &worker_; }

  /// The next news in which `member` is what counts; what comes before is passed over.
  template <class Member>
  Member await(std::optional<Member> Worker::News::*member) {
    auto const end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    for (;;) {
      Worker::News news = worker_.news();
      if (news.*member) return std::move(*(news.*member));
      std::unique_lock lock(mutex_);
      if (!woken_.wait_until(lock, end, [&] { return has_news_; })) throw std::runtime_error("waited in vain");
      has_news_ = false;
    }
  }

  /// The scene that is asked next, and whether something is where the ball is.
  view::Look look_at_ball() {
    worker_.look_at(4, 4);
    return await(&Worker::News::look);
  }

 private:
  app::RenderOptions const options_;
  app::Console const console_ = [] {
    app::Console silent;
    silent.set_verbosity(app::Verbosity::silent);
    return silent;
  }();
  std::mutex mutex_;
  std::condition_variable woken_;
  bool has_news_ = false;
  Worker worker_;
};

float red_in_middle(view::Frame const& frame) {
  return frame.image.pixel(frame.image.width() / 2, frame.image.height() / 2)[0];
}

}  // namespace

TEST_CASE("what is shown stays as it is when another file cannot be drawn", "[unit][view]") {
  TemporaryFolder const folder;
  Work work(folder.write("good.sdf", scene + camera));
  view::SceneView const shown = work.await(&Worker::News::scene);
  work->open(folder.write("blind.sdf", scene));
  CHECK_THAT(work.await(&Worker::News::problem), contains_text("camera"));
  view::Look const look = work.look_at_ball();
  CHECK(look.scene_number == shown.number);
  CHECK(look.seen);
}

TEST_CASE("what is shown is still watched, and has its animations, when another file cannot be read", "[unit][view]") {
  TemporaryFolder const folder;
  folder.write("moving.gltf", moving_model());
  Work work(folder / "moving.gltf", true);
  view::SceneView const shown = work.await(&Worker::News::scene);
  work->open(folder.write("broken.sdf", "define nonsense\n"));
  CHECK_THAT(work.await(&Worker::News::problem), contains_text("nonsense"));
  work->choose_animation(shown.number, 1);
  view::SceneView const chosen = work.await(&Worker::News::scene);
  CHECK(chosen.file == shown.file);
  CHECK(chosen.loaded->contents()->animation == 1);

  work->open(folder / "broken.sdf");
  work.await(&Worker::News::problem);
  folder.write("moving.gltf", moving_model() + "\n");
  view::SceneView const saved = work.await(&Worker::News::scene);
  CHECK(saved.file == shown.file);
  CHECK(saved.loaded->contents()->animation == 1);
}

TEST_CASE("an exposure that was set while another scene was read is not that scene's", "[unit][view]") {
  TemporaryFolder const folder;
  Work work(folder.write("first.sdf", scene + camera));
  view::SceneView const first = work.await(&Worker::News::scene);
  work->open(folder.write("second.sdf", scene + camera));
  Development black = first.development;
  black.exposure_ev = -50;
  work->develop(first.number, black);
  work->show(work.await(&Worker::News::scene).request);
  CHECK(red_in_middle(work.await(&Worker::News::frame)) > 0.1f);
}

TEST_CASE("a scene that begins to shine is drawn by paths, as it will be from a file", "[unit][view]") {
  TemporaryFolder const folder;
  Work work(folder.write("scene.sdf", scene + camera));
  view::SceneView const shown = work.await(&Worker::News::scene);
  REQUIRE(shown.request.integrator == Integrator::whitted);
  Material const& red = **shown.loaded->scene().materials.begin();
  SceneEdits shining;
  shining.materials.emplace(&red, Material("red", PhongModel{.emission = Rgb(8)}));
  work->edit(shown.number, shining);
  view::EditedView const edited = work.await(&Worker::News::edited);
  CHECK(edited.scene_number == shown.number);
  CHECK(edited.request.integrator == Integrator::path);
  CHECK(edited.request.max_depth > shown.request.max_depth);
  work->edit(shown.number, {});
  CHECK(work.await(&Worker::News::edited).request.integrator == Integrator::whitted);
}

TEST_CASE("of a film, what its first picture shows is seen, not its end", "[unit][view]") {
  TemporaryFolder const folder;
  Work work(folder.write("film.sdf", scene + camera + "render eye 1.png\ntransform ball translate 9 0 0\n" +
                                         "define camera side 50 8 8\nrender side 2.png\n"));
  view::SceneView const shown = work.await(&Worker::News::scene);
  CHECK(shown.bounds.center() == Vec3(0, 0, -5));
  CHECK(shown.cameras.size() == 2);
  CHECK(work.look_at_ball().seen);
}

TEST_CASE("names of the first file's things are not looked for in others", "[unit][view]") {
  TemporaryFolder const folder;
  Job job;
  job.camera = "side";
  job.root = "ball";
  job.reading.model.animation = "1";
  auto const first = folder.write("first.sdf", scene + camera + "define camera side 50 4 4\n");
  Work work(first, false, job);
  CHECK(work.await(&Worker::News::scene).request.resolution == Resolution{4, 4});
  work->open(folder.write("second.sdf", camera + "define material red 0 0 0  0.8 0.1 0.1  0 0 0  1\n" +
                                            "define shape sphere moon 0 0 -5  2 red\n"));
  CHECK(work.await(&Worker::News::scene).request.resolution == Resolution{8, 8});
  folder.write("moving.gltf", moving_model());
  work->open(folder / "moving.gltf");
  CHECK(work.await(&Worker::News::scene).loaded->contents()->animation == 0);
  work->open(first);
  CHECK(work.await(&Worker::News::scene).request.resolution == Resolution{4, 4});
}

TEST_CASE("a picture tells which view it is of", "[unit][view]") {
  TemporaryFolder const folder;
  Work work(folder.write("scene.sdf", scene + camera));
  view::SceneView const shown = work.await(&Worker::News::scene);
  auto const number_of_next_fine_picture = [&] {
    for (;;) {
      view::Frame const frame = work.await(&Worker::News::frame);
      if (frame.pass.pixel_side == 1 && frame.pass.sampling.count > 1) return frame.view_number;
    }
  };
  unsigned const first = work->show(shown.request);
  CHECK(number_of_next_fine_picture() == first);
  unsigned const edited = work->edit(shown.number, {});
  CHECK(edited != first);
  view::Frame frame;
  do frame = work.await(&Worker::News::frame);
  while (frame.view_number == first);
  CHECK(frame.view_number == edited);
}
