#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/buffers.hpp"

namespace lichtraum::gltf {

/// An accessor's elements as floats, one after the other.
struct FloatElements {
  std::size_t components = 0;  ///< per element: 1..4, or 16 for a 4 x 4 matrix
  std::vector<float> values;
  std::size_t count() const { return components == 0 ? 0 : values.size() / components; }
};

/// The one place that reads accessors (glTF 2.0, section 3.6.2): every component type, normalised, strided, sparse, or
/// without a view (zeros). All bounds are checked; what cannot be read is a finding at the place that wanted it.
class Accessors {
 public:
  Accessors(Document const& document, Buffers& buffers, Budget& budget, Findings& findings)
      : document_(document), buffers_(buffers), budget_(budget), findings_(findings) {}

  using Numbers = std::vector<std::uint32_t>;

  /// Nothing when the accessor cannot be read, or when `components` is not 0 and not what it holds. Of `kept` only, as
  /// for vectors().
  std::optional<FloatElements> floats(int accessor, std::size_t components, std::string_view pointer,
                                      Numbers const* kept = nullptr);
  /// The same as vectors of exactly N components. Of `kept` only, in this order, if it is not null: numbers below
  /// count(accessor), ascending.
  template <std::size_t N>
  std::optional<std::vector<std::array<float, N>>> vectors(int accessor, std::string_view pointer,
                                                           Numbers const* kept = nullptr);
  /// Unsigned scalars of any width.
  std::optional<std::vector<std::uint32_t>> integers(int accessor, std::size_t components, std::string_view pointer);

  /// How many elements an accessor declares; 0 for an invalid one.
  std::size_t count(int accessor) const;

  /// Whether its integers are fractions of their largest value.
  bool is_normalized(int accessor) const;

 private:
  struct Layout;
  /// `allocate(elements, components)` returns the place for that many T, zeroed.
  template <class T, class Allocate, class Convert>
  bool read(int accessor, std::size_t components, std::string_view pointer, Numbers const* kept, Allocate const&,
            Convert const&);
  template <class T, class Convert>
  bool apply_sparse(int accessor, Layout const& layout, std::string_view pointer, Numbers const* kept,
                    Convert const& convert, T* values);
  std::optional<Layout> layout_of(int accessor, std::size_t components, std::string_view pointer);

  Document const& document_;
  Buffers& buffers_;
  Budget& budget_;
  Findings& findings_;
};

}  // namespace lichtraum::gltf
