#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/drawn_objects.hpp"

namespace lichtraum::view {

/// The scene graph as a tree of rows, of which only those are there whose composites are open: a shape that several
/// composites name shows under each. One row may be selected.
class ObjectTree {
 public:
  struct Row {
    Shape const* shape = nullptr;
    Composite const* composite = nullptr;  ///< null for other shapes
    std::uint32_t depth = 0;               ///< 0: a root
    std::uint32_t child = 0;               ///< which child of the row above it that is less deep
    bool is_open = false;
    std::uint64_t first_object = 1;  ///< the number of the first object below, see DrawnObjects
  };

  ObjectTree() = default;
  explicit ObjectTree(std::shared_ptr<DrawnObjects const> objects);

  std::vector<Row> const& rows() const { return rows_; }

  /// Opens a composite's row, or closes it with all below. A selection below it goes to the row itself.
  void toggle(std::size_t row);
  void select(std::size_t row) { selected_ = row; }
  /// Selects an object, and opens what is above it. Nothing is selected when there is no such object.
  void reveal(std::uint64_t object);

  std::optional<std::size_t> selected() const { return selected_; }
  /// The objects below the selected row: their numbers are first, first + 1, ... first + count - 1.
  struct Objects {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    friend bool operator==(Objects const&, Objects const&) = default;
  };
  Objects selected_objects() const;
  /// The names from the root to the selected row: "/room/table/leg". Of long ways the last ones.
  std::string selected_path() const;

 private:
  void open(std::size_t row);
  void close(std::size_t row);

  std::shared_ptr<DrawnObjects const> objects_;
  std::vector<Row> rows_;
  std::optional<std::size_t> selected_;
};

}  // namespace lichtraum::view
