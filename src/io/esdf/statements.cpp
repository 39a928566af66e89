#include "io/esdf/statements.hpp"

#include <algorithm>

namespace lichtraum::esdf {
namespace {

constexpr Keyword command_table[] = {
    {"transform", transform},
    {"render", render},
    {"camera", define_camera},
    {"ambient", define_ambient, false},
};

// The most frequent first.
constexpr Keyword class_table[] = {
    {"shape", define_shape},
    {"material", define_material},
    {"light", define_light},
    {"camera", define_camera},
    {"background", define_background},
    {"backgroundcolor", define_background},
    {"ambient", define_ambient, false},
    {"transform", transform, false},
    {"render", render, false},
    {"renderer", render, false},
    {"filename", define_filename, false},
    {"resolution", define_resolution, false},
};

}  // namespace

std::span<Keyword const> commands() { return command_table; }
std::span<Keyword const> classes() { return class_table; }

Keyword const* find_keyword(std::span<Keyword const> keywords, Token word) {
  auto const found = std::find_if(keywords.begin(), keywords.end(), [&](Keyword const& k) { return k.word == word; });
  return found == keywords.end() ? nullptr : &*found;
}

}  // namespace lichtraum::esdf
