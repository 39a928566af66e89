#pragma once

#include <filesystem>
#include <optional>

#include "io/esdf/interpreter.hpp"

namespace lichtraum::esdf {

/// Where the file is that a statement names; it need not exist. Nothing, after a report, where it must not be read:
/// outside of the scene's folder, or what is no file, which could keep its reader waiting for good.
std::optional<std::filesystem::path> find_named_file(Interpreter& interpreter, Token name);

}  // namespace lichtraum::esdf
