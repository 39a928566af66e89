#include "io/ply/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <charconv>
#include <optional>

#include "io/another_file.hpp"

namespace lichtraum::ply {
namespace {

constexpr std::size_t max_header_lines = 4096;

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr TypeName type_names[] = {
    {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
    {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
    {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
    {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64},
};

std::optional<Type> type_of(Token word) {
  for (TypeName const& known : type_names) {
    if (known.name == word) return known.type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(Header& header, Diagnostics& diagnostics) : header_(header), diagnostics_(diagnostics) {}

  bool run(std::string_view bytes) {
    // Old Macs end lines with CR alone. The bytes of numbers that follow may be anything, so the first line decides.
    std::size_t const first_end = bytes.find_first_of("\r\n");
    bool const has_lf =
        first_end == std::string_view::npos || bytes.substr(first_end, 2) == "\r\n" || bytes[first_end] == '\n';
    LineReader lines(bytes, has_lf ? '\n' : '\r');
    Line line;
    for (std::size_t i = 0; i < max_header_lines && lines.next(line); ++i) {
      diagnostics_.begin_line(line);
      std::string_view rest = line.text;
      Token const keyword = next_token(rest);
      if (line.number == 1) {
        if (keyword != "ply") return fail_as_another(bytes, keyword);
      } else if (keyword == "end_header") {
        header_.data_offset = bytes.size() - lines.rest().size();
        header_.data_line = line.number + 1;
        return has_format_ || fail(keyword, "the format is missing");
      } else if (!statement(keyword, rest)) {
        return false;
      }
    }
    diagnostics_.begin_line({});
    return fail({}, "the header has no end: end_header is missing");
  }

 private:
  bool statement(Token keyword, std::string_view rest) {
    if (keyword == "format") return format(rest);
    if (keyword == "element") return element(rest);
    if (keyword == "property") return property(keyword, rest);
    if (keyword == "comment") return comment(rest);
    return keyword.empty() || keyword == "obj_info" ||
           fail(keyword, fmt::format("unknown keyword in a PLY header: {}", in_quotes(keyword)));
  }

  bool format(std::string_view rest) {
    Token const word = next_token(rest);
    has_format_ = true;
    if (word == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (word == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (word == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      return fail(word, fmt::format("format: expected ascii, binary_little_endian or binary_big_endian, found {}",
                                    in_quotes(word)));
    }
    return true;
  }

  bool element(std::string_view rest) {
    Element element;
    Token const name = next_token(rest);
    element.name = name;
    bool const is_known = std::any_of(header_.elements.begin(), header_.elements.end(),
                                      [&](Element const& other) { return other.name == element.name; });
    if (is_known) return fail(name, fmt::format("the element {} is there twice", in_quotes(name)));
    Token const count = next_token(rest);
    auto const [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || end != count.data() + count.size()) {
      return fail(count, fmt::format("element: expected a name and a number, found {}", in_quotes(count)));
    }
    header_.elements.push_back(std::move(element));
    return true;
  }

  bool property(Token keyword, std::string_view rest) {
    if (header_.elements.empty()) return fail(keyword, "a property before the first element");
    Property property;
    Token word = next_token(rest);
    property.is_list = word == "list";
    if (property.is_list) {
      word = next_token(rest);
      auto const count_type = type_of(word);
      bool const is_integer = count_type && *count_type != Type::float32 && *count_type != Type::float64;
      if (!is_integer)
        return fail(word, fmt::format("{} is not a type that can count the elements of a list", in_quotes(word)));
      property.count_type = *count_type;
      word = next_token(rest);
    }
    auto const type = type_of(word);
    if (!type) return fail(word, fmt::format("PLY has no type {}", in_quotes(word)));
    property.type = *type;
    property.name = next_token(rest);
    header_.elements.back().properties.push_back(std::move(property));
    return true;
  }

  bool comment(std::string_view rest) {
    if (next_token(rest) != "TextureFile" || trimmed(rest).empty()) return true;
    std::string& file = header_.texture_files.emplace_back(trimmed(rest));
    std::replace(file.begin(), file.end(), '\\', '/');  // written on Windows
    return true;
  }

  bool fail_as_another(std::string_view bytes, Token keyword) {
    return !is_another_file(bytes, "a PLY file", DiagnosticCode::ply_header, diagnostics_) &&
           fail(keyword, "this is not a PLY file: it does not begin with 'ply'");
  }

  bool fail(Token at, std::string message) {
    diagnostics_.add(Severity::error, DiagnosticCode::ply_header, at, std::move(message));
    return false;
  }

  Header& header_;
  Diagnostics& diagnostics_;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
      return 4;
    case Type::float64:
      return 8;
  }
  return 0;
}

bool read_header(std::string_view bytes, Header& header, Diagnostics& diagnostics) {
  return HeaderReader(header, diagnostics).run(bytes);
}

Drawn Header::draws() const {
  auto const has = [this](std::string_view name) {
    return std::any_of(elements.begin(), elements.end(),
                       [&](Element const& e) { return e.count > 0 && e.name == name; });
  };
  return has("face") || has("tristrips") ? Drawn::triangles : has("edge") ? Drawn::lines : Drawn::points;
}

}  // namespace lichtraum::ply
