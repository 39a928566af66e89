#include "io/obj/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_set>
#include <utility>

#include "core/counted.hpp"
#include "core/float3.hpp"
#include "io/far_origin.hpp"
#include "io/faulty_geometry.hpp"
#include "io/float_colors.hpp"
#include "io/obj/part_lists.hpp"
#include "io/obj/smooth_normals.hpp"
#include "io/polygon.hpp"
#include "io/text/numbers.hpp"

namespace lichtraum::obj {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr Float3 no_color{nan, nan, nan};

class ObjReader {
 public:
  explicit ObjReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  ObjFile run(std::string_view text) {
    LineReader lines(text);
    Line line;
    while (lines.next(line)) {
      std::string_view rest = line.text;
      Token const keyword = next_token(rest);
      if (keyword.empty() || keyword[0] == '#') continue;
      diagnostics_.begin_line(line);
      statement(keyword, rest);
    }
    parts_.choose(file_, written_.size(), diagnostics_);
    round_positions();
    remove_faulty();
    std::erase_if(file_.parts, [](Part const& part) { return part.corners.empty(); });
    add_smooth_normals(file_);
    finish_colors();
    return std::move(file_);
  }

 private:
  void statement(Token keyword, std::string_view rest) {
    if (keyword == "v") return position(rest);
    if (keyword == "f" || keyword == "fo") return face(keyword, rest);
    if (keyword == "l") return line(keyword, rest);
    if (keyword == "p") return points(keyword, rest);
    if (keyword == "vn") return normal(rest);
    if (keyword == "vt") return texcoord(rest);
    if (keyword == "usemtl") return use_material(keyword, rest);
    if (keyword == "s") return smoothing_group(rest);
    if (keyword == "o") return parts_.set_object(trimmed(rest));
    if (keyword == "g") return parts_.set_group(trimmed(rest));
    if (keyword == "mtllib") return library(keyword, rest);
    for (std::string_view const known : {"mg", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj",
                                         "usemap", "maplib", "vp", "end", "parm", "trim", "hole", "scrv", "sp"}) {
      if (keyword == known) return;  // says nothing about triangles
    }
    for (std::string_view const known :
         {"cstype", "deg", "curv", "curv2", "surf", "bmat", "step", "con", "stech", "ctech"}) {
      if (keyword == known) return free_form();
    }
    diagnostics_.add(Severity::warning, DiagnosticCode::unknown_obj_keyword, keyword,
                     fmt::format("unknown OBJ keyword {}: the line is left out", in_quotes(keyword)));
  }

  void free_form() {
    parts_.note(Drawn::triangles, diagnostics_.line());  // so that what it names is not drawn as points
    if (std::exchange(has_free_forms_, true)) return;
    diagnostics_.add(Severity::warning, DiagnosticCode::undrawn_obj, {}, "free-form curves and surfaces are not drawn");
  }

  bool number(Token word, float& out) {
    double value = 0;
    if (!read_number(word, value, diagnostics_)) return false;
    out = float(value);
    return true;
  }

  using Read = bool (*)(Token word, double& value, Diagnostics& diagnostics);

  /// False after a warning when there are fewer.
  bool numbers(std::string_view& rest, Vec3& values, Read read = read_number) {
    constexpr int count = 3;
    for (int i = 0; i < count; ++i) {
      Token const word = next_token(rest);
      if (word.empty()) {
        diagnostics_.add(Severity::warning, DiagnosticCode::faulty_number, word,
                         fmt::format("expected {} numbers, found {}", count, i));
        return false;
      }
      if (!read(word, values[i], diagnostics_)) return false;
    }
    return true;
  }

  // A faulty vertex keeps its number, so that the faces name the right ones.
  void position(std::string_view rest) {
    Vec3 point(0);
    if (!numbers(rest, point)) point = Vec3(nan);
    written_.push_back(point);
    Token const fourth = next_token(rest);
    if (fourth.empty() || fourth[0] == '#') return;
    Token const fifth = next_token(rest), sixth = next_token(rest);
    if (fifth.empty() || sixth.empty()) return;  // a weight, which is for curves
    Float3 color = no_color;
    bool const is_color = number(fourth, color[0]) && number(fifth, color[1]) && number(sixth, color[2]);
    if (!is_color) return;
    file_.colors.resize(written_.size() - 1, no_color);
    file_.colors.push_back(color);
  }

  /// Vertices that nothing names do not say where the model lies.
  void round_positions() {
    Bounds extent;
    for (Part const& part : file_.parts) {
      for (Corner const& corner : part.corners) {
        if (is_there(corner) && is_finite(to_float3(written_[corner.position]))) extent.add(written_[corner.position]);
      }
    }
    file_.origin = far_origin(extent);
    Vec3 const origin = file_.origin.value_or(Vec3(0));
    file_.positions.reserve(written_.size());
    for (Vec3 const& point : written_) file_.positions.push_back(to_float3(point - origin));
  }

  /// Vertices without one are white.
  void finish_colors() {
    if (file_.colors.empty()) return;
    file_.colors.resize(file_.positions.size(), no_color);
    float largest = 0;
    for (Float3 const& color : file_.colors) {
      for (float const channel : color) largest = std::max(largest, channel);  // not if it is no number
    }
    float const white = white_of(largest);
    for (Float3& color : file_.colors) {
      for (float& channel : color) channel = std::isnan(channel) ? 1 : channel / white;
    }
    if (white == 1) return;
    diagnostics_.begin_line({});
    diagnostics_.add(Severity::warning, DiagnosticCode::faulty_number, {}, read_to_white(largest, "OBJ's"));
  }

  void normal(std::string_view rest) {
    Vec3 written(0);
    if (!numbers(rest, written, read_number_or_nan)) written = Vec3(0);  // nan: of a surface without any
    Float3 n = to_float3(written);
    double const length = std::hypot(double(n[0]), double(n[1]), double(n[2]));
    for (float& x : n) x = length > 0 ? float(double(x) / length) : 0;
    file_.normals.push_back(n);
  }

  void texcoord(std::string_view rest) {
    Float2 uv{0, 0};
    Token const u = next_token(rest), v = next_token(rest);
    if (u.empty())
      diagnostics_.add(Severity::warning, DiagnosticCode::faulty_number, u, "expected a texture coordinate");
    bool const is_good = !u.empty() && number(u, uv[0]) && (v.empty() || number(v, uv[1]));
    file_.texcoords.push_back(is_good ? Float2{uv[0], 1 - uv[1]} : Float2{0, 0});  // OBJ counts v from below
  }

  void face(Token keyword, std::string_view rest) {
    if (!read_corners(keyword, rest, Drawn::triangles)) return;
    points_.assign(corners_.size(), Float3{0, 0, 0});  // where its shape is not known yet: a fan
    if (std::ranges::all_of(corners_, [&](Corner const& c) { return is_there(c); })) {
      Vec3 const first = written_[corners_[0].position];
      std::ranges::transform(corners_, points_.begin(),
                             [&](Corner const& c) { return to_float3(written_[c.position] - first); });
    }
    Part& part = parts_.part_for(Drawn::triangles, diagnostics_);
    triangles_.clear();
    triangulate(points_, triangles_);
    for (auto const& triangle : triangles_) {
      for (std::uint32_t const i : triangle) part.corners.push_back(corners_[i]);
    }
    part.smoothing_groups.resize(part.corners.size() / 3, smoothing_group_);
  }

  void line(Token keyword, std::string_view rest) {
    if (!read_corners(keyword, rest, Drawn::lines)) return;
    Part& part = parts_.part_for(Drawn::lines, diagnostics_);
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
      part.corners.push_back(corners_[i]);
      part.corners.push_back(corners_[i + 1]);
    }
  }

  void points(Token keyword, std::string_view rest) {
    if (!read_corners(keyword, rest, Drawn::points)) return;
    Part& part = parts_.part_for(Drawn::points, diagnostics_);
    part.corners.insert(part.corners.end(), corners_.begin(), corners_.end());
  }

  /// Names a vertex that is above its line, or, at the end of the file, anywhere.
  bool is_there(Corner const& corner) const { return corner.position < written_.size(); }

  /// All on the line, into `corners_`. False after a warning.
  bool read_corners(Token keyword, std::string_view rest, Drawn drawn) {
    std::string_view const what = PartLists::noun(drawn);
    parts_.note(drawn, diagnostics_.line());
    corners_.clear();
    for (Token word = next_token(rest); !word.empty() && word[0] != '#'; word = next_token(rest)) {
      Corner corner;
      if (!read_corner(word, corner)) {
        diagnostics_.add(
            Severity::warning, DiagnosticCode::faulty_face, word,
            fmt::format("expected vertex/texture/normal, found {}: the {} is left out", in_quotes(word), what));
        return false;
      }
      if (!is_there(corner) && mentions_.size() < max_mentions) {
        mentions_.push_back({{diagnostics_.line(), word}, corner.position});
      }
      corners_.push_back(corner);
    }
    if (corners_.size() >= corners_of(drawn)) return true;
    diagnostics_.add(Severity::warning, DiagnosticCode::faulty_face, keyword,
                     fmt::format("a {} of {} is left out", what, counted(corners_.size(), "corner")));
    return false;
  }

  bool read_corner(Token word, Corner& corner) {
    char const* at = word.data();
    char const* const end = at + word.size();
    if (!read_index(at, end, written_.size(), corner.position)) return false;
    if (at == end) return true;
    if (*at++ != '/' || at == end) return at == end;  // "1/": some write that
    if (*at != '/' && !read_attribute(at, end, file_.texcoords.size(), corner.texcoord)) return false;
    if (at == end) return true;
    if (*at++ != '/') return false;
    return at == end || (read_attribute(at, end, file_.normals.size(), corner.normal) && at == end);
  }

  /// As read_index, but 0 is one that is not there: Cinema 4D and OpenMVS write that of corners without any.
  static bool read_attribute(char const*& at, char const* end, std::size_t size, std::uint32_t& index) {
    std::int64_t value = 0;
    auto const [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || value != 0) return read_index(at, end, size, index);
    at = rest;
    index = Corner::none - 1;
    return true;
  }

  /// Counts from 1; -1 is the last one so far.
  static bool read_index(char const*& at, char const* end, std::size_t size, std::uint32_t& index) {
    std::int64_t value = 0;
    auto const [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || value == 0) return false;
    at = rest;
    std::int64_t const found = value > 0 ? value - 1 : std::int64_t(size) + value;
    if (found < 0 || found >= std::int64_t(Corner::none)) return false;
    index = std::uint32_t(found);
    return true;
  }

  void smoothing_group(std::string_view rest) {
    Token const word = next_token(rest);
    smoothing_group_ = word == "on" ? 1 : 0;
    if (word == "on" || word == "off") return;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), smoothing_group_);
    if (error == std::errc() && end == word.data() + word.size()) return;
    diagnostics_.add(Severity::warning, DiagnosticCode::faulty_number, word,
                     fmt::format("expected a smoothing group's number or off, found {}", in_quotes(word)));
  }

  void use_material(Token keyword, std::string_view rest) {
    Token const name = trimmed(rest);
    if (name.empty())
      diagnostics_.add(Severity::warning, DiagnosticCode::missing_obj_word, keyword, "usemtl: expected a name");
    parts_.set_material(name);
    if (!name.empty() && known_materials_.insert(std::string(name)).second) {
      file_.used_materials.push_back({diagnostics_.line(), name});
    }
  }

  void library(Token keyword, std::string_view rest) {
    Token const names = trimmed(rest);
    if (names.empty())
      return diagnostics_.add(Severity::warning, DiagnosticCode::missing_obj_word, keyword, "mtllib: expected a file");
    file_.libraries.push_back({diagnostics_.line(), names});
  }

  void remove_faulty() {
    std::size_t out_of_range = 0, non_finite = 0;
    std::size_t const count = corners_of(file_.draws);
    for (Part& part : file_.parts) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i + count <= part.corners.size(); i += count) {
        std::span const corners(&part.corners[i], count);
        if (!std::ranges::all_of(corners, [&](Corner const& c) { return is_there(c); })) {
          ++out_of_range;
        } else if (!std::ranges::all_of(corners, [&](auto& c) { return is_finite(file_.positions[c.position]); })) {
          ++non_finite;
        } else {
          if (file_.draws == Drawn::triangles) part.smoothing_groups[kept / 3] = part.smoothing_groups[i / 3];
          for (std::size_t k = 0; k < count; ++k) part.corners[kept++] = checked(part.corners[i + k]);
        }
      }
      part.corners.resize(kept);
      if (file_.draws == Drawn::triangles) part.smoothing_groups.resize(kept / 3);
    }
    for (auto const& [mention, position] : mentions_) {
      if (position < file_.positions.size()) continue;
      diagnostics_.begin_line(mention.line);
      diagnostics_.add(Severity::warning, DiagnosticCode::missing_vertex, mention.word,
                       fmt::format("there is no vertex {}; the file has {}", position + 1, file_.positions.size()));
    }
    diagnostics_.begin_line({});
    if (out_of_range > 0) left_out(out_of_range, "a vertex that is not there");
    if (non_finite > 0) left_out(non_finite, "a vertex that is not finite");
    if (missing_attributes_ > 0) {
      diagnostics_.add(
          Severity::warning, DiagnosticCode::missing_vertex, {},
          fmt::format("{} {} a texture coordinate or normal that is not there", counted(missing_attributes_, "corner"),
                      missing_attributes_ == 1 ? "names" : "name"));
    }
  }

  /// Only surfaces have texture coordinates and normals.
  Corner checked(Corner corner) {
    if (file_.draws != Drawn::triangles) return {.position = corner.position};
    if (corner.texcoord != Corner::none && corner.texcoord >= file_.texcoords.size()) {
      corner.texcoord = Corner::none;
      ++missing_attributes_;
    }
    if (corner.normal != Corner::none && corner.normal >= file_.normals.size()) {
      corner.normal = Corner::none;
      ++missing_attributes_;
    }
    return corner;
  }

  void left_out(std::size_t count, std::string_view why) {
    std::string_view const noun = file_.draws == Drawn::triangles ? "triangle" : PartLists::noun(file_.draws);
    diagnostics_.add(Severity::warning, DiagnosticCode::geometry_left_out, {}, left_out_message(count, why, noun));
  }

  static std::size_t corners_of(Drawn drawn) { return 3 - std::size_t(drawn); }

  static constexpr std::size_t max_mentions = 1000;

  Diagnostics& diagnostics_;
  std::vector<Vec3> written_;  // positions; floats would not do far from the origin
  ObjFile file_;
  std::uint32_t smoothing_group_ = 0;
  PartLists parts_;
  std::unordered_set<std::string> known_materials_;
  bool has_free_forms_ = false;
  std::vector<std::pair<Mention, std::uint32_t>> mentions_;  // of vertices that were not there yet
  std::size_t missing_attributes_ = 0;
  // Of one face, line or list of points; kept for their memory.
  std::vector<Corner> corners_;
  std::vector<Float3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

ObjFile read_obj(std::string_view text, Diagnostics& diagnostics) { return ObjReader(diagnostics).run(text); }

void join_continued_lines(std::string& text) {
  if (text.find("\\\n") == std::string::npos && text.find("\\\r\n") == std::string::npos) return;
  std::string joined;
  joined.reserve(text.size());
  std::size_t pending = 0;  // line breaks that were left out
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::size_t const line_break = text[i] != '\\'                       ? 0
                                   : text.compare(i + 1, 1, "\n") == 0   ? 1
                                   : text.compare(i + 1, 2, "\r\n") == 0 ? 2
                                                                         : 0;
    if (line_break > 0) {
      joined += ' ';
      ++pending;
      i += line_break;
    } else {
      joined += text[i];
      if (text[i] != '\n') continue;
      joined.append(pending, '\n');
      pending = 0;
    }
  }
  text = std::move(joined);
}

}  // namespace lichtraum::obj
