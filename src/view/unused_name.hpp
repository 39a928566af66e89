#pragma once

#include <string>

namespace lichtraum::view {

/// The first of "<stem>_0001<extension>", "<stem>_0002<extension>" and so on that nothing has yet, not even a link that
/// leads nowhere. Where that cannot be told, as of a name that is too long, the one that is to be tried.
std::string unused_name(std::string const& stem, char const* extension);

}  // namespace lichtraum::view
