#include "view/object_tree.hpp"

#include <algorithm>

namespace lichtraum::view {
namespace {

template <class Shapes>
std::vector<ObjectTree::Row> make_rows(Shapes const& shapes, std::uint32_t depth, std::uint64_t first_object,
                                       DrawnObjects const& objects) {
  std::vector<ObjectTree::Row> rows;
  rows.reserve(shapes.size());
  for (auto const& shape : shapes) {
    rows.push_back({shape.get(), dynamic_cast<Composite const*>(shape.get()), depth, std::uint32_t(rows.size()), false,
                    first_object});
    first_object += objects.count_below(*shape);
  }
  return rows;
}

}  // namespace

ObjectTree::ObjectTree(std::shared_ptr<DrawnObjects const> objects)
    : objects_(std::move(objects)), rows_(make_rows(objects_->roots(), 0, 1, *objects_)) {}

void ObjectTree::toggle(std::size_t row) {
  if (!rows_[row].composite) return;
  rows_[row].is_open ? close(row) : open(row);
}

void ObjectTree::open(std::size_t row) {
  rows_[row].is_open = true;
  Row const parent = rows_[row];
  auto const children = make_rows(parent.composite->children(), parent.depth + 1, parent.first_object, *objects_);
  rows_.insert(rows_.begin() + std::ptrdiff_t(row) + 1, children.begin(), children.end());
  if (selected_ && *selected_ > row) *selected_ += children.size();
}

void ObjectTree::close(std::size_t row) {
  rows_[row].is_open = false;
  auto const first = rows_.begin() + std::ptrdiff_t(row) + 1;
  auto const last = std::find_if(first, rows_.end(), [&](Row const& r) { return r.depth <= rows_[row].depth; });
  auto const count = std::size_t(last - first);
  rows_.erase(first, last);
  if (selected_ && *selected_ > row) selected_ = *selected_ > row + count ? *selected_ - count : row;
}

void ObjectTree::reveal(std::uint64_t object) {
  selected_.reset();
  std::size_t row = 0;
  std::uint32_t depth = 0;
  for (std::uint32_t const child : objects_->path_of(object)) {
    if (depth > 0) {
      if (!rows_[row].is_open) open(row);
      ++row;
    }
    while (rows_[row].depth != depth || rows_[row].child != child) ++row;
    selected_ = row;
    ++depth;
  }
}

ObjectTree::Objects ObjectTree::selected_objects() const {
  if (!selected_) return {};
  Row const& row = rows_[*selected_];
  return {row.first_object, objects_->count_below(*row.shape)};
}

std::string ObjectTree::selected_path() const {
  constexpr std::uint32_t most_names = 12;
  if (!selected_) return {};
  std::string path;
  std::uint32_t wanted = rows_[*selected_].depth + 1;
  for (std::size_t row = *selected_ + 1; row-- > 0 && wanted > 0;) {
    if (rows_[row].depth + 1 != wanted) continue;
    if (wanted + most_names == rows_[*selected_].depth + 1) return "..." + path;
    path = "/" + rows_[row].shape->name() + path;
    --wanted;
  }
  return path;
}

}  // namespace lichtraum::view
