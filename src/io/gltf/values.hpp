#pragma once

#include <tiny_gltf.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace lichtraum::gltf {

/// Properties of extensions, which no schema has checked: nothing where they are absent or of another type.

inline std::optional<double> number_in(tinygltf::Value const& value) {
  if (!value.IsNumber()) return std::nullopt;
  double const number = value.GetNumberAsDouble();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

inline std::optional<double> number_of(tinygltf::Value const& object, char const* name) {
  if (!object.IsObject() || !object.Has(name)) return std::nullopt;
  return number_in(object.Get(name));
}

inline double number_of(tinygltf::Value const& object, char const* name, double absent) {
  return number_of(object, name).value_or(absent);
}

/// A non-negative integer that a double holds exactly.
inline std::optional<std::uint64_t> integer_in(tinygltf::Value const& value) {
  auto const number = number_in(value);
  if (!number || *number < 0 || *number > 9007199254740992.0 || std::trunc(*number) != *number) return std::nullopt;
  return std::uint64_t(*number);
}

inline std::optional<std::uint64_t> integer_of(tinygltf::Value const& object, char const* name) {
  if (!object.IsObject() || !object.Has(name)) return std::nullopt;
  return integer_in(object.Get(name));
}

/// An index below `size`.
inline std::optional<int> index_of(tinygltf::Value const& object, char const* name, std::size_t size) {
  auto const number = integer_of(object, name);
  if (!number || *number >= size) return std::nullopt;
  return int(*number);
}

inline std::string string_of(tinygltf::Value const& object, char const* name) {
  if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsString()) return {};
  return object.Get(name).Get<std::string>();
}

/// The extension of that name, or nullptr.
inline tinygltf::Value const* find_extension(tinygltf::ExtensionMap const& extensions, char const* name) {
  auto const found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

}  // namespace lichtraum::gltf
