#include "view/worker.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>

#include "support/catch.hpp"
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

app::RenderOptions on_reference_tracer() {
  app::RenderOptions options;
  options.device = "reference";
  return options;
}

/// A Worker as a window has it.
class Work {
 public:
  explicit Work(std::filesystem::path const& file, bool is_watching = false)
      : worker_(app::SceneSource(file), options_, is_watching, console_, [this] {
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
  app::RenderOptions const options_ = on_reference_tracer();
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
