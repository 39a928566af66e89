#include "io/gltf/accessors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/huge_pages.hpp"

namespace lichtraum::gltf {
namespace {

std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

std::size_t component_count(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;  // nothing in glTF uses 2 x 2 and 3 x 3 matrices
  }
}

template <class Stored>
Stored load(char const* bytes) {
  Stored value;
  std::memcpy(&value, bytes, sizeof value);  // glTF and all machines that this builds for are little-endian
  return value;
}

/// Normalised integers are fractions of their largest value (glTF 2.0, section 3.11).
template <class Stored>
float to_float(Stored value, bool normalized) {
  if constexpr (std::is_floating_point_v<Stored>) {
    return value;
  } else {
    if (!normalized) return float(value);
    return std::max(float(double(value) / double(std::numeric_limits<Stored>::max())), -1.0f);
  }
}

/// Reads `count` elements that lie `stride` apart.
template <class Stored, class T, class Convert>
void read_elements(char const* bytes, std::size_t count, std::size_t stride, std::size_t components,
                   Convert const& convert, T* out) {
  if constexpr (std::is_same_v<Stored, T>) {
    if (stride == components * sizeof(Stored)) {
      if (count != 0) std::memcpy(out, bytes, count * stride);
      return;
    }
  }
  for (std::size_t i = 0; i < count; ++i, bytes += stride) {
    for (std::size_t c = 0; c < components; ++c) *out++ = convert(load<Stored>(bytes + c * sizeof(Stored)));
  }
}

template <class T, class Convert>
void read_elements(int component_type, char const* bytes, std::size_t count, std::size_t stride, std::size_t components,
                   Convert const& convert, T* out) {
  auto const read = [&]<class Stored>(Stored) {
    read_elements<Stored>(bytes, count, stride, components, convert, out);
  };
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read(std::uint32_t{});
    default:
      return read(float{});
  }
}

/// Whether `count` elements of `size` bytes, `stride` apart from `offset` on, lie within `available` bytes.
bool lies_within(std::uint64_t offset, std::uint64_t count, std::uint64_t stride, std::uint64_t size,
                 std::uint64_t available) {
  if (count == 0) return true;
  if (offset > available || size > available - offset) return false;
  return stride == 0 || (count - 1) <= (available - offset - size) / stride;
}

/// Where element `number` is among those that are kept.
std::optional<std::size_t> place_of(std::uint32_t number, std::vector<std::uint32_t> const* kept) {
  if (!kept) return number;
  auto const found = std::lower_bound(kept->begin(), kept->end(), number);
  if (found == kept->end() || *found != number) return std::nullopt;
  return std::size_t(found - kept->begin());
}

}  // namespace

/// What an accessor says of itself, checked.
struct Accessors::Layout {
  std::size_t count = 0;
  std::size_t components = 0;
  std::size_t element_bytes = 0;
};

std::size_t Accessors::count(int accessor) const {
  auto const& list = document_.model.accessors;
  return accessor >= 0 && std::size_t(accessor) < list.size() ? list[std::size_t(accessor)].count : 0;
}

std::optional<Accessors::Layout> Accessors::layout_of(int index, std::size_t components, std::string_view pointer) {
  auto const& list = document_.model.accessors;
  if (index < 0 || std::size_t(index) >= list.size()) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                   fmt::format("accessor {} is out of range ({})", index, list.size()));
    return std::nullopt;
  }
  tinygltf::Accessor const& accessor = list[std::size_t(index)];
  std::size_t const size = component_size(accessor.componentType);
  std::size_t const found = component_count(accessor.type);
  if (size == 0 || found == 0) {
    findings_.warn(
        DiagnosticCode::unreadable_accessor, pointer,
        fmt::format("accessor {} has component type {}, which glTF does not know", index, accessor.componentType));
    return std::nullopt;
  }
  if (components != 0 && found != components) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                   fmt::format("accessor {} has {} components where {} are expected", index, found, components));
    return std::nullopt;
  }
  if (accessor.count == 0) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer, fmt::format("accessor {} is empty", index));
    return std::nullopt;
  }
  if (accessor.count > std::numeric_limits<std::uint32_t>::max()) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                   fmt::format("accessor {} declares {} elements", index, accessor.count));
    return std::nullopt;
  }
  return Layout{accessor.count, found, found * size};
}

template <class T, class Allocate, class Convert>
bool Accessors::read(int index, std::size_t components, std::string_view pointer, Numbers const* kept,
                     Allocate const& allocate, Convert const& convert) {
  auto const layout = layout_of(index, components, pointer);
  if (!layout) return false;
  tinygltf::Accessor const& accessor = document_.model.accessors[std::size_t(index)];
  std::size_t const count = kept ? kept->size() : layout->count;  // of what is given back
  T* values = nullptr;
  if (accessor.bufferView < 0) {
    // Zeros cost the file nothing, so they may not cost memory without limit either.
    constexpr std::size_t always_allowed = std::size_t(1) << 20;
    if (layout->count > always_allowed + budget_.file_bytes()) {
      findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                     fmt::format("accessor {} has no buffer view and declares {} zeros", index, layout->count));
      return false;
    }
    budget_.charge(count * layout->components * sizeof(T), pointer);
    values = allocate(count, layout->components);
  } else {
    auto const view = buffers_.view(accessor.bufferView);
    if (!view) {
      findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                     fmt::format("accessor {}: nothing could be read from buffer view {}", index, accessor.bufferView));
      return false;
    }
    std::size_t const own_stride = document_.model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
    std::size_t const stride = own_stride == 0 ? layout->element_bytes : own_stride;
    if (stride < layout->element_bytes) {
      findings_.warn(
          DiagnosticCode::unreadable_accessor, pointer,
          fmt::format("accessor {}: elements of {} bytes lie {} bytes apart", index, layout->element_bytes, stride));
      return false;
    }
    if (!lies_within(accessor.byteOffset, layout->count, stride, layout->element_bytes, view->size())) {
      findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                     fmt::format("accessor {}: {} elements from byte {} on are out of range of buffer view {} "
                                 "({} bytes)",
                                 index, layout->count, accessor.byteOffset, accessor.bufferView, view->size()));
      return false;
    }
    budget_.charge(count * layout->components * sizeof(T), pointer);
    values = allocate(count, layout->components);
    char const* const first = view->data() + accessor.byteOffset;
    if (kept) {
      for (std::size_t i = 0; i < count; ++i) {
        read_elements(accessor.componentType, first + (*kept)[i] * stride, 1, stride, layout->components, convert,
                      values + i * layout->components);
      }
    } else {
      read_elements(accessor.componentType, first, count, stride, layout->components, convert, values);
    }
  }
  return !accessor.sparse.isSparse || apply_sparse(index, *layout, pointer, kept, convert, values);
}

template <class T, class Convert>
bool Accessors::apply_sparse(int index, Layout const& layout, std::string_view pointer, Numbers const* kept,
                             Convert const& convert, T* values) {
  tinygltf::Accessor const& accessor = document_.model.accessors[std::size_t(index)];
  auto const& sparse = accessor.sparse;
  auto const fail = [&](std::string const& message) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                   fmt::format("accessor {}, sparse: {}", index, message));
    return false;
  };
  int const index_type = sparse.indices.componentType;
  if (index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    return fail(fmt::format("indices of component type {}", index_type));
  }
  // Signed in tinygltf 2.5, unsigned in 2.9.
  auto const is_negative = [](auto number) { return std::int64_t(number) < 0; };
  if (is_negative(sparse.count) || is_negative(sparse.indices.byteOffset) || is_negative(sparse.values.byteOffset)) {
    return fail("a count or offset is too large");
  }
  auto const count = std::size_t(sparse.count);
  auto const index_view = buffers_.view(sparse.indices.bufferView);
  auto const value_view = buffers_.view(sparse.values.bufferView);
  std::size_t const index_bytes = component_size(index_type);
  if (!index_view ||
      !lies_within(std::uint64_t(sparse.indices.byteOffset), count, index_bytes, index_bytes, index_view->size())) {
    return fail(fmt::format("{} indices are out of range of buffer view {}", count, sparse.indices.bufferView));
  }
  if (!value_view || !lies_within(std::uint64_t(sparse.values.byteOffset), count, layout.element_bytes,
                                  layout.element_bytes, value_view->size())) {
    return fail(fmt::format("{} values are out of range of buffer view {}", count, sparse.values.bufferView));
  }
  std::vector<std::uint32_t> indices(count);
  read_elements(
      index_type, index_view->data() + sparse.indices.byteOffset, count, index_bytes, 1,
      [](auto i) { return std::uint32_t(i); }, indices.data());
  std::size_t out_of_range = 0;
  char const* source = value_view->data() + sparse.values.byteOffset;
  for (std::uint32_t const i : indices) {
    if (i >= layout.count) {
      ++out_of_range;
    } else if (auto const place = place_of(i, kept)) {
      read_elements(accessor.componentType, source, 1, layout.element_bytes, layout.components, convert,
                    values + *place * layout.components);
    }
    source += layout.element_bytes;
  }
  if (out_of_range > 0) {
    findings_.warn(
        DiagnosticCode::unreadable_accessor, pointer,
        fmt::format("accessor {}, sparse: {} indices are out of range ({})", index, out_of_range, layout.count));
  }
  return true;
}

bool Accessors::is_normalized(int accessor) const {
  auto const& list = document_.model.accessors;
  return accessor >= 0 && std::size_t(accessor) < list.size() && list[std::size_t(accessor)].normalized;
}

std::optional<FloatElements> Accessors::floats(int accessor, std::size_t components, std::string_view pointer,
                                               Numbers const* kept) {
  FloatElements elements;
  auto const allocate = [&](std::size_t count, std::size_t found) {
    elements.components = found;
    elements.values.resize(count * found);
    return elements.values.data();
  };
  bool const normalized = is_normalized(accessor);
  auto const convert = [=](auto v) { return to_float(v, normalized); };
  if (!read<float>(accessor, components, pointer, kept, allocate, convert)) return std::nullopt;
  return elements;
}

template <std::size_t N>
std::optional<std::vector<std::array<float, N>>> Accessors::vectors(int accessor, std::string_view pointer,
                                                                    Numbers const* kept) {
  std::vector<std::array<float, N>> elements;
  auto const allocate = [&](std::size_t count, std::size_t) {
    reserve_in_huge_pages(elements, count);
    elements.resize(count);
    return elements.data()->data();
  };
  bool const normalized = is_normalized(accessor);
  auto const convert = [=](auto v) { return to_float(v, normalized); };
  if (!read<float>(accessor, N, pointer, kept, allocate, convert)) return std::nullopt;
  return elements;
}

template std::optional<std::vector<std::array<float, 2>>> Accessors::vectors(int, std::string_view, Numbers const*);
template std::optional<std::vector<std::array<float, 3>>> Accessors::vectors(int, std::string_view, Numbers const*);
template std::optional<std::vector<std::array<float, 4>>> Accessors::vectors(int, std::string_view, Numbers const*);

std::optional<std::vector<std::uint32_t>> Accessors::integers(int accessor, std::size_t components,
                                                              std::string_view pointer) {
  if (accessor >= 0 && std::size_t(accessor) < document_.model.accessors.size()) {
    int const type = document_.model.accessors[std::size_t(accessor)].componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
      findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                     fmt::format("accessor {} has component type {}; unsigned integers are expected", accessor, type));
      return std::nullopt;
    }
  }
  std::vector<std::uint32_t> elements;
  auto const allocate = [&](std::size_t count, std::size_t found) {
    reserve_in_huge_pages(elements, count * found);
    elements.resize(count * found);
    return elements.data();
  };
  auto const convert = [](auto v) { return std::uint32_t(v); };
  if (!read<std::uint32_t>(accessor, components, pointer, nullptr, allocate, convert)) return std::nullopt;
  return elements;
}

}  // namespace lichtraum::gltf
