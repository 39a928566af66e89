#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How to run a program.
struct Process {
  std::vector<std::string> arguments;                   ///< the program's path first
  std::string input = {};                               ///< its standard input
  std::filesystem::path folder = ".";                   ///< its current folder
  std::map<std::string, std::string> environment = {};  ///< added to this process's
  std::string output_file = {};                         ///< standard output goes there instead of into the result
  bool closes_output = false;                           ///< standard output is closed from the start
  bool stops_reading = false;                           ///< nobody reads standard output
  bool has_terminal = false;                            ///< standard error is a terminal
  std::optional<unsigned long> max_file_bytes = {};     ///< as ulimit -f
  double timeout_seconds = 60;

  /// Sent once both times have passed.
  struct Signal {
    int number;
    double after_seconds = 0;      ///< since it was started
    double after_cpu_seconds = 0;  ///< of the program's own work, so that a busy machine does not interrupt it sooner
  };
  std::vector<Signal> signals = {};  ///< sent to it, one after the other
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 when it did not exit by itself
  int signal = 0;      ///< that ended it, or 0
  std::string out;
  std::string err;
  double seconds = 0;               ///< from start to end
  double seconds_after_signal = 0;  ///< from the last signal sent, or the start, to the end
};

/// Throws std::runtime_error when it takes longer than the timeout (and kills it).
ProcessResult run_process(Process const& process);

/// Whether this machine lends pseudo-terminals (a chroot without /dev/pts has none): else has_terminal cannot be had.
bool has_pseudo_terminals();

/// Whether a program of that name is found.
bool is_installed(std::string const& program);
