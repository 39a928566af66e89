#include "io/esdf/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/file_signature.hpp"
#include "io/unread_model.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::esdf {
namespace {

constexpr std::string_view no_scene_hint = "is this the scene file?";
constexpr std::size_t examined_bytes = 4096;

ForeignFile foreign_model(std::string_view what, std::string_view extension) {
  return {DiagnosticCode::not_a_scene, fmt::format("this is {}, not an eSDF scene", what),
          fmt::format("a model's name has the extension .{0}; on standard input, --format-in {0} says so", extension)};
}

}  // namespace

std::optional<ForeignFile> recognise_foreign_file(std::filesystem::path const& path, std::string_view text) {
  if (auto const model = recognise_unread_model(path, text)) {
    return ForeignFile{DiagnosticCode::unread_format, "this is " + model->what, model->hint};
  }
  if (auto const signature = recognise_signature(text)) {
    return ForeignFile{DiagnosticCode::not_a_scene, fmt::format("this is {}, not an eSDF scene", signature->what),
                       std::string(signature->hint.empty() ? no_scene_hint : signature->hint)};
  }
  if (std::string_view const format = model_format_of(text); !format.empty()) {
    return foreign_model(fmt::format("a model (.{})", format), format);
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
    return foreign_model("a JSON document (a glTF model?)", "gltf");
  }
  return std::nullopt;
}

}  // namespace lichtraum::esdf
