#include "io/obj/part_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/counted.hpp"

namespace lichtraum::obj {
namespace {

constexpr std::size_t max_parts = std::size_t(1) << 16;  // of a kind

}  // namespace

void PartLists::set_object(std::string_view name) {
  object_ = name;
  group_.clear();
  end_parts();
}

void PartLists::set_group(std::string_view name) {
  group_ = name;
  end_parts();
}

void PartLists::set_material(std::string_view name) {
  material_ = name;
  end_parts();
}

void PartLists::end_parts() {
  for (List& list : lists_) list.current = nullptr;
}

Part& PartLists::part_for(Drawn kind, Diagnostics& diagnostics) {
  List& list = lists_[std::size_t(kind)];
  if (list.current) return *list.current;
  std::string name = group_.empty() ? object_ : object_.empty() ? group_ : object_ + "." + group_;
  std::string key = name + '\n' + material_;
  if (!list.numbers.contains(key) && list.numbers.size() >= max_parts) {
    if (!std::exchange(is_full_, true)) {
      diagnostics.add(Severity::warning, DiagnosticCode::parts_joined, {},
                      fmt::format("more than {} objects and groups: those that follow are joined", max_parts));
    }
    name.clear();
    key = '\n' + material_;
  }
  auto const [found, is_new] = list.numbers.emplace(std::move(key), list.parts.size());
  if (is_new) list.parts.push_back({std::move(name), material_, {}, {}});
  list.current = &list.parts[found->second];
  return *list.current;
}

void PartLists::note(Drawn kind, Line const& line) {
  Line& first = lists_[std::size_t(kind)].first_line;
  if (first.number == 0) first = line;
}

void PartLists::choose(ObjFile& file, std::size_t position_count, Diagnostics& diagnostics) {
  auto const is_noted = [](List const& list) { return list.first_line.number > 0; };
  auto const drawn = std::ranges::find_if(lists_, [](List const& list) { return !list.parts.empty(); });
  if (drawn == lists_.end()) {
    if (std::ranges::any_of(lists_, is_noted)) return;
    file.draws = Drawn::points;
    Part& all = file.parts.emplace_back();
    for (std::uint32_t i = 0; i < position_count; ++i) all.corners.push_back({.position = i});
    return;
  }
  auto const kind_of = [&](auto const& list) { return Drawn(list - lists_.begin()); };
  file.draws = kind_of(drawn);
  file.parts = std::move(drawn->parts);
  for (auto other = drawn + 1; other != lists_.end(); ++other) {
    if (!is_noted(*other)) continue;
    diagnostics.begin_line(other->first_line);
    diagnostics.add(Severity::warning, DiagnosticCode::undrawn_obj, {},
                    fmt::format("{} are not drawn beside {}", plural(noun(kind_of(other))), plural(noun(file.draws))));
  }
}

std::string_view PartLists::noun(Drawn kind) {
  switch (kind) {
    case Drawn::triangles:
      return "face";
    case Drawn::lines:
      return "line";
    case Drawn::points:
      return "point";
  }
  return "";
}

}  // namespace lichtraum::obj
