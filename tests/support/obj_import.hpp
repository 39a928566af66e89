#pragma once

#include "lichtraum/obj.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

/// OBJ models as tests write and look at them.

namespace lichtraum::test {

inline Model import_text(std::string const& text, ModelOptions const& options = {}) {
  return import_obj_text(text, "m.obj", ".", options);
}

/// Each on a line of its own, with its place.
inline std::string shown(std::vector<Diagnostic> const& diagnostics) {
  std::string all;
  for (auto const& d : diagnostics) {
    all += d.location.file + ":" + std::to_string(d.location.line) + ":" + std::to_string(d.location.column) + ": " +
           d.message + "\n";
  }
  return all;
}

inline Mesh const& mesh_of(Scene const& scene, std::string const& name) {
  auto const* shape = scene.shapes.find(name);
  REQUIRE(shape);
  return dynamic_cast<Mesh const&>(**shape);
}

inline std::string const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace lichtraum::test
