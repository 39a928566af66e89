#pragma once

#include <filesystem>
#include <optional>

#include "io/esdf/interpreter.hpp"

namespace lichtraum::esdf {

/// Where the file is that a statement names. Nothing, after a report, where it must not be read: what is no file could
/// keep its reader waiting for good. It need not exist.
std::optional<std::filesystem::path> find_named_file(Interpreter& interpreter, Token name);

}  // namespace lichtraum::esdf
