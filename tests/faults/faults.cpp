#include "faults/faults.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <random>
#include <set>

#include "support/catch.hpp"

namespace fs = std::filesystem;

namespace {

/// The man page's, without those for a wrong command line and for an interruption.
std::set<int> const documented{0, 65, 66, 69, 70, 73, 74, 75};

std::string const moving_ball = [] {
  std::string scene = std::string(ball_scene).replace(std::string(ball_scene).find("ball.ppm"), 8, "x.png");
  for (int i = 0; i < 3; ++i) scene += "transform ball translate 0.1 0 0\nrender eye x.png 32 24\n";
  return scene;
}();

void clear(fs::path const& folder) {
  for (auto const& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
}

/// A plan that others can draw: files are named by their whole paths in it, so each run is in the same folder.
class Runs {
 public:
  explicit Runs(Task const& task) : task_(task) {}

  FaultyResult run(Fault const& fault) {
    clear(lichtraum_.folder.path());
    write_files(lichtraum_.folder.path(), before());
    Process process = lichtraum_.process(task_.words);
    process.timeout_seconds = 30;
    return run_with_fault(process, fault);
  }

  Files before() {
    if (before_) return *before_;
    Files files = task_.files;
    for (std::string const& name : task_.old) files[name] = "old";
    bool const is_planned = task_.words.find("job work") == 0 || task_.words.find("job merge") == 0;
    if (is_planned) {
      write_files(lichtraum_.folder.path(), files);
      REQUIRE(lichtraum_("job plan a.sdf -o shared --tile 16x16 --device reference -q").exit_code == 0);
      if (task_.words.find("job merge") == 0)
        REQUIRE(lichtraum_("job work shared -q --device reference").exit_code == 0);
      files = files_in(lichtraum_.folder.path());
    }
    before_ = files;
    return files;
  }

  Files after() const { return files_in(lichtraum_.folder.path()); }

 private:
  Task const& task_;
  Lichtraum lichtraum_;
  std::optional<Files> before_;
};

std::string listed(std::string const& name, std::string const& bytes) {
  return " " + name + " (" + std::to_string(bytes.size()) + " bytes)";
}

/// Files that are neither as they were nor as they were to be.
std::string wrong_files(Files const& before, Files const& wanted, Files const& after) {
  std::string wrong;
  auto const is_in = [](Files const& files, auto const& file) {
    auto const found = files.find(file.first);
    return found != files.end() && found->second == file.second;
  };
  for (auto const& file : after) {
    if (!is_in(before, file) && !is_in(wanted, file)) wrong += listed(file.first, file.second);
  }
  for (auto const& [name, bytes] : before) {
    if (!after.contains(name)) wrong += " no " + name;
  }
  return wrong;
}

}  // namespace

FaultyResult run_with_fault(Process process, Fault const& fault) {
  TemporaryFolder const counted;
  std::string const counts = (counted / "counts").string();
  process.environment.insert({{"LD_PRELOAD", LICHTRAUM_FAULT_SHIM},
                              {"LICHTRAUM_FAULT_KIND", fault.kind},
                              {"LICHTRAUM_FAULT_AT", std::to_string(fault.at)},
                              {"LICHTRAUM_FAULT_LASTS", fault.lasts ? "1" : "0"},
                              {"LICHTRAUM_FAULT_COUNT", counts}});
  FaultyResult result{run_process(process)};
  std::string const bytes = counted.read("counts");
  std::int32_t numbers[2]{};
  REQUIRE(bytes.size() == sizeof numbers);
  std::memcpy(numbers, bytes.data(), sizeof numbers);
  result.calls = numbers[0];
  result.failures = numbers[1];
  return result;
}

void write_files(fs::path const& folder, Files const& files) {
  for (auto const& [name, bytes] : files) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
}

Files files_in(fs::path const& folder) {
  Files files;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[fs::relative(entry.path(), folder).string()].assign(std::istreambuf_iterator<char>(in), {});
  }
  return files;
}

Task picture_task(std::string const& options) {
  return {"render a.sdf -o a.png " + options, {{"a.sdf", ball_scene}}, {"a.png"}};
}

Task sequence_task(std::string const& options) {
  return {"render a.sdf -o %d.png " + options, {{"a.sdf", moving_ball}}, {"1.png", "2.png", "3.png", "4.png"}};
}

Task film_task(std::string const& options) {
  return {"render a.sdf -o a.mp4 " + options, {{"a.sdf", moving_ball}}, {"a.mp4"}};
}

Task plan_task() { return {"job plan a.sdf -o shared --tile 16x16 --device reference", {{"a.sdf", ball_scene}}}; }
Task work_task() { return {"job work shared --units 0..3 --device reference", {{"a.sdf", ball_scene}}}; }
Task merge_task() { return {"job merge shared -o a.png", {{"a.sdf", ball_scene}}, {"a.png"}}; }

std::map<int, int> check_each_fault(Task const& task, std::string const& kind, std::size_t most, unsigned seed) {
  Runs runs(task);
  FaultyResult const clean = runs.run({kind});
  INFO(task.words << ": " << clean.process.err);
  REQUIRE(clean.process.exit_code == 0);
  Files const wanted = runs.after();
  std::vector<int> all(std::size_t(clean.calls)), chosen;
  std::iota(all.begin(), all.end(), 1);
  std::ranges::sample(all, std::back_inserter(chosen), std::ptrdiff_t(most), std::mt19937(seed));
  std::map<int, int> statuses;
  for (int const at : chosen) {
    for (bool const lasts : {false, true}) {
      FaultyResult const faulty = runs.run({kind, at, lasts});
      int const status = faulty.process.exit_code;
      std::string const& err = faulty.process.err;
      INFO(kind << " " << at << " of " << clean.calls << (lasts ? " and later" : "") << " fails; status " << status
                << ", signal " << faulty.process.signal << ": " << err);
      CHECK(faulty.process.signal == 0);
      CHECK(documented.contains(status));
      CHECK((status == 0 || err.find("error: ") != std::string::npos));
      CHECK_THAT(err, !contains_text("this is a fault in lichtraum"));  // it is one of the machine
      CHECK(wrong_files(runs.before(), wanted, runs.after()) == "");
      if (status == 0) CHECK(wrong_files(wanted, wanted, runs.after()) == "");
      // How often a device is asked depends on how fast it is: a call of the clean run may not be there in this one.
      if (faulty.failures > 0) ++statuses[status];
    }
  }
  return statuses;
}
