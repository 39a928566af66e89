#include "editing.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace lichtraum::python {
namespace {

Error no_such(std::string_view kind, std::string const& name) {
  return {ErrorKind::usage, fmt::format("the scene has no {} '{}'", kind, name)};
}

Vec3 triple(std::vector<double> const& numbers, std::size_t from = 0) {
  if (numbers.size() < from + 3) throw Error(ErrorKind::usage, "expected three numbers");
  return {numbers[from], numbers[from + 1], numbers[from + 2]};
}

Transform transform_of(std::string const& how, std::vector<double> const& numbers) {
  if (how == "translate") return Transform::translation(triple(numbers));
  if (how == "scale") return Transform::scaling(triple(numbers));
  if (how == "rotate") {
    Vec3 const axis = triple(numbers, 1);
    return Transform::rotation(numbers.at(0), axis / glm::length(axis));  // rounded as the statement's
  }
  throw Error(ErrorKind::usage, fmt::format("there is no transform '{}'", how));
}

void read_field(Rgb& field, std::vector<double> const& numbers) {
  Vec3 const values = triple(numbers);
  field = Rgb(values.x, values.y, values.z);
}
void read_field(double& field, std::vector<double> const& numbers) { field = numbers.at(0); }
void read_field(bool& field, std::vector<double> const& numbers) { field = numbers.at(0) != 0; }
void read_field(AlphaMode& field, std::vector<double> const& numbers) { field = AlphaMode(int(numbers.at(0))); }
void read_field(TextureSlot& field, MadeTexture const& made) { field.texture = made.texture; }

/// Takes fields by their names, and knows whether all were taken.
template <class Value>
class FieldReader {
 public:
  explicit FieldReader(std::map<std::string, Value> const& fields) : fields_(fields) {}
  template <class Field>
  void operator()(char const* name, Field& field) {
    auto const found = fields_.find(name);
    if (found == fields_.end()) return;
    read_field(field, found->second);
    ++count_;
  }
  void expect_all() const {
    if (count_ != fields_.size()) throw Error(ErrorKind::usage, "there is a field that a material does not have");
  }

 private:
  std::map<std::string, Value> const& fields_;
  std::size_t count_ = 0;
};

#define LICHTRAUM_READ(name, ...) reader(#name, model.name);
#define LICHTRAUM_READ_MODE(type, name, initial) reader(#name, model.name);
#define LICHTRAUM_READ_TEXTURE(name, ...) texture_reader(#name, model.name);
PhongModel phong_of(Fields const& fields) {
  PhongModel model;
  FieldReader reader(fields);
  PHONG_FIELDS(LICHTRAUM_READ, LICHTRAUM_READ, LICHTRAUM_READ)
  reader.expect_all();
  return model;
}
PbrModel pbr_of(Fields const& fields, Textures const& textures) {
  PbrModel model;
  FieldReader reader(fields);
  FieldReader texture_reader(textures);
  PBR_FIELDS(LICHTRAUM_READ, LICHTRAUM_READ, LICHTRAUM_READ, LICHTRAUM_READ_TEXTURE, LICHTRAUM_READ_MODE)
  reader.expect_all();
  texture_reader.expect_all();
  return model;
}
#undef LICHTRAUM_READ
#undef LICHTRAUM_READ_MODE
#undef LICHTRAUM_READ_TEXTURE

Light light_of(std::string const& name, std::string const& kind, Fields const& fields) {
  auto const vector = [&](char const* field) { return triple(fields.at(field)); };
  Vec3 const b = vector("brightness");
  Rgb const brightness(b.x, b.y, b.z);
  auto const number = [&](char const* field) { return fields.at(field).at(0); };
  if (kind == "ambient") return Light::ambient(name, brightness);
  if (kind == "directional") return Light::directional(name, vector("direction"), brightness);
  if (kind == "spot") {
    return Light::spot(name, vector("position"), vector("direction"), brightness, {number("inner"), number("outer")},
                       number("range"));
  }
  if (kind != "point") throw Error(ErrorKind::usage, fmt::format("there is no light '{}'", kind));
  PointLight point;
  point.ld = brightness;
  point.position = vector("position");
  point.radius = number("radius");
  return Light(name, point);
}

}  // namespace

void transform(ReadScene& read, std::string const& shape, std::string const& how, std::vector<double> const& numbers) {
  std::lock_guard const lock(*read.mutex);
  auto* const found = read.scene.shapes.find(shape);
  if (!found) throw no_such("shape", shape);
  Transform const step = transform_of(how, numbers);
  (*found)->apply(step);
}

void set_material(ReadScene& read, std::string const& name, std::string const& model, Fields const& fields,
                  Textures const& textures) {
  std::lock_guard const lock(*read.mutex);
  auto* const found = read.scene.materials.find(name);
  if (!found) throw no_such("material", name);
  Material const made = model == "pbr" ? Material((*found)->name(), pbr_of(fields, textures))
                                       : Material((*found)->name(), phong_of(fields));
  // The shapes hold this one. Copied, not moved: its equal name stays where it is, and the registry looks at it there.
  **found = made;
  for (auto const& [field, texture] : textures) read.files.add(texture.files);
}

void set_light(ReadScene& read, std::string const& name, std::string const& kind, Fields const& fields) {
  std::lock_guard const lock(*read.mutex);
  read.scene.lights.insert_or_replace(light_of(name, kind, fields));
  read.scene.has_own_lights = true;
}

void remove_light(ReadScene& read, std::string const& name) {
  std::lock_guard const lock(*read.mutex);
  if (!read.scene.lights.contains(name)) throw no_such("light", name);
  Registry<Light> others;
  for (Light const& light : read.scene.lights) {
    if (light.name() != name) others.insert(light);
  }
  read.scene.lights = std::move(others);
}

void set_camera(ReadScene& read, std::string const& name, double fov_x_degrees, std::optional<double> orthographic,
                std::vector<Step> const& steps, int width, int height) {
  std::lock_guard const lock(*read.mutex);
  Transform world_from_camera;
  for (Step const& step : steps) world_from_camera = transform_of(step.how, step.numbers) * world_from_camera;
  Resolution const size{width, height};
  read.scene.cameras.insert_or_replace(orthographic ? Camera::orthographic(name, *orthographic, world_from_camera, size)
                                                    : Camera(name, fov_x_degrees, world_from_camera, size));
}

}  // namespace lichtraum::python
