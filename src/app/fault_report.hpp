#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lichtraum::app {

/// What is shown when lichtraum itself is at fault: what happened, then the command (quoted for a shell), the version
/// and where to report it, a line each. `what` may be a library's sentence, or a compiler's log. Ends without a
/// newline.
std::string fault_report(std::string_view what, std::vector<std::string> const& command_line);

}  // namespace lichtraum::app
