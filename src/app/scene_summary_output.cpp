#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report_json.hpp"
#include "app/scene_summary.hpp"
#include "core/counted.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::app {
namespace {

using Json = nlohmann::ordered_json;

std::string triple(Vec3 const& v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }
Json triple_json(Vec3 const& v) { return {v.x, v.y, v.z}; }

std::string number(std::uint64_t count) {
  return count >= ShapeCounts::uncountable ? "more than 4e18" : std::to_string(count);
}

struct CountRow {
  std::string what;
  std::uint64_t count;
};

std::vector<CountRow> rows_of(ShapeCounts const& counts) {
  std::vector<CountRow> rows;
  for (std::size_t i = 0; i < shape_kind_count; ++i) {
    rows.push_back({plural(name_of(ShapeKind(i))), counts.of_kind[i]});
    if (ShapeKind(i) == ShapeKind::mesh) rows.push_back({"mesh triangles", counts.mesh_triangles});
    if (ShapeKind(i) == ShapeKind::point_cloud) rows.push_back({"points", counts.points});
    if (ShapeKind(i) == ShapeKind::line_set) rows.push_back({"lines", counts.lines});
  }
  return rows;
}

Json counts_json(ShapeCounts const& counts) {
  Json json = Json::object();
  for (CountRow row : rows_of(counts)) {
    std::replace(row.what.begin(), row.what.end(), ' ', '_');
    json[row.what] = row.count;
  }
  return json;
}

std::string size_text(std::optional<Resolution> const& size) {
  return size ? fmt::format(", {}x{}", size->width, size->height) : "";
}

Json size_json(std::optional<Resolution> const& size) { return size ? Json{size->width, size->height} : Json(); }

std::string integrator_text(IntegratorChoice const& choice) {
  return fmt::format("by {}, as {}", find_word<Integrator>(integrator_words, choice.integrator), choice.reason);
}

Json integrator_json(IntegratorChoice const& choice) {
  return {{"name", find_word<Integrator>(integrator_words, choice.integrator)}, {"reason", choice.reason}};
}

double megabytes(TextureImage const& image) { return double(image.rgba.size()) / 1e6; }

/// By what number and name an option takes it.
std::string selector(std::size_t number, std::string const& name) {
  return fmt::format("{}{}{}", number, name.empty() ? "" : ", ", name);
}

std::string contents_text(ModelContents const& contents) {
  std::string text;
  for (std::size_t i = 0; i < contents.scenes.size(); ++i) {
    text += fmt::format("  scene           {}\n", selector(i, contents.scenes[i]));
  }
  for (std::size_t i = 0; i < contents.variants.size(); ++i) {
    text += fmt::format("  variant         {}\n", selector(i, contents.variants[i]));
  }
  for (std::size_t i = 0; i < contents.animations.size(); ++i) {
    auto const& animation = contents.animations[i];
    text += fmt::format("  animation       {}, {:.6g} s\n", selector(i, animation.name), animation.seconds);
  }
  for (auto const& extension : contents.extensions) {
    text += fmt::format("  extension       {}{}: {}\n", extension.name, extension.is_required ? " (required)" : "",
                        extension.support.empty() ? "not supported" : extension.support);
  }
  return text;
}

Json contents_json(ModelContents const& contents) {
  Json animations = Json::array();
  for (auto const& animation : contents.animations) {
    animations.push_back({{"name", animation.name}, {"seconds", animation.seconds}});
  }
  Json extensions = Json::array();
  for (auto const& extension : contents.extensions) {
    extensions.push_back({{"name", extension.name},
                          {"required", extension.is_required},
                          {"supported", !extension.support.empty()},
                          {"support", extension.support}});
  }
  return {{"scenes", contents.scenes},
          {"variants", contents.variants},
          {"animations", animations},
          {"extensions", extensions}};
}

Json environment_json(std::optional<EnvironmentLight> const& light) {
  if (!light) return {};
  return {{"name", light->name},
          {"source", light->source},
          {"size", {light->map->width, light->map->height}},
          {"rotation_degrees", light->rotation_degrees},
          {"brightness", light->brightness}};
}

/// The fields of a light that are there, by name.
struct LightJson : LightFieldVisitor {
  Json value;
  void position(char const* name, Vec3 const& v) { value[name] = triple_json(v); }
  void direction(char const* name, Vec3 const& v) { value[name] = triple_json(v); }
  void brightness(char const* name, Rgb const& color) { value[name] = triple_json(color); }
  void flag(char const* name, bool holds) {
    if (holds) value[name] = true;
  }
  void range(char const* name, double range) {
    if (std::isfinite(range)) value[name] = range;
  }
  void cone(char const*, SpotCone const& cone) {
    value["inner_degrees"] = cone.inner_degrees;
    value["outer_degrees"] = cone.outer_degrees;
  }
  void radius(char const* name, double radius) {
    if (radius > 0) value[name] = radius;
  }
};

}  // namespace

std::string to_text(SceneSummary const& summary, std::string const& file) {
  Scene const& scene = *summary.scene;
  std::string text = file + "\n";
  text += fmt::format("  {:<16}{:>10}  {:>14}\n", "shapes", "defined", "drawn");
  std::vector<CountRow> const defined = rows_of(summary.defined), drawn = rows_of(summary.drawn);
  for (std::size_t i = 0; i < defined.size(); ++i) {
    if (defined[i].count == 0) continue;
    text += fmt::format("  {:<16}{:>10}  {:>14}\n", defined[i].what, number(defined[i].count), number(drawn[i].count));
  }
  text += fmt::format("  materials       {:>10}\n", summary.material_count);
  for (TextureImage const* image : summary.textures) {
    text += fmt::format("  texture         {}{}{}x{}, {:.3g} MB\n", image->name, image->name.empty() ? "" : ", ",
                        image->width, image->height, megabytes(*image));
  }
  text += fmt::format("  lights          {:>10}\n", scene.lights.size());
  if (scene.environment) {
    EnvironmentLight const& light = *scene.environment;
    text += fmt::format("  environment     {}, {}x{}, turned by {:g} degrees, brightness {:g}\n", light.source,
                        light.map->width, light.map->height, light.rotation_degrees, light.brightness);
  }
  for (Camera const& camera : scene.cameras) {
    text += camera.is_orthographic()
                ? fmt::format("  camera          {}, orthographic, {:g} wide", camera.name(), camera.width())
                : fmt::format("  camera          {}, {:g} degrees wide", camera.name(), camera.fov_x_degrees());
    text += size_text(camera.resolution()) + '\n';
  }
  for (std::size_t i = 0; i < scene.renders.size(); ++i) {
    RenderCommand const& command = scene.renders[i];
    text += fmt::format("  picture         {} through {}{}, {}\n", command.file, command.camera,
                        size_text(command.resolution), integrator_text(summary.integrators[i]));
  }
  if (scene.renders.empty()) text += fmt::format("  drawn           {}\n", integrator_text(summary.integrators[0]));
  if (summary.contents) text += contents_text(*summary.contents);
  text += fmt::format("  ambient light   {}\n", triple(scene.ambient()));
  Background const& background = summary.background;
  text += background.top == background.bottom ? fmt::format("  background      {}\n", triple(background.top))
                                              : fmt::format("  background      from {} above to {}\n",
                                                            triple(background.top), triple(background.bottom));
  text += summary.bounds.is_empty()
              ? fmt::format("  bounds          none: nothing {}is drawn\n",
                            summary.drawn.primitives() > 0 ? "but planes " : "")
              : fmt::format("  bounds          {} to {}\n", triple(summary.bounds.min), triple(summary.bounds.max));
  return text;
}

std::string to_json(SceneSummary const& summary, std::string const& file) {
  Scene const& scene = *summary.scene;
  Json lights = Json::array();
  for (Light const& light : scene.lights) {
    LightJson json;
    json.value = {{"name", light.name()}, {"kind", light.kind()}, {"la", triple_json(light.la())}};
    std::visit([&](auto const& model) { for_each_field(model, json); }, light.model());
    lights.push_back(std::move(json.value));
  }
  Json cameras = Json::array();
  for (Camera const& camera : scene.cameras) {
    cameras.push_back({{"name", camera.name()},
                       {"fov_x_degrees", camera.is_orthographic() ? Json() : Json(camera.fov_x_degrees())},
                       {"width", camera.is_orthographic() ? Json(camera.width()) : Json()},
                       {"position", triple_json(camera.world_from_camera().point(Vec3(0)))},
                       {"size", size_json(camera.resolution())}});
    Lens const& lens = camera.lens();
    if (lens.aperture > 0) cameras.back()["lens"] = {{"aperture", lens.aperture}, {"focus", lens.focus_distance}};
  }
  Json renders = Json::array();
  for (std::size_t i = 0; i < scene.renders.size(); ++i) {
    RenderCommand const& command = scene.renders[i];
    renders.push_back({{"camera", command.camera},
                       {"file", command.file},
                       {"size", size_json(command.resolution)},
                       {"integrator", integrator_json(summary.integrators[i])}});
  }
  Json textures = Json::array();
  for (TextureImage const* image : summary.textures) {
    textures.push_back({{"name", image->name}, {"size", {image->width, image->height}}, {"bytes", image->rgba.size()}});
  }
  Json const bounds = summary.bounds.is_empty()
                          ? Json()
                          : Json{{"min", triple_json(summary.bounds.min)}, {"max", triple_json(summary.bounds.max)}};
  Json const json{{"file", file},
                  {"shapes", {{"defined", counts_json(summary.defined)}, {"drawn", counts_json(summary.drawn)}}},
                  {"materials", summary.material_count},
                  {"textures", textures},
                  {"lights", lights},
                  {"environment", environment_json(scene.environment)},
                  {"cameras", cameras},
                  {"renders", renders},
                  {"integrator", integrator_json(summary.integrators[0])},
                  {"ambient", triple_json(scene.ambient())},
                  {"background", triple_json(summary.background.top)},
                  {"background_below", triple_json(summary.background.bottom)},
                  {"bounds", bounds},
                  {"model", summary.contents ? contents_json(*summary.contents) : Json()}};
  return printed(json);
}

}  // namespace lichtraum::app
