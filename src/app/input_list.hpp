#pragma once

#include <string>
#include <vector>

namespace lichtraum::app {

/// By the numbers in names: frame2.sdf before frame10.sdf.
bool comes_before(std::string const& a, std::string const& b);

/// What the command line names, with the patterns (*, ? and [...]) that the shell left as they are replaced by the
/// files that they match: in the order of the numbers in their names, frame2.sdf before frame10.sdf. A file that is
/// called like a pattern is that file. Throws Error{no_input} for a pattern that nothing matches.
std::vector<std::string> expand_patterns(std::vector<std::string> const& arguments);

}  // namespace lichtraum::app
