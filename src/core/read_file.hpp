#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace lichtraum {

/// What a pipe or a device may deliver at most; a regular file may be as large as memory allows.
inline constexpr std::size_t max_stream_bytes = std::size_t{1} << 30;

/// The bytes of a file, a pipe or a device. Throws Error{no_input} that says why when `path` cannot be opened or is a
/// folder, Error{io} when reading fails half-way or a stream is longer than `stream_limit`.
std::string read_file(std::filesystem::path const& path, std::size_t stream_limit = max_stream_bytes);

}  // namespace lichtraum
