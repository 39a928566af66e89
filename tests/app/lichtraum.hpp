#pragma once

#include <string>
#include <vector>

#include "support/subprocess.hpp"
#include "support/temporary_folder.hpp"

/// The built program, run in a folder of its own.
class Lichtraum {
 public:
  TemporaryFolder const folder;

  /// `words` as they would be typed: separated by blanks.
  Process process(std::string const& words) const;
  ProcessResult operator()(std::string const& words, std::string const& input = {}) const;
  /// `lichtraum render --device reference`, for what needs no OpenCL.
  ProcessResult render(std::string const& words, std::string const& input = {}) const;
};

/// A red sphere in 32x24 pixels, drawn to ball.ppm.
inline constexpr char const* ball_scene =
    "define material red 0.5 0 0 0.5 0 0 0 0 0 1\n"
    "define shape sphere ball 0 0 -3 1 red\n"
    "define light ambient sky 1 1 1\n"
    "define light diffuse sun 5 5 0 1 1 1\n"
    "define camera eye 60\n"
    "render eye ball.ppm 32 24\n";
