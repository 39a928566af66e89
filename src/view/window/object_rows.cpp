#include "view/window/object_rows.hpp"

#include <imgui.h>

#include <algorithm>

#include "core/counted.hpp"

namespace lichtraum::view {
namespace {

struct RowAction {
  bool toggles = false;
  bool selects = false;
};

RowAction draw_row(ObjectTree::Row const& row, bool is_selected, SceneValues const& values) {
  constexpr std::uint32_t deepest_indent = 16;  // what is deeper stays in sight, and says how deep it is
  constexpr float indent = 12;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent * float(std::min(row.depth, deepest_indent)));
  ImGuiTreeNodeFlags const flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_OpenOnArrow |
                                   ImGuiTreeNodeFlags_OpenOnDoubleClick | ImGuiTreeNodeFlags_SpanFullWidth |
                                   (is_selected ? ImGuiTreeNodeFlags_Selected : 0) |
                                   (row.composite ? 0 : ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_Bullet);
  ImGui::SetNextItemOpen(row.is_open, ImGuiCond_Always);
  std::string const& name = row.shape->name();
  bool const is_open = ImGui::TreeNodeEx("row", flags, "%s", name.empty() ? "(no name)" : name.c_str());
  RowAction action;
  action.toggles = row.composite && is_open != row.is_open;
  action.selects = ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen();
  ImGui::SameLine();
  if (row.composite) {
    ImGui::TextDisabled("%s", counted(row.composite->children().size(), "part").c_str());
  } else {
    ImGui::TextDisabled("%s, %s", std::string(name_of(row.shape->kind())).c_str(),
                        material_name(*row.shape, values).c_str());
  }
  if (row.depth > deepest_indent) {
    ImGui::SameLine();
    ImGui::TextDisabled("(level %u)", row.depth);
  }
  return action;
}

}  // namespace

std::string material_name(Shape const& shape, SceneValues const& values) {
  std::size_t const* const place = values.find(shape.material().get());
  return place ? values.materials[*place].value.name() : "no material";
}

bool draw_object_rows(ObjectTree& tree, SceneValues const& values, bool scrolls) {
  float const row_height = ImGui::GetTextLineHeightWithSpacing();
  if (scrolls && tree.selected()) {
    ImGui::SetScrollY(std::max(0.0f, row_height * (float(*tree.selected()) - 3)));
  }
  std::optional<std::size_t> toggled, selected;
  ImGuiListClipper clipper;
  clipper.Begin(int(tree.rows().size()), row_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      auto const number = std::size_t(i);
      ImGui::PushID(i);
      RowAction const action = draw_row(tree.rows()[number], tree.selected() == number, values);
      if (action.toggles) toggled = number;
      if (action.selects) selected = number;
      ImGui::PopID();
    }
  }
  if (selected) tree.select(*selected);
  if (toggled) tree.toggle(*toggled);
  return selected.has_value();
}

}  // namespace lichtraum::view
