#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/obj/obj_file.hpp"

namespace lichtraum::obj {

/// Sorts triangles, lines and points into parts: one for each material of each object and group. Files alternate
/// between them thousands of times; what belongs together becomes one part.
class PartLists {
 public:
  /// `o` and `g`, of which an object's first group has no name, and `usemtl`: what follows belongs to them.
  void set_object(std::string_view name);
  void set_group(std::string_view name);
  void set_material(std::string_view name);

  /// What a statement of that kind adds to. Findings are of that statement's line.
  Part& part_for(Drawn kind, Diagnostics& diagnostics);
  /// That there is such a statement, which may have nothing to add.
  void note(Drawn kind, Line const& line);

  /// Moves triangles to the file, or else lines, or else points: those that are named, or all `position_count` where no
  /// statement names any. Says what is not drawn beside them.
  void choose(ObjFile& file, std::size_t position_count, Diagnostics& diagnostics);

  /// "face", "line", "point".
  static std::string_view noun(Drawn kind);

 private:
  struct List {
    std::vector<Part> parts;
    std::unordered_map<std::string, std::size_t> numbers;  // by what tells them apart
    Part* current = nullptr;
    Line first_line;  // number 0: there is none
  };

  void end_parts();

  std::array<List, 3> lists_;  // by kind
  std::string object_, group_, material_;
  bool is_full_ = false;  // and that was told
};

}  // namespace lichtraum::obj
