#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lichtraum::gltf {

bool is_data_uri(std::string_view uri);

/// The bytes of a data URI (RFC 2397), base64 (RFC 4648, also the URL-safe alphabet, also unpadded) or percent-encoded;
/// nothing when it is malformed.
std::optional<std::string> decode_data_uri(std::string_view uri);

/// Whether a URI names another protocol: "http://...", "file:...". A single letter is a Windows drive and counts too.
bool has_scheme(std::string_view uri);

}  // namespace lichtraum::gltf
