#include "io/ply/ply_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/ascii.hpp"
#include "core/srgb.hpp"
#include "io/model_scene.hpp"
#include "io/ply/ply_sources.hpp"
#include "io/polygon.hpp"
#include "io/triangles.hpp"

namespace lichtraum::ply {
namespace {

/// What a property of a vertex or an edge is: a place in a row of numbers.
enum Slot : std::size_t {
  x,
  y,
  z,
  nx,
  ny,
  nz,
  u,
  v,
  begin,
  end,
  red,
  green,
  blue,
  alpha,
  slot_count,
  none = slot_count
};

struct SlotName {
  std::string_view name;
  Slot slot;
};
constexpr SlotName slot_names[] = {
    {"x", x},
    {"y", y},
    {"z", z},
    {"nx", nx},
    {"ny", ny},
    {"nz", nz},
    {"normal_x", nx},
    {"normal_y", ny},
    {"normal_z", nz},
    {"u", u},
    {"v", v},
    {"s", u},
    {"t", v},
    {"texture_u", u},
    {"texture_v", v},
    {"texture_s", u},
    {"texture_t", v},
    {"texcoord_x", u},
    {"texcoord_y", v},
    {"red", red},
    {"green", green},
    {"blue", blue},
    {"alpha", alpha},
    {"r", red},
    {"g", green},
    {"b", blue},
    {"a", alpha},
    {"diffuse_red", red},
    {"diffuse_green", green},
    {"diffuse_blue", blue},
    {"vertex1", begin},
    {"vertex2", end},
};

Slot slot_of(std::string const& name) {
  std::string const word = to_lower_ascii(name);
  for (SlotName const& known : slot_names) {
    if (known.name == word) return known.slot;
  }
  return none;
}

/// The largest value of a colour's type: 1 for floats.
double full_scale(Type type) {
  switch (type) {
    case Type::int8:
      return 127;
    case Type::uint8:
      return 255;
    case Type::int16:
      return 32767;
    case Type::uint16:
      return 65535;
    case Type::int32:
    case Type::uint32:
      return 255;  // colours of 0..255 that were written carelessly
    case Type::float32:
    case Type::float64:
      return 1;
  }
  return 1;
}

template <class Source>
class DataReader {
 public:
  DataReader(Source source, bool reads_edges) : source_(std::move(source)), reads_edges_(reads_edges) {}

  MeshGeometry run(std::vector<Element> const& elements) {
    for (Element const& element : elements) {
      if (element.properties.empty()) continue;
      bool const is_whole = element.name == "vertex"                           ? vertices(element)
                            : element.name == "face" && has_list(element)      ? faces(element, false)
                            : element.name == "tristrips" && has_list(element) ? faces(element, true)
                            : element.name == "edge" && reads_edges_           ? edges(element)
                                                                               : skip(element);
      if (!is_whole) break;  // told already
    }
    return std::move(geometry_);
  }

 private:
  bool ends_early(Element const& element, std::uint64_t number) {
    source_.warn(fmt::format("the data ends in {} {} of {}", element.name, number, element.count));
    return false;
  }

  /// How the properties of an element become a row.
  struct Columns {
    std::vector<Slot> slots;
    std::vector<double> scales;
    std::array<bool, slot_count + 1> has{};

    explicit Columns(Element const& element) {
      for (Property const& property : element.properties) {
        slots.push_back(property.is_list ? none : slot_of(property.name));
        scales.push_back(slots.back() >= red && slots.back() != none ? full_scale(property.type) : 1);
        has[slots.back()] = true;
      }
    }
    bool has_colors() const { return has[red] && has[green] && has[blue]; }
  };

  bool read_row(Element const& element, Columns const& columns) {
    for (std::size_t k = 0; k < columns.slots.size(); ++k) {
      Property const& property = element.properties[k];
      double& value = row_[columns.slots[k]];
      if (!(property.is_list ? skip_list(property) : source_.number(property.type, value))) return false;
      if (columns.scales[k] != 1) value /= columns.scales[k];
    }
    return true;
  }

  Float4 color_of_row() const {
    return {linear(row_[red]), linear(row_[green]), linear(row_[blue]), finite(row_[alpha])};
  }

  bool vertices(Element const& element) {
    Columns const columns(element);
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
    row_[alpha] = 1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element, columns)) return ends_early(element, i);
      geometry_.positions.push_back({float(row_[x]), float(row_[y]), float(row_[z])});
      if (has_normals) geometry_.normals.push_back(unit({row_[nx], row_[ny], row_[nz]}));
      if (has_texcoords) geometry_.texcoords[0].push_back({finite(row_[u]), finite(1 - row_[v])});
      if (columns.has_colors()) geometry_.colors.push_back(color_of_row());
    }
    return true;
  }

  bool edges(Element const& element) {
    Columns const columns(element);
    if (!columns.has[begin] || !columns.has[end]) {
      source_.warn("the edges have no vertex1 and vertex2");
      return skip(element);
    }
    std::vector<Float4> colors;
    row_[alpha] = 1;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element, columns)) return ends_early(element, i);
      for (Slot const slot : {begin, end}) geometry_.lines.push_back(vertex_number(row_[slot]));
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
  /// Nearly all colours are bytes: then the logarithms are in a table.
  float linear(double value) const {
    double const byte = value * 255;
    if (byte >= 0 && byte <= 255 && byte == std::floor(byte)) return linear_bytes_[std::size_t(byte)];
    return float(linear_from_srgb(double(finite(value))));
  }

  static bool is_index_list(Property const& p) {
    return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
  }
  static bool has_list(Element const& element) {
    return std::any_of(element.properties.begin(), element.properties.end(), is_index_list);
  }

  bool faces(Element const& element, bool are_strips) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (Property const& property : element.properties) {
        if (!is_index_list(property)) {
          if (!(property.is_list ? skip_list(property) : source_.skip(property.type, 1))) return ends_early(element, i);
          continue;
        }
        std::uint64_t count = 0;
        if (!list_count(property, count)) return ends_early(element, i);
        corners_.clear();
        for (std::uint64_t k = 0; k < count; ++k) {
          double index = 0;
          if (!source_.number(property.type, index)) return ends_early(element, i);
          corners_.push_back(vertex_number(index));
        }
        if (are_strips) {
          add_strips();
        } else {
          add_polygon(element, i);
        }
      }
    }
    return true;
  }

  static std::uint32_t vertex_number(double value) {
    return value >= 0 && value < double(no_vertex) ? std::uint32_t(value) : no_vertex;
  }

  /// Each line has its colours at both ends, whatever meets it there.
  static MeshGeometry give_own_ends(MeshGeometry const& shared, std::vector<Float4> colors) {
    MeshGeometry own;
    for (std::uint32_t const vertex : shared.lines) {
      bool const is_there = vertex < shared.positions.size();
      own.lines.push_back(is_there ? std::uint32_t(own.positions.size()) : no_vertex);
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
    if (corners_.size() == 3) {
      geometry_.indices.insert(geometry_.indices.end(), corners_.begin(), corners_.end());
      return;
    }
    points_.clear();
    for (std::uint32_t const corner : corners_) {
      points_.push_back(corner < geometry_.positions.size() ? geometry_.positions[corner] : Float3{0, 0, 0});
    }
    triangles_.clear();
    triangulate(points_, triangles_);
    for (auto const& triangle : triangles_) {
      for (std::uint32_t const i : triangle) geometry_.indices.push_back(corners_[i]);
    }
  }

  /// A negative number begins the next strip.
  void add_strips() {
    for (auto begin = corners_.begin(); begin != corners_.end();) {
      auto const end = std::find(begin, corners_.end(), no_vertex);
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

  static constexpr std::uint32_t no_vertex = 0xFFFFFFFF;

  static std::array<float, 256> make_linear_bytes() {
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = float(linear_from_srgb(double(float(i) / 255)));
    return table;
  }

  Source source_;
  bool reads_edges_;
  MeshGeometry geometry_;
  std::array<double, slot_count + 1> row_{};  // of a vertex or an edge; what none of its properties is stays
  std::array<float, 256> linear_bytes_ = make_linear_bytes();
  bool has_told_small_ = false;
  std::vector<std::uint32_t> corners_;  // of one face; these are kept for their memory
  std::vector<Float3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

MeshGeometry read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics) {
  bool const reads_edges = header.draws() == Drawn::lines;
  if (header.encoding == Encoding::ascii) {
    AsciiSource source(bytes.substr(header.data_offset), header.data_line, diagnostics);
    return DataReader(std::move(source), reads_edges).run(header.elements);
  }
  BinarySource source(bytes, header.data_offset, header.encoding == Encoding::big_endian, diagnostics);
  return DataReader(std::move(source), reads_edges).run(header.elements);
}

}  // namespace lichtraum::ply
