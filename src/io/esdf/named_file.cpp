#include "io/esdf/named_file.hpp"

#include <string>
#include <utility>

#include "io/model_file.hpp"

namespace lichtraum::esdf {

std::optional<std::filesystem::path> find_named_file(Interpreter& interpreter, Token name) {
  std::filesystem::path const& folder = interpreter.source.folder;
  auto const& allowed = interpreter.options.allowed_paths;
  std::string reason;
  auto path = find_model_file(folder, allowed, {}, std::string(name), reason);
  if (!path) {
    std::string hint = hint_for_place(folder, allowed, std::string(name), "scene's");
    Code const code = hint.empty() ? Code::unreadable_file : Code::file_outside;
    interpreter.error(code, name, std::move(reason), std::move(hint));
  }
  return path;
}

}  // namespace lichtraum::esdf
