#include "faults/faults.hpp"
#include "lichtraum/device.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

// Whichever call fails: what was there is there, or what was to be written is, whole.
// The hidden tests, `faults_tests "[every]"`, leave no call out, and take half an hour.

namespace {

constexpr std::size_t all = 1'000'000;
std::string const reference = "--device reference";

std::vector<std::string> const file_kinds{"write", "read", "open", "rename", "sync", "close"};

void check_opencl(Task const& task, std::size_t most) {
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  auto const statuses = check_each_fault(task, "opencl", most);
  for (auto const& [status, runs] : statuses) CHECK((status == 0 || status == 69));
  CHECK(statuses.contains(69));
}

void check_allocations(Task const& task, std::size_t most) {
  auto const statuses = check_each_fault(task, "allocation", most);
  CHECK(statuses.contains(70));
}

}  // namespace

TEST_CASE("a call for files that fails leaves the old picture or the new one", "[faults]") {
  for (std::string const& kind : file_kinds) check_each_fault(sequence_task(reference), kind, all);
}

// Planning and working begin with some pictures for the device's class, so only a sample is tried here.
TEST_CASE("a call for files that fails leaves whole units", "[faults]") {
  for (std::string const& kind : file_kinds) check_each_fault(merge_task(), kind, 3);
  for (char const* const kind : {"write", "rename", "sync"}) check_each_fault(work_task(), kind, 1);
}

TEST_CASE("any call for files that fails leaves a whole plan, and whole units", "[faults][.][every]") {
  for (std::string const& kind : file_kinds) {
    for (Task const& task : {plan_task(), work_task(), merge_task()}) check_each_fault(task, kind, all);
  }
}

TEST_CASE("a call for files or processes that fails leaves the old film or the new one", "[faults]") {
  if (!is_installed("ffmpeg")) SKIP_TEST("ffmpeg is not installed");
  for (std::string const& kind : file_kinds) check_each_fault(film_task(reference), kind, 2);
  CHECK(check_each_fault(film_task(reference), "process", all) == std::map<int, int>{{74, 6}});
}

TEST_CASE("an OpenCL call that fails ends the program in order, or another device draws", "[faults]") {
  check_opencl(picture_task("--device cpu"), 20);
  check_opencl(picture_task("--device cpu --samples 4 --integrator path --denoise builtin"), 10);
}

TEST_CASE("what the device still works on stays there until it is done", "[faults]") {
  if (lichtraum::find_devices().devices.size() == 1) SKIP_TEST("there is no OpenCL device");
  Task const task = picture_task("--device cpu --size 400x300 --samples 16 --integrator path --denoise builtin");
  auto const statuses = check_each_fault(task, "map", 5);
  REQUIRE(statuses.size() == 1);
  CHECK(statuses.begin()->first == 69);
}

TEST_CASE("any OpenCL call that fails ends the program in order, or another device draws", "[faults][.][every]") {
  check_opencl(picture_task("--device cpu"), all);
  check_opencl(sequence_task("--device cpu --planes depth"), all);
  check_opencl(picture_task("--device cpu --samples 4 --integrator path --denoise builtin"), all);
  if (lichtraum::find_devices().devices.size() > 1) check_each_fault(picture_task(""), "opencl", all);
}

TEST_CASE("a plan is whole or not there, and knows each file that was read", "[faults]") {
  check_each_fault(plan_task(), "write", all);
  check_each_fault(plan_task(), "read", 3);
}

TEST_CASE("where no thread can be started, fewer draw; without the first, that is said", "[faults]") {
  CHECK(check_each_fault(work_task(), "thread", 1) == std::map<int, int>{{0, 2}});
  for (Task const& task : {sequence_task(reference), merge_task()}) {
    auto const statuses = check_each_fault(task, "thread", all);
    CHECK(statuses.at(70) == 2);  // the one that reads scenes
    CHECK(statuses.at(0) >= 2);
    CHECK(statuses.size() == 2);
  }
}

TEST_CASE("memory that cannot be had ends the program in order", "[faults]") {
  for (Task const& task : {picture_task(reference), sequence_task(reference), merge_task()}) {
    check_allocations(task, 20);
  }
  for (Task const& task : {plan_task(), work_task()}) check_allocations(task, 2);
}

TEST_CASE("any memory that cannot be had ends the program in order", "[faults][.][every]") {
  for (Task const& task : {picture_task(reference), picture_task("--device reference --json"), merge_task()}) {
    check_allocations(task, all);
  }
  for (Task const& task : {plan_task(), work_task()}) check_allocations(task, 500);
  if (is_installed("ffmpeg")) check_allocations(film_task(reference), 1000);
  if (lichtraum::find_devices().devices.size() > 1) check_allocations(picture_task("--device cpu"), 1000);
}
