#include <fmt/format.h>

#include "core/ascii.hpp"
#include "core/float3.hpp"
#include "io/stl/facets.hpp"
#include "io/text/numbers.hpp"

namespace lichtraum::stl {
namespace {

/// The words of a text, from line to line, in any case. The line of the word is that of the diagnostics.
class Words {
 public:
  Words(std::string_view text, Diagnostics& diagnostics) : lines_(text), diagnostics_(diagnostics) { take(); }

  /// The current word; empty at the end.
  Token word() const { return word_; }
  bool is(std::string_view keyword) const { return word_.size() == keyword.size() && to_lower_ascii(word_) == keyword; }
  bool is_at_end() const { return word_.empty(); }

  void take() {
    last_ = word_;
    Line line = diagnostics_.line();
    for (word_ = next_token(rest_); word_.empty(); word_ = next_token(rest_)) {
      if (!lines_.next(line)) return;
      rest_ = line.text;
      diagnostics_.begin_line(line);
    }
  }

  bool is_facet() const {
    std::string_view rest = rest_;
    return is("facet") && to_lower_ascii(next_token(rest)) == "normal";
  }

  /// Takes a keyword and the name in the rest of its line, or up to what `is_end` says: there may be no line breaks.
  template <class IsEnd>
  std::string take_with_name(IsEnd const& is_end) {
    std::size_t const line = diagnostics_.line().number;
    std::string name;
    for (take(); !is_at_end() && diagnostics_.line().number == line && !is_end(); take()) {
      name += name.empty() ? "" : " ";
      name += word_;
    }
    return name;
  }

  void warn_missing(std::string_view what) const {
    diagnostics_.add(Severity::warning, DiagnosticCode::stl_text, is_at_end() ? place_after(last_) : word_,
                     is_at_end() ? fmt::format("the file ends where '{}' is missing", what)
                                 : fmt::format("expected '{}', found {}", what, in_quotes(word_)));
  }
  /// Takes a word that must come here; else false after a warning.
  bool take(std::string_view keyword) {
    if (is(keyword)) {
      take();
      return true;
    }
    warn_missing(keyword);
    return false;
  }
  /// Takes a number; else false after a warning.
  bool take_number(double& number) {
    if (is_at_end()) warn_missing("endfacet");
    if (is_at_end() || !read_number(word_, number, diagnostics_)) return false;
    take();
    return true;
  }

 private:
  LineReader lines_;
  Diagnostics& diagnostics_;
  std::string_view rest_;
  Token word_;
  Token last_;
};

/// Reads `vertex x y z`, three times, and what is around it; false after a warning.
bool read_facet(Words& words, Vec3 const& origin, Solid& solid, Bounds& extent) {
  if (!words.take("facet") || !words.take("normal")) return false;
  for (int i = 0; i < 3 && !words.is("outer"); ++i) words.take();  // as good as computed ones, and often wrong
  if (!words.take("outer") || !words.take("loop")) return false;
  Vec3 corners[3];
  for (Vec3& corner : corners) {
    if (!words.take("vertex")) return false;
    for (int i = 0; i < 3; ++i) {
      if (!words.take_number(corner[i])) return false;
    }
  }
  if (!words.take("endloop") || !words.take("endfacet")) return false;
  for (Vec3 const& corner : corners) {
    extent.add(corner);
    solid.corners.push_back(to_float3(corner - origin));
  }
  return true;
}

}  // namespace

Solids read_ascii(std::string_view text, Diagnostics& diagnostics, Vec3 const& origin) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Words words(text, diagnostics);
  if (!words.is("solid")) {
    diagnostics.add(Severity::error, DiagnosticCode::not_stl, words.word(),
                    "this is not an STL file: it does not begin with 'solid'");
    return {};
  }
  Solids result;
  while (!words.is_at_end()) {
    if (!words.is("solid")) {
      words.warn_missing("solid");
      while (!words.is_at_end() && !words.is("solid")) words.take();
      continue;
    }
    Solid solid;
    solid.name = words.take_with_name([&] { return words.is_facet() || words.is("endsolid"); });
    bool is_told = true;  // where the file ends
    while (!words.is_at_end() && !words.is("endsolid") && !words.is("solid")) {
      is_told = !read_facet(words, origin, solid, result.extent);
      while (is_told && !words.is_at_end() && !words.is("facet") && !words.is("endsolid")) words.take();
    }
    if (words.is("endsolid")) {
      words.take_with_name([&] { return words.is("solid"); });
    } else if (words.is_at_end() && !is_told) {
      words.warn_missing("endsolid");
    }
    if (!solid.corners.empty()) result.solids.push_back(std::move(solid));
  }
  return result;
}

}  // namespace lichtraum::stl
