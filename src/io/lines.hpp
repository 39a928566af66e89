#pragma once

#include <cstdint>
#include <vector>

namespace lichtraum {

/// Unfolds loops (mode 2) and strips (mode 3) to pairs as glTF 2.0, section 3.7.2.1, says; a list (mode 1) stays, cut
/// to whole pairs.
std::vector<std::uint32_t> to_line_list(std::vector<std::uint32_t> indices, int mode);

}  // namespace lichtraum
