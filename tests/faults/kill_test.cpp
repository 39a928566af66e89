#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include "faults/faults.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

// SIGKILL, as from the system where memory is short, at moments that chance chooses: nothing is lost but the picture at
// hand, and the same command goes on to the same bytes. LICHTRAUM_KILLS=1000 takes that many moments, and
// LICHTRAUM_SEED other ones.

namespace {

namespace fs = std::filesystem;

int setting(char const* name, int usual) {
  char const* const value = std::getenv(name);
  return value ? std::atoi(value) : usual;
}

/// What a killed program leaves, and the next one does not mind: temporary files, whose names begin with a dot.
bool is_leftover(std::string const& name) { return fs::path(name).filename().string().starts_with("."); }

/// Also where the ffmpeg of a program that was killed has not ended yet, and makes a file meanwhile.
void remove_folder(fs::path const& folder) {
  std::error_code error;
  for (int i = 0; i < 200 && fs::remove_all(folder, error) == std::uintmax_t(-1); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (error) throw fs::filesystem_error("cannot remove", folder, error);
}

/// Runs the task until it is killed, again and again, each time a little further at most. Checks that every file is
/// there as it was or as it is to be; then that the task ends well, with the files that it has where nobody kills it.
void check_kills(Task const& task, Files const& before, int kills, unsigned seed) {
  Lichtraum const whole, killed;
  for (Lichtraum const* one : {&whole, &killed}) write_files(one->folder.path(), before);
  auto const result = whole(task.words);
  INFO(task.words << ": " << result.err);
  REQUIRE(result.exit_code == 0);
  Files const wanted = files_in(whole.folder.path());
  std::mt19937 chance(seed);
  std::uniform_real_distribution<double> moment(0, 1.1);  // of the time that it takes, which changes with other work
  double seconds = result.seconds;
  int hits = 0;
  bool begins_anew = true;
  for (int i = 0; i < kills; ++i) {
    Process process = killed.process(task.words);
    process.signals = {{SIGKILL, seconds * moment(chance)}};
    auto const end = run_process(process);
    INFO("seed " << seed << ", kill " << i << ": " << end.err);
    CHECK((end.signal == SIGKILL || end.exit_code == 0));
    hits += end.signal == SIGKILL;
    for (auto const& [name, bytes] : files_in(killed.folder.path())) {
      if (is_leftover(name)) continue;
      bool const is_old = before.contains(name) && before.at(name) == bytes;
      bool const is_new = wanted.contains(name) && wanted.at(name) == bytes;
      INFO(name << " has " << bytes.size() << " bytes");
      CHECK((is_old || is_new));
    }
    bool const is_done = end.exit_code == 0;
    if (is_done && begins_anew) seconds = end.seconds;
    begins_anew = is_done;
    if (is_done) {
      remove_folder(killed.folder.path());
      fs::create_directory(killed.folder.path());
      write_files(killed.folder.path(), before);
    }
  }
  CHECK(hits > kills / 4);
  auto const last = killed(task.words);
  INFO(last.err);
  CHECK(last.exit_code == 0);
  Files files = files_in(killed.folder.path());
  std::erase_if(files, [](auto const& file) { return is_leftover(file.first); });
  CHECK(files == wanted);
}

int kills() { return setting("LICHTRAUM_KILLS", 20); }
unsigned seed() { return unsigned(setting("LICHTRAUM_SEED", 1)); }

}  // namespace

TEST_CASE("a sequence that is killed keeps its whole pictures, and is resumed to the same bytes", "[faults][kill]") {
  Task const task = sequence_task("--device reference -q --resume --size 160x120 --turntable 5");
  check_kills(task, task.files, kills(), seed());
}

TEST_CASE("a film that is killed leaves the old one, and is drawn again to the same bytes", "[faults][kill]") {
  if (!is_installed("ffmpeg")) SKIP_TEST("ffmpeg is not installed");
  Task task = film_task("--device reference -q");
  task.files["a.mp4"] = "old";
  check_kills(task, task.files, kills(), seed());
}

TEST_CASE("a unit of a job that is killed is drawn again to the same bytes", "[faults][kill]") {
  Lichtraum const planner;
  write_files(planner.folder.path(), plan_task().files);
  REQUIRE(planner("job plan a.sdf -o shared --size 64x48 --tile 8x8 --device reference -q").exit_code == 0);
  Files before = files_in(planner.folder.path());
  // The plan names the scene by its whole path, which stays there.
  check_kills({"job work shared -q --device reference", {}}, before, kills(), seed());
}
