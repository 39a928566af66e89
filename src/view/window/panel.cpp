#include "view/window/panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lichtraum/words.hpp"
#include "view/values_as_esdf.hpp"
#include "view/window/graphics.hpp"
#include "view/window/object_rows.hpp"
#include "view/window/sliders.hpp"

namespace lichtraum::view {
namespace {

// Of the window's width, and in Dear ImGui's units at scale 1.
constexpr float share = 0.3f, least_width = 260, greatest_width = 330;

}  // namespace

void Panel::set_scene(SceneView const& scene) {
  tree_ = ObjectTree(scene.objects);
  values_ = scene.values;
  typed_light_ = {};
  typed_material_ = {};
  development = original_development_ = scene.development;
  aperture = original_aperture_ = scene.request.camera.lens().aperture;
  loaded_ = scene.loaded;
  seen_.reset();
  double const size = glm::distance(scene.bounds.min, scene.bounds.max);
  scene_size_ = std::isfinite(size) && size > 0 ? size : 1;
}

bool Panel::select(std::optional<SeenPoint> const& seen) {
  auto const before = tree_.selected_objects();
  seen_ = seen;
  tree_.reveal(seen ? seen->object : 0);
  scrolls_ = true;
  return tree_.selected_objects() != before;
}

float panel_width_in(float window_width, float ui_scale) {
  return std::min(std::clamp(share * window_width, ui_scale * least_width, ui_scale * greatest_width),
                  0.5f * window_width);
}

float panel_width_beside(float picture_width, float ui_scale) {
  return std::clamp(share / (1 - share) * picture_width, ui_scale * least_width, ui_scale * greatest_width);
}

Panel::Changes Panel::draw(float width, std::function<void()> const& draw_menus) {
  if (!loaded_) return {};
  constexpr ImGuiWindowFlags docked = ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_MenuBar;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y});
  Changes changes;
  if (ImGui::Begin("scene", nullptr, docked)) {
    draw_menus();
    ImGui::PushItemWidth(-scaled(80));
    changes.plane = draw_views();
    changes.selection = draw_objects();
    draw_lights(changes);
    draw_materials(changes);
    changes.values |= draw_environment();
    draw_picture(changes);
    if (ImGui::Button("reset all")) {
      values_.reset();
      development = original_development_;
      aperture = original_aperture_;
      changes.values = changes.development = changes.aperture = true;
    }
    ImGui::PopItemWidth();
  }
  ImGui::End();
  return changes;
}

bool Panel::draw_views() {
  struct View {
    FilmPlane plane;
    char const* label;
  };
  constexpr View views[] = {
      {FilmPlane::radiance, "picture (P)"}, {FilmPlane::depth, "depth (D)"},    {FilmPlane::normal, "normals (N)"},
      {FilmPlane::object, "objects (O)"},   {FilmPlane::albedo, "albedo"},      {FilmPlane::position, "positions"},
      {FilmPlane::material, "materials"},   {FilmPlane::instance, "instances"},
  };
  auto const current = std::ranges::find(views, plane, &View::plane);
  if (!ImGui::BeginCombo("view", current->label)) return false;
  FilmPlane const before = plane;
  for (View const& view : views) {
    if (ImGui::Selectable(view.label, view.plane == plane)) plane = view.plane;
  }
  ImGui::EndCombo();
  return plane != before;
}

bool Panel::draw_objects() {
  if (!ImGui::CollapsingHeader("Objects", ImGuiTreeNodeFlags_DefaultOpen)) return false;
  float const height = std::clamp(0.3f * ImGui::GetWindowHeight(), scaled(60), scaled(400));
  ImGui::BeginChild("rows", {0, height}, true, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNav);
  bool const is_selected = draw_object_rows(tree_, values_, scrolls_);
  scrolls_ = false;
  ImGui::EndChild();
  if (is_selected) seen_.reset();
  draw_selection();
  return is_selected;
}

void Panel::draw_selection() const {
  if (!tree_.selected()) {
    ImGui::TextDisabled("a click on the picture selects");
    return;
  }
  Shape const& shape = *tree_.rows()[*tree_.selected()].shape;
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(tree_.selected_path().c_str());
  ImGui::PopTextWrapPos();
  if (dynamic_cast<Composite const*>(&shape)) {
    ImGui::Text("composite of %llu objects", static_cast<unsigned long long>(tree_.selected_objects().count));
  } else {
    ImGui::Text("%s, %s", std::string(name_of(shape.kind())).c_str(), material_name(shape, values_).c_str());
  }
  if (!seen_) return;
  ImGui::Text("distance %.4g", seen_->distance);
  ImGui::Text("position %.4g %.4g %.4g", seen_->position.x, seen_->position.y, seen_->position.z);
  ImGui::Text("normal   %.3f %.3f %.3f", seen_->normal.x, seen_->normal.y, seen_->normal.z);
}

void Panel::draw_picture(Changes& changes) {
  if (plane != FilmPlane::radiance || !ImGui::CollapsingHeader("Picture")) return;
  changes.development = edit_number("exposure", development.exposure_ev, -8, 8);
  changes.aperture = edit_number("aperture", aperture, 0, 0.2 * scene_size_, ImGuiSliderFlags_Logarithmic);
  if (aperture > 0) ImGui::TextDisabled("a click on the picture focuses");
  auto const current = std::ranges::find(tone_map_words, development.tone_map, &Word<ToneMap>::value);
  if (!ImGui::BeginCombo("tones", current->word.data())) return;
  for (Word<ToneMap> const& curve : tone_map_words) {
    if (curve.value == ToneMap::automatic) continue;
    if (!ImGui::Selectable(curve.word.data(), curve.value == development.tone_map)) continue;
    development.tone_map = curve.value;
    changes.development = true;
  }
  ImGui::EndCombo();
}

bool Panel::draw_environment() {
  if (!values_.environment || !ImGui::CollapsingHeader("Environment")) return false;
  ImGui::PushID("environment");
  bool has_changed = edit_number("rotation", values_.environment->rotation_degrees, -180, 180);
  has_changed |= edit_number("brightness", values_.environment->brightness, 0, 10, ImGuiSliderFlags_Logarithmic);
  ImGui::PopID();
  return has_changed;
}

void Panel::draw_lights(Changes& changes) {
  if (values_.lights.empty() || !ImGui::CollapsingHeader("Lights")) return;
  for (std::size_t i = 0; i < values_.lights.size(); ++i) {
    Light& light = values_.lights[i];
    ImGui::PushID(int(i));
    if (ImGui::TreeNode("light", "%s (%s)", light.name().c_str(), std::string(light.kind()).c_str())) {
      changes.values |= typed_light_(
          light, [&](Light& edited) { return edit_light(edited, values_.original_light(i), scene_size_); });
      if (ImGui::SmallButton("reset")) {
        values_.reset_light(i);
        changes.values = true;
      }
      ImGui::SameLine();
      if (ImGui::SmallButton("copy light")) changes.copied = light_as_esdf(light);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
}

void Panel::draw_materials(Changes& changes) {
  if (values_.materials.empty() || !ImGui::CollapsingHeader("Materials")) return;
  std::size_t const* selected = nullptr;
  if (tree_.selected()) selected = values_.find(tree_.rows()[*tree_.selected()].shape->material().get());
  for (std::size_t i = 0; i < values_.materials.size(); ++i) {
    SceneValues::EditableMaterial& material = values_.materials[i];
    ImGui::PushID(int(i));
    ImGuiTreeNodeFlags const flags = selected && *selected == i ? ImGuiTreeNodeFlags_Selected : 0;
    if (ImGui::TreeNodeEx("material", flags, "%s%s", material.value.name().c_str(), material.is_edited ? " *" : "")) {
      if (typed_material_(material.value, edit_material)) changes.values = material.is_edited = true;
      if (ImGui::SmallButton("copy material")) changes.copied = material_as_esdf(material.value);
      if (material.is_edited) {
        ImGui::SameLine();
        if (ImGui::SmallButton("reset")) {
          values_.reset_material(i);
          changes.values = true;
        }
      }
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
}

}  // namespace lichtraum::view
