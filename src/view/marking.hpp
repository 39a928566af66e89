#pragma once

#include <cstdint>
#include <vector>

#include "lichtraum/film.hpp"
#include "view/object_tree.hpp"

namespace lichtraum::view {

/// The outline of some objects in a film with object numbers, as a window's texture holds it (see display_pixels):
/// opaque where an object's pixel has a neighbour that belongs to none of them, and dark around that; else transparent.
std::vector<unsigned char> outline_pixels(Film const& film, ObjectTree::Objects const& objects);

}  // namespace lichtraum::view
