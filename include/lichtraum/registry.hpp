#pragma once

#include <deque>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// Named things in the order of their definition, with lookup by name. T, or what T points to, has a `name()` that
/// never changes. References to elements stay valid until the registry is destroyed.
template <class T>
class Registry {
 public:
  Registry() = default;
  Registry(Registry&&) = default;
  Registry(Registry const&) = delete;  // the index points into the elements
  Registry& operator=(Registry const&) = delete;
  Registry& operator=(Registry&& other) noexcept {
    clear();
    items_ = std::move(other.items_);
    index_ = std::move(other.index_);
    return *this;
  }
  ~Registry() { clear(); }

  /// Prepares for `count` items, so that adding them costs less.
  void reserve(std::size_t count) { index_.reserve(count); }

  /// Adds `item`; when its name is taken, changes nothing and returns false. Throws std::invalid_argument for a null
  /// pointer, as does insert_or_replace.
  bool insert(T item) {
    name_of(item);
    items_.push_back(std::move(item));
    if (index_.emplace(name_of(items_.back()), &items_.back()).second) return true;
    items_.pop_back();
    return false;
  }

  /// Adds `item`; from now on its name means this one. An earlier item of that name is overwritten.
  void insert_or_replace(T item) {
    auto const found = index_.find(name_of(item));
    if (found == index_.end()) {
      insert(std::move(item));
      return;
    }
    T* const place = found->second;
    index_.erase(found);  // the key is a view of the name that is about to go
    *place = std::move(item);
    index_.emplace(name_of(*place), place);
  }

  /// The item of that name, or nullptr.
  T* find(std::string_view name) {
    auto const found = index_.find(name);
    return found == index_.end() ? nullptr : found->second;
  }
  T const* find(std::string_view name) const { return const_cast<Registry*>(this)->find(name); }

  bool contains(std::string_view name) const { return index_.count(name) != 0; }
  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  T& front() { return items_.front(); }
  T const& front() const { return items_.front(); }

  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }

 private:
  static std::string_view name_of(T const& item) {
    if constexpr (requires { item->name(); }) {
      if (item == nullptr) throw std::invalid_argument("a scene's shapes and materials must not be null");
      return item->name();
    } else {
      return item.name();
    }
  }

  // Last in, first out: what was defined later may hold what was defined before, so no destructor recurses far.
  void clear() {
    index_.clear();
    while (!items_.empty()) items_.pop_back();
  }

  std::deque<T> items_;
  std::unordered_map<std::string_view, T*> index_;
};

}  // namespace lichtraum
