#include "io/obj/mtl_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/ascii.hpp"
#include "io/text/numbers.hpp"

namespace lichtraum::obj {
namespace {

/// What is known and not used: maps and values of shading that Phong's formula does not have.
constexpr std::string_view unused[] = {
    "sharpness", "map_ka", "map_ks", "map_ns", "disp",     "decal",  "refl", "map_refl", "map_tr",  "map_ps",
    "map_aat",   "ps",     "aniso",  "anisor", "map_disp", "map_ni", "km",   "map_rma",  "map_orm",
};

class MtlReader {
 public:
  explicit MtlReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  std::vector<MtlMaterial> run(std::string_view text) {
    LineReader lines(text);
    Line line;
    while (lines.next(line)) {
      std::string_view rest = line.text;
      Token const keyword = next_token(rest);
      if (keyword.empty() || keyword[0] == '#') continue;
      diagnostics_.begin_line(line);
      if (keyword == "newmtl") {
        begin_material(keyword, rest);
      } else if (!materials_.empty()) {
        property(keyword, rest, materials_.back());
      } else if (!is_lost_) {
        is_lost_ = true;
        warn(DiagnosticCode::missing_obj_word, keyword, "a property before the first newmtl is left out");
      }
    }
    return std::move(materials_);
  }

 private:
  void begin_material(Token keyword, std::string_view rest) {
    Token const name = trimmed(rest);
    if (name.empty()) warn(DiagnosticCode::missing_obj_word, keyword, "newmtl: expected a name");
    materials_.emplace_back();
    materials_.back().name = name;
  }

  // Exporters disagree on capitals.
  void property(Token keyword, std::string_view rest, MtlMaterial& m) {
    std::string const word = to_lower_ascii(keyword);
    if (word == "ka") return color(rest, m.ka);
    if (word == "kd") return color(rest, m.kd);
    if (word == "ks") return color(rest, m.ks);
    if (word == "ke") return color(rest, m.ke);
    if (word == "tf") return color(rest, m.tf);
    if (word == "ns") return number(rest, m.ns);
    if (word == "ni") return number(rest, m.ni);
    if (word == "pm") return number(rest, m.metallic);
    if (word == "pr") return number(rest, m.roughness);
    if (word == "pc") return number(rest, m.clearcoat);
    if (word == "pcr") return number(rest, m.clearcoat_roughness);
    if (word == "illum") return number(rest, m.illum);
    if (word == "d") return dissolve(rest, m);
    if (word == "tr") return number(rest, m.tr);
    if (word == "map_kd") return texture(rest, m.map_kd);
    if (word == "map_ke") return texture(rest, m.map_ke);
    if (word == "map_d" || word == "map_opacity") return texture(rest, m.map_d);
    if (word == "map_pr") return texture(rest, m.map_pr);
    if (word == "map_pm") return texture(rest, m.map_pm);
    if (word == "map_bump" || word == "bump") return texture(rest, m.map_bump);
    if (word == "norm" || word == "map_kn") return texture(rest, m.norm);
    if (std::find(std::begin(unused), std::end(unused), word) != std::end(unused)) return;
    warn(DiagnosticCode::unknown_obj_keyword, keyword,
         fmt::format("unknown MTL keyword {}: the line is left out", in_quotes(keyword)));
  }

  void number(std::string_view& rest, std::optional<double>& out) {
    Token const word = next_token(rest);
    double value = 0;
    if (word.empty()) return warn(DiagnosticCode::faulty_number, word, "expected a number");
    if (read_number(word, value, diagnostics_)) out = value;
  }

  /// One number stands for all three.
  void color(std::string_view rest, std::optional<Rgb>& out) {
    Token const first = next_token(rest);
    if (first == "spectral" || first == "xyz")
      return warn(DiagnosticCode::unread_color, first, "only colours as red, green and blue are read");
    double r = 0, g = 0, b = 0;
    if (first.empty()) return warn(DiagnosticCode::faulty_number, first, "expected red, green and blue");
    if (!read_number(first, r, diagnostics_)) return;
    Token const second = next_token(rest), third = next_token(rest);
    if (third.empty()) {
      out = Rgb(r);
    } else if (read_number(second, g, diagnostics_) && read_number(third, b, diagnostics_)) {
      out = Rgb(r, g, b);
    }
    if (out) *out = glm::max(*out, Rgb(0));
  }

  void dissolve(std::string_view rest, MtlMaterial& m) {
    std::string_view copy = rest;
    if (next_token(copy) == "-halo") rest = copy;
    number(rest, m.d);
  }

  void texture(std::string_view rest, MtlTexture& out) {
    out = {};
    out.line = diagnostics_.line();
    while (take_option(rest, out)) continue;
    std::string_view const file = trimmed(rest);
    out.file = with_slashes(file);
    out.bare_file = out.file;
    if (out.file.empty()) return warn(DiagnosticCode::missing_obj_word, place_after(rest), "expected a file");
    // Options belong before the name, and a name may have blanks in it. Some programs write options after it.
    for (next_token(rest); !rest.empty(); next_token(rest)) {
      std::string_view const before = file.substr(0, std::size_t(rest.data() - file.data()));
      if (!take_option(rest, out)) continue;
      out.bare_file = with_slashes(trimmed(before));
      while (take_option(rest, out)) continue;
      return;
    }
  }

  /// As written on Windows, too.
  static std::string with_slashes(std::string_view file) {
    std::string result(file);
    std::replace(result.begin(), result.end(), '\\', '/');
    return result;
  }

  /// False where the next word is none.
  bool take_option(std::string_view& rest, MtlTexture& out) {
    std::string_view after = rest;
    Token const option = next_token(after);
    if (option == "-clamp") {
      out.clamp = next_token(after) == "on";
    } else if (option == "-o") {
      vector(after, out.offset);
    } else if (option == "-s") {
      vector(after, out.scale);
    } else if (option == "-bm") {
      std::optional<double> multiplier;
      number(after, multiplier);
      out.multiplier = multiplier.value_or(1);
    } else if (option == "-t") {
      glm::dvec2 ignored(0);
      vector(after, ignored);
    } else if (option == "-mm") {
      next_token(after);
      next_token(after);
    } else if (is_option(option)) {
      next_token(after);
    } else {
      return false;
    }
    rest = after;
    return true;
  }

  static bool is_option(Token word) {
    for (std::string_view const known :
         {"-blendu", "-blendv", "-boost", "-cc", "-imfchan", "-texres", "-type", "-colorspace"}) {
      if (word == known) return true;
    }
    return false;
  }

  /// One to three numbers, of which two count.
  void vector(std::string_view& rest, glm::dvec2& out) {
    for (int i = 0; i < 3; ++i) {
      std::string_view after = rest;
      Token const word = next_token(after);
      bool const starts_number = !word.empty() && (word.find_first_not_of("+-.0123456789eE") == Token::npos);
      if (!starts_number) return;
      double value = 0;
      if (!read_number(word, value, diagnostics_)) return;
      if (i < 2) out[i] = value;
      rest = after;
    }
  }

  void warn(DiagnosticCode code, Token at, std::string message) {
    diagnostics_.add(Severity::warning, code, at, std::move(message));
  }

  Diagnostics& diagnostics_;
  std::vector<MtlMaterial> materials_;
  bool is_lost_ = false;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, Diagnostics& diagnostics) {
  return MtlReader(diagnostics).run(text);
}

}  // namespace lichtraum::obj
