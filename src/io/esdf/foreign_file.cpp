#include "io/esdf/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/file_signature.hpp"
#include "io/unread_model.hpp"

namespace lichtraum::esdf {
namespace {

constexpr std::string_view no_scene_hint = "is this the scene file?";
constexpr std::size_t examined_bytes = 4096;

}  // namespace

std::optional<ForeignFile> recognise_foreign_file(std::filesystem::path const& path, std::string_view text) {
  if (auto const model = recognise_unread_model(path, text)) {
    return ForeignFile{DiagnosticCode::unread_format, "this is " + model->what, model->hint};
  }
  if (auto const signature = recognise_signature(text)) {
    return ForeignFile{DiagnosticCode::not_a_scene, fmt::format("this is {}, not an eSDF scene", signature->what),
                       std::string(signature->hint.empty() ? no_scene_hint : signature->hint)};
  }
  std::string_view const head = text.substr(0, examined_bytes);
  if (head.find('\0') != std::string_view::npos) {
    return ForeignFile{DiagnosticCode::not_a_scene, "this is a binary file, not an eSDF scene",
                       std::string(no_scene_hint)};
  }
  // A template's placeholder {{...}} starts like JSON and is reported where it stands.
  std::size_t const first = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  std::string_view const start = head.substr(first);
  if (start.starts_with("{") && !start.starts_with("{{")) {
    return ForeignFile{DiagnosticCode::not_a_scene, "this is a JSON document (a glTF model?), not an eSDF scene",
                       "a glTF model's name has the extension .gltf; on standard input, --format-in gltf says so"};
  }
  return std::nullopt;
}

}  // namespace lichtraum::esdf
