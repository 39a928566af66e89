#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace lichtraum::gltf {

/// What a property may hold.
enum class Kind {
  boolean,
  integer,  // 0..2^53
  number,
  string,
  numbers,    // as many as `count`, or any number for 0
  reference,  // index into the root's list `target`
  references,
  named_references,  // an object whose values are references: a primitive's attributes
  target_list,       // a list of those: morph targets
  object,            // of `schema`
  objects,
  strings,
  extensions,  // those the importer knows, unchecked
};

/// What becomes of an element whose property is not as it should be.
enum class Need {
  optional,   // the property is left out
  essential,  // may be absent; if it is there and wrong, the element is replaced
  required,   // absent or wrong: the element is replaced
};

struct Schema;

/// A property of an element, as the specification's tables describe it.
struct Property {
  std::string_view name;
  Kind kind;
  Need need = Need::optional;
  std::size_t count = 0;
  std::string_view target = {};
  Schema const* schema = nullptr;
};

/// An element: an object of the JSON.
struct Schema {
  std::span<Property const> properties;
  char const* stub = "{}";  ///< what replaces an element that makes no sense; null: it is left out
};

/// The whole document: section 5 of the glTF 2.0 specification as tables.
Schema const& root_schema();

}  // namespace lichtraum::gltf
