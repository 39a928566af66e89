#pragma once

#include <string>
#include <string_view>

#include "lichtraum/environment.hpp"

/// One function a format of environment maps: the file as bytes in, what it holds out, whatever the values are.

namespace lichtraum {

/// A file's bytes, and what its messages need.
struct EnvironmentFile {
  std::string_view bytes;
  std::string name;
  std::int64_t max_pixels = max_environment_pixels;

  /// Throws Error{scene}.
  [[noreturn]] void fail(std::size_t byte, std::string const& what) const;
  /// The same, of the whole file.
  [[noreturn]] void fail(std::string const& what) const;
  [[noreturn]] void fail_cut_short(std::size_t byte) const { fail(byte, "the file ends here: it has been cut short"); }
  /// A map of no pixels yet. Fails where there are none or too many, before memory is taken for them.
  EnvironmentMap sized(std::int64_t width, std::int64_t height) const;
};

/// Radiance's RGBE (Ward, "Real Pixels", Graphics Gems II, 1991).
EnvironmentMap decode_hdr(EnvironmentFile const& file);
/// OpenEXR, of one part or the first of several.
EnvironmentMap decode_exr(EnvironmentFile const& file);
/// As encode_pfm writes it, of either byte order.
EnvironmentMap decode_pfm(EnvironmentFile const& file);

/// Whichever it is, with a check of each value: what read_environment does once the file is read.
EnvironmentMap decode_environment(EnvironmentFile const& file);

}  // namespace lichtraum
