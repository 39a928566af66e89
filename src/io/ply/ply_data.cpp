#include "io/ply/ply_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/float3.hpp"
#include "core/srgb.hpp"
#include "io/model_scene.hpp"
#include "io/ply/columns.hpp"
#include "io/ply/ply_sources.hpp"
#include "io/polygon.hpp"
#include "io/triangles.hpp"
#include "shared/srgb.h"

namespace lichtraum::ply {
namespace {

template <class Source>
class DataReader {
 public:
  DataReader(Source source, Drawn drawn, Reading const& reading)
      : source_(std::move(source)), drawn_(drawn), reading_(reading) {}

  Data run(std::vector<Element> const& elements) {
    for (Element const& element : elements) {
      if (element.properties.empty()) continue;
      bool const is_whole = element.name == "vertex"                           ? vertices(element)
                            : element.name == "face"                           ? faces(element, false)
                            : element.name == "tristrips"                      ? faces(element, true)
                            : element.name == "edge" && drawn_ == Drawn::lines ? edges(element)
                                                                               : skip(element);
      if (!is_whole) break;  // told already
    }
    faces_.resize(geometry_.triangle_count());
    return {std::move(geometry_), std::move(faces_), extent_, largest_color_, are_splats_, faint_splats_};
  }

 private:
  using Slot = Columns::Slot;
  using enum Columns::Slot;

  bool ends_early(Element const& element, std::uint64_t number) {
    source_.warn(fmt::format("the data ends in {} {} of {}", element.name, number, element.count));
    return false;
  }

  bool read_row(Element const& element, Columns const& columns) {
    for (std::size_t k = 0; k < columns.slots.size(); ++k) {
      if (!read_property(element.properties[k], columns.slots[k], columns.ranges[k])) return false;
    }
    return true;
  }
  bool read_property(Property const& property, Slot slot, Columns::Range const& range) {
    if (property.is_list) return skip_list(property);
    double& value = row_[slot];
    if (!source_.number(property.type, value)) return false;
    if (range.divisor != 1) value = value / range.divisor + range.offset;
    if (range.is_clamped) value = std::clamp(value, 0.0, 1.0);
    if (range.is_float_color) largest_color_ = std::max(largest_color_, finite(value));
    return true;
  }

  Float4 color_of_row() const {
    return {linear(row_[red]), linear(row_[green]), linear(row_[blue]), finite(row_[alpha])};
  }

  bool vertices(Element const& element) {
    Columns const columns(element, reading_.float_white);
    auto const& has = columns.has;
    if (!has[x] || !has[y] || !has[z]) {
      source_.warn("the vertices have no x, y and z");
      return skip(element);
    }
    bool const has_normals = has[nx] && has[ny] && has[nz];
    bool const has_texcoords = has[u] && has[v];
    if (has_texcoords) geometry_.texcoords.emplace_back();
    // A header may promise more than the file holds.
    std::uint64_t const possible = source_.capacity(Type::uint8) / element.properties.size();
    geometry_.positions.reserve(std::size_t(std::min(element.count, possible)));
    are_splats_ = columns.are_splats && drawn_ == Drawn::points;
    row_[alpha] = 1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element, columns)) return ends_early(element, i);
      if (are_splats_ && has[opacity] && !(row_[opacity] >= 0)) {
        ++faint_splats_;
        continue;
      }
      Vec3 const point(row_[x], row_[y], row_[z]);
      bool const counts = !reading_.drawn || (i < reading_.drawn->size() && (*reading_.drawn)[i]);
      if (counts && is_finite(to_float3(point))) extent_.add(point);
      geometry_.positions.push_back(to_float3(point - reading_.origin));
      if (has_normals) geometry_.normals.push_back(unit({row_[nx], row_[ny], row_[nz]}));
      if (has_texcoords) geometry_.texcoords[0].push_back({finite(row_[u]), finite(1 - row_[v])});
      if (columns.has_colors()) geometry_.colors.push_back(color_of_row());
    }
    return true;
  }

  bool edges(Element const& element) {
    Columns const columns(element, reading_.float_white);
    if (!columns.has[begin] || !columns.has[end]) {
      source_.warn("the edges have no vertex1 and vertex2");
      return skip(element);
    }
    std::vector<Float4> colors;
    row_[alpha] = 1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element, columns)) return ends_early(element, i);
      for (Slot const slot : {begin, end}) geometry_.lines.push_back(number_of(row_[slot]));
      if (columns.has_colors()) colors.insert(colors.end(), 2, color_of_row());
    }
    if (columns.has_colors()) geometry_ = give_own_ends(geometry_, std::move(colors));
    return true;
  }

  static float finite(double value) { return std::isfinite(float(value)) ? float(value) : 0.0f; }
  static Float3 unit(Vec3 const& n) {
    double const length = std::hypot(n.x, n.y, n.z);
    if (!(length > 0 && std::isfinite(length))) return {0, 0, 0};
    return {float(n.x / length), float(n.y / length), float(n.z / length)};
  }
  /// Nearly all colours are bytes, which there is a table for.
  float linear(double value) const {
    double const byte = value * 255;
    if (byte >= 0 && byte <= 255 && byte == std::floor(byte)) return device::linear_from_srgb_table[std::size_t(byte)];
    return float(linear_from_srgb(double(finite(value))));
  }

  bool faces(Element const& element, bool are_strips) {
    Columns const columns(element, reading_.float_white);
    if (!columns.has[corners]) return skip(element);
    if (!are_strips) {
      faces_.has_texcoords = columns.has[texcoords];
      faces_.has_colors = columns.has_colors();
      faces_.has_pictures = columns.has[picture];
      faces_.resize(geometry_.triangle_count());
    }
    row_[alpha] = 1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_face(element, columns)) return ends_early(element, i);
      if (are_strips) {
        add_strips();
      } else {
        add_polygon(element, i);
      }
    }
    return true;
  }

  bool read_face(Element const& element, Columns const& columns) {
    for (std::size_t k = 0; k < columns.slots.size(); ++k) {
      Property const& property = element.properties[k];
      Slot const slot = columns.slots[k];
      bool const is_whole = slot == corners     ? read_list(property, corners_, number_of)
                            : slot == texcoords ? read_list(property, uvs_, finite)
                                                : read_property(property, slot, columns.ranges[k]);
      if (!is_whole) return false;
    }
    return true;
  }

  template <class Value>
  bool read_list(Property const& property, std::vector<Value>& list, Value (*value_of)(double)) {
    std::uint64_t count = 0;
    if (!list_count(property, count)) return false;
    list.clear();
    for (std::uint64_t k = 0; k < count; ++k) {
      double number = 0;
      if (!source_.number(property.type, number)) return false;
      list.push_back(value_of(number));
    }
    return true;
  }

  static std::uint32_t number_of(double value) {
    return value >= 0 && value < double(no_number) ? std::uint32_t(value) : no_number;
  }

  /// Each line has its colours at both ends, whatever meets it there.
  static MeshGeometry give_own_ends(MeshGeometry const& shared, std::vector<Float4> colors) {
    MeshGeometry own;
    for (std::uint32_t const vertex : shared.lines) {
      bool const is_there = vertex < shared.positions.size();
      own.lines.push_back(is_there ? std::uint32_t(own.positions.size()) : no_number);
      own.positions.push_back(is_there ? shared.positions[vertex] : Float3{0, 0, 0});
    }
    own.colors = std::move(colors);
    return own;
  }

  void add_polygon(Element const& element, std::uint64_t number) {
    if (corners_.size() < 3) {
      if (!has_told_small_)
        source_.warn(
            fmt::format("{} {} has {} corners: left out, as all of these", element.name, number, corners_.size()));
      has_told_small_ = true;
      return;
    }
    bool const has_uvs = uvs_.size() == 2 * corners_.size();
    if (!has_uvs && !uvs_.empty() && !has_told_uvs_) {
      source_.warn(fmt::format("{} {} has {} texture coordinates for {} corners: left out, as all of these",
                               element.name, number, uvs_.size(), corners_.size()));
      has_told_uvs_ = true;
    }
    if (corners_.size() == 3) return add_triangle({0, 1, 2}, has_uvs);
    points_.clear();
    for (std::uint32_t const corner : corners_) {
      points_.push_back(corner < geometry_.positions.size() ? geometry_.positions[corner] : Float3{0, 0, 0});
    }
    triangles_.clear();
    triangulate(points_, triangles_);
    for (auto const& triangle : triangles_) add_triangle(triangle, has_uvs);
  }

  /// `triangle`: which of the corners of the face.
  void add_triangle(std::array<std::uint32_t, 3> const& triangle, bool has_uvs) {
    for (std::uint32_t const i : triangle) geometry_.indices.push_back(corners_[i]);
    if (faces_.has_texcoords) {
      for (std::uint32_t const i : triangle) {
        faces_.texcoords.push_back(has_uvs ? std::optional(Float2{uvs_[2 * i], 1 - uvs_[2 * i + 1]}) : std::nullopt);
      }
    }
    if (faces_.has_colors) faces_.colors.push_back(color_of_row());
    if (faces_.has_pictures) faces_.pictures.push_back(number_of(row_[picture]));
  }

  /// A negative number begins the next strip.
  void add_strips() {
    for (auto begin = corners_.begin(); begin != corners_.end();) {
      auto const end = std::find(begin, corners_.end(), no_number);
      std::vector<std::uint32_t> const list = to_triangle_list({begin, end}, 5);
      geometry_.indices.insert(geometry_.indices.end(), list.begin(), list.end());
      begin = end == corners_.end() ? end : end + 1;
    }
  }

  bool list_count(Property const& property, std::uint64_t& count) {
    double value = 0;
    if (!source_.number(property.count_type, value)) return false;
    if (!(value >= 0 && value <= double(source_.capacity(property.type)))) {
      source_.warn(fmt::format("a list declares {} numbers", value));
      return false;
    }
    count = std::uint64_t(value);
    return true;
  }

  bool skip_list(Property const& property) {
    std::uint64_t count = 0;
    return list_count(property, count) && source_.skip(property.type, count);
  }

  bool skip(Element const& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (Property const& property : element.properties) {
        if (!(property.is_list ? skip_list(property) : source_.skip(property.type, 1))) return ends_early(element, i);
      }
    }
    return true;
  }

  Source source_;
  Drawn drawn_;
  Reading reading_;
  Bounds extent_;
  float largest_color_ = 0;
  bool are_splats_ = false;
  std::size_t faint_splats_ = 0;
  MeshGeometry geometry_;
  FaceAttributes faces_;
  std::array<double, slot_count + 1> row_{};  // of a vertex, an edge or a face; what none of its properties is stays
  bool has_told_small_ = false;
  bool has_told_uvs_ = false;
  std::vector<std::uint32_t> corners_;  // of one face; these are kept for their memory
  std::vector<float> uvs_;              // two for each of the corners
  std::vector<Float3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

Data read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics, Reading const& reading) {
  if (header.encoding == Encoding::ascii) {
    AsciiSource source(bytes.substr(header.data_offset), header.data_line, diagnostics);
    return DataReader(std::move(source), header.draws(), reading).run(header.elements);
  }
  BinarySource source(bytes, header.data_offset, header.encoding == Encoding::big_endian, diagnostics);
  return DataReader(std::move(source), header.draws(), reading).run(header.elements);
}

}  // namespace lichtraum::ply
