#include "io/esdf/foreign_file.hpp"

#include <array>

#include "io/unread_model.hpp"

namespace lichtraum::esdf {
namespace {

using namespace std::string_view_literals;

struct FileSignature {
  std::string_view start;
  std::string_view what;
  std::string_view hint;
};

constexpr std::string_view plain_text_hint = "save it as plain text";
constexpr std::string_view no_scene_hint = "is this the scene file?";

constexpr std::array signatures = {
    FileSignature{"{\\rtf"sv, "an RTF document", "save it as plain text (in TextEdit: Format, Make Plain Text)"},
    FileSignature{"\xFF\xFE"sv, "UTF-16 text", "save it as UTF-8"},
    FileSignature{"\xFE\xFF"sv, "UTF-16 text", "save it as UTF-8"},
    FileSignature{"<?xml"sv, "an XML document", no_scene_hint},
    FileSignature{"<!DOCTYPE"sv, "an HTML or XML document", no_scene_hint},
    FileSignature{"<html"sv, "an HTML document", "was a web page saved instead of the file itself?"},
    FileSignature{"glTF"sv, "a binary glTF model", no_scene_hint},
    FileSignature{"%PDF"sv, "a PDF document", plain_text_hint},
    FileSignature{"PK\x03\x04"sv, "a ZIP archive or an office document", plain_text_hint},
    FileSignature{"\x1F\x8B"sv, "a gzip archive", "unpack it first"},
    FileSignature{"\x89PNG"sv, "a PNG picture", no_scene_hint},
    FileSignature{"\xFF\xD8\xFF"sv, "a JPEG picture", no_scene_hint},
    FileSignature{"P3\n"sv, "a PPM picture", no_scene_hint},
    FileSignature{"P6\n"sv, "a PPM picture", no_scene_hint},
};

constexpr std::size_t examined_bytes = 4096;

}  // namespace

std::optional<ForeignFile> recognise_foreign_file(std::filesystem::path const& path, std::string_view text) {
  if (auto const model = recognise_unread_model(path, text)) {
    return ForeignFile{DiagnosticCode::unread_format, "this is " + model->what, model->hint};
  }
  std::string_view const head = text.substr(0, examined_bytes);
  std::size_t const first = head.find_first_not_of(" \t\r\n");
  std::string_view const start = first == std::string_view::npos ? ""sv : head.substr(first);
  for (FileSignature const& signature : signatures) {
    if (start.substr(0, signature.start.size()) == signature.start) {
      return ForeignFile{DiagnosticCode::not_a_scene, "this is " + std::string(signature.what) + ", not an eSDF scene",
                         std::string(signature.hint)};
    }
  }
  if (head.find('\0') != std::string_view::npos) {
    return ForeignFile{DiagnosticCode::not_a_scene, "this is a binary file, not an eSDF scene",
                       std::string(no_scene_hint)};
  }
  // A template's placeholder {{...}} starts like JSON and is reported where it stands.
  if (start.substr(0, 1) == "{" && start.substr(0, 2) != "{{") {
    return ForeignFile{DiagnosticCode::not_a_scene, "this is a JSON document (a glTF model?), not an eSDF scene",
                       std::string(no_scene_hint)};
  }
  return std::nullopt;
}

}  // namespace lichtraum::esdf
