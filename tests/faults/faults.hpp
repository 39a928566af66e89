#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/lichtraum.hpp"

/// Which calls of the program fail: see fault_shim.cpp.
struct Fault {
  std::string kind;
  int at = 0;          ///< 0: none
  bool lasts = false;  ///< those after it, too
};

struct FaultyResult {
  ProcessResult process;
  int calls = 0;  ///< of that kind
  int failures = 0;
};

FaultyResult run_with_fault(Process process, Fault const& fault);

/// Of a folder and those below it: the files by name.
using Files = std::map<std::string, std::string>;
Files files_in(std::filesystem::path const& folder);
void write_files(std::filesystem::path const& folder, Files const& files);

/// What the program is asked to do, over and over again.
struct Task {
  std::string words;
  Files files;                        ///< that are there before
  std::vector<std::string> old = {};  ///< names of what it writes: something else is there before
};

/// One picture, a numbered sequence of four, and a film of them.
Task picture_task(std::string const& options);
Task sequence_task(std::string const& options);
Task film_task(std::string const& options);
/// A plan of four units, drawing them, and putting them together, on the reference device.
Task plan_task();
Task work_task();
Task merge_task();

/// Lets calls of that kind fail, one run for each: all of them, or as many as `most`, chosen by `seed`. Checks that a
/// run ends in time and by itself, with a documented status and a message, that each file is the old one or the new
/// one, and that there are no others. Returns how many runs in which a call did fail ended with each status.
std::map<int, int> check_each_fault(Task const& task, std::string const& kind, std::size_t most, unsigned seed = 1);
