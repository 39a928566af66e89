#pragma once

#include <imgui.h>

#include <optional>
#include <utility>

namespace lichtraum::view {

/// Lets numbers of a value be typed in the widgets of a function. What is typed is in effect at each key, so that a
/// value whose numbers change each other, as a colour and its brightness do, is edited from what it was before the
/// first of them: else "0.5" would begin with a 0 that makes another value of it.
template <class Value>
class TypedEdit {
 public:
  /// `edit` draws the widgets for a value, and changes it. Whether it did.
  template <class Edit>
  bool operator()(Value& value, Edit const& edit) {
    bool const is_typing = ImGui::GetIO().WantTextInput && edited_ == &value;
    Value changed = is_typing ? *before_ : value;
    ImGui::BeginGroup();
    bool const has_changed = edit(changed);
    ImGui::EndGroup();
    if (ImGui::IsItemActivated()) {
      edited_ = &value;
      before_ = value;
    }
    if (has_changed) value = std::move(changed);
    return has_changed;
  }

 private:
  Value const* edited_ = nullptr;  // the last whose widgets were touched; compared only
  std::optional<Value> before_;    // as it was then
};

}  // namespace lichtraum::view
