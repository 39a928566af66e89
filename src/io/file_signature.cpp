#include "io/file_signature.hpp"

#include <array>

namespace lichtraum {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view plain_text_hint = "save it as plain text";
constexpr std::string_view web_page_hint = "was a web page saved instead of the file itself?";

constexpr std::array signatures = {
    FileSignature{"{\\rtf"sv, "an RTF document", "save it as plain text (in TextEdit: Format, Make Plain Text)"},
    FileSignature{"\xFF\xFE"sv, "UTF-16 text", "save it as UTF-8"},
    FileSignature{"\xFE\xFF"sv, "UTF-16 text", "save it as UTF-8"},
    FileSignature{"<?xml"sv, "an XML document", ""},
    FileSignature{"<!DOCTYPE html"sv, "an HTML document", web_page_hint},
    FileSignature{"<!doctype html"sv, "an HTML document", web_page_hint},
    FileSignature{"<!DOCTYPE"sv, "an HTML or XML document", ""},
    FileSignature{"<html"sv, "an HTML document", web_page_hint},
    FileSignature{"version https://git-lfs"sv, "a Git LFS pointer", "git lfs pull fetches the file itself"},
    FileSignature{"glTF"sv, "a binary glTF model", "give its name the extension .glb"},
    FileSignature{"%PDF"sv, "a PDF document", plain_text_hint},
    FileSignature{"PK\x03\x04"sv, "a ZIP archive or an office document", "unpack it, or save it as plain text"},
    FileSignature{"\x1F\x8B"sv, "a gzip archive", "unpack it first"},
    FileSignature{"\x89PNG"sv, "a PNG picture", ""},
    FileSignature{"\xFF\xD8\xFF"sv, "a JPEG picture", ""},
    FileSignature{"#?RADIANCE"sv, "a Radiance picture (.hdr)", ""},
    FileSignature{"#?RGBE"sv, "a Radiance picture (.hdr)", ""},
    FileSignature{"P3\n"sv, "a PPM picture", ""},
    FileSignature{"P6\n"sv, "a PPM picture", ""},
};

constexpr std::size_t examined_bytes = 4096;

}  // namespace

std::optional<FileSignature> recognise_signature(std::string_view bytes) {
  std::string_view const head = bytes.substr(0, examined_bytes);
  std::size_t const first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return std::nullopt;
  for (FileSignature const& signature : signatures) {
    if (head.substr(first).starts_with(signature.start)) return signature;
  }
  return std::nullopt;
}

}  // namespace lichtraum
