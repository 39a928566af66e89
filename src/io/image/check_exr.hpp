#pragma once

#include <cstdint>
#include <string_view>

namespace lichtraum {

/// Throws std::runtime_error for an OpenEXR file whose header asks for more memory than its bytes could fill: OpenEXR
/// takes it before it reads them, up to 2 GB for an attribute. What else may be wrong is left to OpenEXR. `beginning`:
/// the file's first bytes, with all of its header, of `file_bytes` in all.
void check_exr_header(std::string_view beginning, std::uint64_t file_bytes);

}  // namespace lichtraum
