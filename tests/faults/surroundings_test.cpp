#include <sys/mount.h>
#include <unistd.h>

#include "faults/faults.hpp"
#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

// Where a process lives: what is missing, small or slow there ends it in order, or makes no difference.

namespace {

namespace fs = std::filesystem;

/// The first device that PoCL would be, else the reference.
std::string const any_device = lichtraum::find_devices().devices.size() > 1 ? "--device cpu" : "--device reference";

/// The program, run by a shell that first does `before`; in name spaces of its own where that needs root.
Process after(Lichtraum const& lichtraum, std::string const& before, std::string const& words) {
  Process process = lichtraum.process(words);
  std::vector<std::string> shell{"sh", "-c", before + " && exec \"$@\"", "sh"};
  if (before.find("mount") != std::string::npos) shell.insert(shell.begin(), {"unshare", "--mount"});
  process.arguments.insert(process.arguments.begin(), shell.begin(), shell.end());
  return process;
}

bool can_mount() {
  Process const process{{"unshare", "--mount", "mount", "-t", "tmpfs", "none", "/mnt"}};
  return run_process(process).exit_code == 0;
}

/// Checks that a picture has the same bytes there, without a word on standard error.
void check_makes_no_difference(std::string const& before, std::string const& device) {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  REQUIRE(lichtraum("render -q a.sdf -o usual.png " + device).exit_code == 0);
  auto const result = run_process(after(lichtraum, before, "render -q a.sdf -o a.png " + device));
  INFO(before << ", " << device << ": " << result.err);
  CHECK(result.signal == 0);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(lichtraum.folder.read("a.png") == lichtraum.folder.read("usual.png"));
  CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.png", "a.sdf", "usual.png"});
}

/// A folder of its own on a disk of so many kilobytes, while it exists.
class SmallDisk {
 public:
  SmallDisk(fs::path folder, int kilobytes) : folder_(std::move(folder)) {
    fs::create_directory(folder_);
    std::string const size = "size=" + std::to_string(kilobytes) + "k";
    is_there_ = ::mount("none", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  SmallDisk(SmallDisk const&) = delete;
  SmallDisk& operator=(SmallDisk const&) = delete;
  ~SmallDisk() {
    if (is_there_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  bool is_there() const { return is_there_; }

 private:
  fs::path folder_;
  bool is_there_ = false;
};

}  // namespace

TEST_CASE("no /proc, no /dev/shm, one processor, few files, no locale: the same picture", "[faults]") {
  std::vector<std::string> befores{"export LC_ALL=xx_YY", "taskset -p 1 $$ > /dev/null", "ulimit -n 16",
                                   "unset HOME PATH LANG TMPDIR"};
  if (can_mount()) {
    befores.push_back("mount -t tmpfs none /proc");
    befores.push_back("mount -t tmpfs -o ro none /dev/shm");
  }
  for (std::string const& before : befores) {
    check_makes_no_difference(before, "--device reference");
    check_makes_no_difference(before, any_device);
  }
}

TEST_CASE("small stacks are enough, or OpenCL is left out and that is said", "[faults]") {
  check_makes_no_difference("ulimit -s 64", "--device reference");
  // Most of 8 MiB is taken by a work-group of these.
  check_makes_no_difference("ulimit -s 512", any_device + " --depth 1000");
  if (any_device == "--device reference") SKIP_TEST("there is no OpenCL device");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const result = run_process(after(lichtraum, "ulimit -s 64", "render a.sdf -o a.png"));
  CHECK(result.exit_code == 0);
  // Drivers other than PoCL 3 may do with less.
  if (result.err.find("reference tracer") == std::string::npos) SKIP_TEST("this driver does with 64 KiB");
  CHECK_THAT(result.err, contains_text("stacks are limited to 64 KiB here: ulimit -s 8192"));
}

TEST_CASE("a folder that can only be read is found before anything is drawn", "[faults]") {
  if (!can_mount()) SKIP_TEST("only root can mount");
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  for (char const* const words : {"render a.sdf -o a.png", "render a.sdf -o a.mp4", "job plan a.sdf -o shared"}) {
    auto const result = run_process(after(lichtraum, "mount -o bind,ro . . && cd \"$PWD\"",
                                          words + std::string(" --size 4000x4000 --samples 64 --device reference")));
    INFO(words << ": " << result.err);
    CHECK(result.exit_code == 73);
    CHECK_THAT(result.err, contains_text("Read-only file system"));
    CHECK(result.seconds < 10);
    CHECK(lichtraum.folder.names() == std::vector<std::string>{"a.sdf"});
  }
}

TEST_CASE("on a disk that fills up, a sequence keeps its whole pictures", "[faults]") {
  Lichtraum const lichtraum;
  SmallDisk const disk(lichtraum.folder / "small", 100);
  if (!disk.is_there()) SKIP_TEST("only root can mount");
  lichtraum.folder.write("a.sdf", sequence_task("").files.at("a.sdf"));
  auto const full = lichtraum.render("a.sdf -o small/%d.ppm --size 120x90");  // each has 32,414 bytes
  INFO(full.err);
  CHECK(full.exit_code == 74);
  CHECK_THAT(full.err, contains_text("the disk is full"));
  Files const files = files_in(lichtraum.folder / "small");
  CHECK(!files.empty());
  CHECK(files.size() < 4);
  for (auto const& [name, bytes] : files) CHECK(bytes.size() == 32'414);
}

TEST_CASE("a slow reader gets the whole picture, and one that goes away ends it", "[faults]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  std::string const draw = "render a.sdf -q --device reference --size 300x200 -o ";  // 180,015 bytes; pipes hold 65,536
  REQUIRE(lichtraum(draw + "usual.ppm").exit_code == 0);
  Process process = lichtraum.process(draw + "- --format ppm");
  std::vector<std::string> const shell{"sh", "-c", "", "sh"};
  process.arguments.insert(process.arguments.begin(), shell.begin(), shell.end());
  process.arguments[2] = "{ \"$@\"; echo $? > status; } | { sleep 0.2; head -c 1000; sleep 0.2; cat; }";
  CHECK(run_process(process).out == lichtraum.folder.read("usual.ppm"));
  CHECK(lichtraum.folder.read("status") == "0\n");
  process.arguments[2] = "{ \"$@\"; echo $? > status; } | { sleep 0.2; head -c 70000; } > part";
  auto const gone = run_process(process);
  CHECK(lichtraum.folder.read("status") == "74\n");
  CHECK_THAT(gone.err, contains_text("the reader closed the pipe"));
}

TEST_CASE("the time of day is not asked for, so no clock that jumps matters", "[faults]") {
  for (Task const& task : {sequence_task("--device reference --json"), work_task(), merge_task()}) {
    CHECK(check_each_fault(task, "clock", 2).empty());
  }
}
