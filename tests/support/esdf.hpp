#pragma once

#include <string>
#include <vector>

#include "lichtraum/esdf.hpp"

namespace lichtraum::test {

/// The scene at the end of `text`; a faulty text fails the test.
Scene scene_of(std::string const& text, EsdfOptions const& options = {});

/// Everything found in `text`, whether it loads or not. The file is called "s.sdf".
std::vector<Diagnostic> findings(std::string const& text, EsdfOptions const& options = {});

/// The same as a reader sees it, without the notes on dialects.
std::string shown(std::string const& text, EsdfOptions const& options = {});

/// Reads on after an error.
inline EsdfOptions const keep_going = [] {
  EsdfOptions options;
  options.keep_going = true;
  return options;
}();

/// Whether `text` loads.
bool loads(std::string const& text, EsdfOptions const& options = {});

std::size_t count_errors(std::vector<Diagnostic> const& diagnostics);

/// A material "red" and a camera "eye", for scenes that need some.
inline std::string const red = "define material red 1 0 0 1 0 0 1 0 0 10\n";
inline std::string const eye = "define camera eye 45\n";

}  // namespace lichtraum::test
