/// Cameras, lights and materials of glTF models.

#include "support/catch.hpp"
#include "support/encode_png.hpp"
#include "support/gltf_import.hpp"

using namespace lichtraum;
using testing::GltfWriter;
using testing::import_model;
using testing::messages;
using testing::triangle_positions;

namespace {

/// A triangle and a spot light of these angles, in radians, at the origin.
Model with_spot(double inner, double outer) {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}}};
  writer.json["nodes"].push_back({{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return import_model(writer);
}

}  // namespace

TEST_CASE("cameras and lights stand where their nodes do", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"aspectRatio", 2}, {"znear", 1}}}}};
  writer.json["nodes"].push_back({{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 5}}});
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5, 0}}}, {{"type", "point"}, {"intensity", 0}}};
  writer.json["nodes"].push_back({{"name", "sun"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  Model const model = import_model(writer);
  CHECK(messages(model) == "");
  REQUIRE(model.scene.cameras.size() == 1);
  Camera const& camera = model.scene.cameras.front();
  CHECK(camera.name() == "eye");
  CHECK(std::tan(camera.fov_x_degrees() * 3.14159265358979 / 360) == Approx(2 * std::tan(0.5)));
  CHECK(camera.generate_ray(720, 360, {1440, 720}).origin == Vec3(0, 0, 5));
  Light const* sun = model.scene.lights.find("sun");
  REQUIRE(sun);
  REQUIRE(sun->get<DirectionalLight>());
  CHECK(sun->brightness() == Rgb(1, 0.5, 0));
  CHECK(sun->get<DirectionalLight>()->direction == Vec3(0, 0, -1));
}

TEST_CASE("orthographic cameras look along parallel rays, and not behind themselves", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["cameras"] = {
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", -1.5}, {"znear", 0}, {"zfar", 9}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1e308}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}}};
  writer.json["nodes"].push_back({{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 5}}, {"scale", {2, 2, 2}}});
  writer.json["nodes"].push_back({{"name", "wide"}, {"camera", 1}});
  Model const model = import_model(writer);
  CHECK_THAT(messages(model), contains_text("/cameras/1"));
  REQUIRE(model.scene.cameras.size() == 1);
  Camera const& camera = model.scene.cameras.front();
  CHECK(camera.width() == 6);
  CHECK(camera.resolution() == Resolution{1440, 720});
  Ray const corner = camera.fitted({200, 200}).generate_ray(0, 0, {200, 200});
  CHECK(glm::distance(corner.origin, Vec3(-1.5, 1.5, 5)) < 1e-12);  // the height stays
  CHECK(corner.direction == Vec3(0, 0, -1));
}

TEST_CASE("lights keep their fall-off, cones and proportions under one exposure", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh({-1, 0, 0, 1, 0, 0, 0, 0, 0});  // its middle is the origin; half its size is 1
  auto const add = [&](char const* name, nlohmann::json light, Vec3 const& place) {
    auto& lights = writer.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(light));
    writer.json["nodes"].push_back({{"name", name},
                                    {"translation", {place.x, place.y, place.z}},
                                    {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
  };
  add("lamp", {{"type", "point"}, {"intensity", 40}, {"range", 7.0}}, {0, 0, 2});  // 10 at the middle
  add("torch", {{"type", "spot"}, {"intensity", 500}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}},
      {0, 5, 0});                                                       // 20
  add("inside", {{"type", "point"}, {"intensity", 10}}, {0, 0, 0});     // 10: half the size counts
  add("sky", {{"type", "directional"}, {"intensity", 10}}, {0, 0, 0});  // 10
  Model const model = import_model(writer);
  CHECK(messages(model) == "");
  auto const light = [&](char const* name) { return *model.scene.lights.find(name); };
  CHECK(glm::distance(light("lamp").arriving_at(Vec3(0)), Rgb(0.2 * (1 - std::pow(2.0 / 7, 4)))) < 1e-6);
  CHECK(light("lamp").get<PointLight>()->falls_off);
  CHECK(light("lamp").get<PointLight>()->range == 7);
  CHECK(light("torch").kind() == "spot");
  CHECK(light("torch").get<SpotLight>()->cone.outer_degrees == Approx(0.3 * 180 / 3.14159265358979));
  CHECK(light("torch").arriving_at(Vec3(0)) == Rgb(0));  // it shines along -z
  CHECK(glm::distance(light("torch").arriving_at({0, 5, -5}), Rgb(0.4)) < 1e-6);
  CHECK(glm::distance(light("inside").arriving_at({1, 0, 0}), Rgb(0.2)) < 1e-6);
  CHECK(glm::distance(light("sky").arriving_at({9, 9, 9}), Rgb(0.2)) < 1e-6);
}

TEST_CASE("a light that an animation moves stays as bright", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh({-1, 0, 0, 1, 0, 0, 0, 0, 0});
  writer.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 40}}};
  writer.json["nodes"].push_back(
      {{"name", "lamp"}, {"translation", {0, 0, 2}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  int const times = writer.add_accessor("SCALAR", 1, std::vector<float>{0, 1});
  int const places = writer.add_vec3({0, 0, 4, 0, 0, 8});
  writer.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", times}, {"output", places}}}}}};
  // 10 arrives at the middle while it stands where the file has it: that is exposed to 1.
  for (std::optional<double> const time : {std::optional<double>(), std::optional(0.0), std::optional(1.0)}) {
    ModelOptions options;
    options.time_seconds = time;
    Model const model = import_model(writer, options);
    CHECK(messages(model) == "");
    Light const& lamp = *model.scene.lights.find("lamp");
    CHECK(lamp.position()->z == (time ? 4 + 4 * *time : 2));
    CHECK(lamp.brightness() == Rgb(4));
  }
}

TEST_CASE("a spot light without a cone is named, and shines all around", "[unit][gltf]") {
  for (auto const& [inner, outer] : {std::pair(0.0, 0.0), std::pair(0.0, -0.5), std::pair(0.0, 1.7),
                                     std::pair(0.5, 3.2), std::pair(4.9e-324, 4.9e-324), std::pair(0.0, 1e300)}) {
    INFO(inner << ' ' << outer);
    Model const model = with_spot(inner, outer);
    CHECK(messages(model).find("/extensions/KHR_lights_punctual/lights/0/spot: ") == 0);
    CHECK(model.scene.lights.find("lamp")->kind() == "point");
  }
}

TEST_CASE("the angles of a spot light are brought into their range", "[unit][gltf]") {
  double const float_right_angle = 1.5707963705062866;  // the float next to pi / 2, and above it
  auto const degrees = [](double radians) { return radians * 180 / 3.14159265358979323846; };
  struct Case {
    double inner, outer, inner_degrees, outer_degrees;
  };
  for (Case const& c : {Case{0.5, 0.5, degrees(0.5), degrees(0.5)}, Case{0.7, 0.5, degrees(0.5), degrees(0.5)},
                        Case{-0.1, 0.5, 0, degrees(0.5)}, Case{0.25, float_right_angle, degrees(0.25), 90},
                        Case{float_right_angle, float_right_angle, 90, 90}, Case{1e-300, 1e-300, 0, 0}}) {
    INFO(c.inner << ' ' << c.outer);
    Model const model = with_spot(c.inner, c.outer);
    CHECK(messages(model) == "");
    Light const& lamp = *model.scene.lights.find("lamp");
    auto const* const spot = lamp.get<SpotLight>();
    REQUIRE(spot);
    CHECK(spot->cone.outer_degrees == Approx(c.outer_degrees).margin(1e-12));
    CHECK(spot->cone.outer_degrees <= 90);
    CHECK(spot->cone.inner_degrees == Approx(c.inner_degrees).epsilon(1e-5).margin(1e-12));
    CHECK(spot->cone.inner_degrees < spot->cone.outer_degrees);
    Rgb const ahead = lamp.arriving_at({0, 0, -1}), behind = lamp.arriving_at({0, 0, 1});
    CHECK(std::isfinite(ahead.r));
    CHECK((ahead.r > 0 || c.outer < 1e-3));
    CHECK(behind == Rgb(0));
  }
  // A sharp edge: bright just inside, dark just outside.
  Model const model = with_spot(0.5, 0.5);
  Light const& sharp = *model.scene.lights.find("lamp");
  auto const at = [&](double angle) { return sharp.arriving_at({std::sin(angle), 0, -std::cos(angle)}).r; };
  CHECK(at(0.49) == Approx(at(0)));
  CHECK(at(0.51) == 0);
}

TEST_CASE("a primitive without a material is grey, or has its vertices' colours", "[unit][gltf]") {
  for (bool const has_colors : {false, true}) {
    GltfWriter writer;
    auto& primitive = writer.add_mesh(triangle_positions);
    if (has_colors) primitive["attributes"]["COLOR_0"] = primitive["attributes"]["POSITION"];
    Model const model = import_model(writer);
    Material const& material = **model.scene.materials.find("default");
    CHECK(glm::distance(material.kd(), Rgb(has_colors ? 1 : 0.5)) < 1e-6);
    CHECK(material.ks() == Rgb(0));
    REQUIRE(material.pbr());  // which colours multiply
    CHECK(material.pbr()->metallic == 0);
  }
}

TEST_CASE("materials are kept whole and mapped to Phong", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions)["material"] = 0;
  writer.json["materials"] = {
      {{"name", "paint"},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {1, 0.5, 0, 0.25}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
       {"alphaMode", "BLEND"},
       {"emissiveFactor", {0, 0, 0.5}},
       {"extensions",
        {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
         {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatNormalTexture", {{"scale", 0.5}}}}},
         {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 7}}}}}}};
  Model const model = import_model(writer);
  Material const& paint = **model.scene.materials.find("paint");
  CHECK(paint.kd() == Rgb(1, 0.5, 0));
  CHECK(paint.m() == 0);
  CHECK(paint.transmit() == 0.75);
  CHECK(paint.ior() == 1);
  CHECK(paint.emission() == Rgb(0, 0, 0.5));  // a quarter of it is there
  REQUIRE(paint.pbr());
  CHECK(paint.pbr()->clearcoat == 0.75);
  CHECK(paint.pbr()->clearcoat_normal_scale == 0.5);
  CHECK(paint.pbr()->anisotropy == 0.5);
  CHECK(paint.pbr()->anisotropy_rotation == Approx(7 - 2 * 3.14159265358979));
  CHECK(paint.pbr()->base_color == Rgb(1, 0.5, 0));
  CHECK(paint.pbr()->alpha == 0.25);
  CHECK(paint.pbr()->alpha_mode == AlphaMode::blend);
}

TEST_CASE("an index of refraction of 0 stands for an infinite one, others below 1 for none", "[unit][gltf]") {
  for (auto const& [written, expected] : {std::pair{0.0, 0.0}, {0.5, 1.5}, {1.0, 1.0}, {2.0, 2.0}}) {
    GltfWriter writer;
    writer.add_mesh(triangle_positions)["material"] = 0;
    writer.json["materials"] = {{{"name", "m"}, {"extensions", {{"KHR_materials_ior", {{"ior", written}}}}}}};
    CHECK((*import_model(writer).scene.materials.find("m"))->pbr()->ior == expected);
  }
}

TEST_CASE("a texture of specular-glossiness is the highlight's colour, and its alpha makes roughness", "[unit][gltf]") {
  auto const png = [](std::array<std::uint8_t, 4> const& left, std::array<std::uint8_t, 4> const& right) {
    std::array<std::uint8_t, 4> const pixels[] = {left, right};
    return "data:image/png;base64," + testing::encode_base64(test::encode_png(2, 1, pixels));
  };
  GltfWriter writer;
  writer.add_mesh(triangle_positions)["material"] = 0;
  writer.json["images"] = {{{"uri", png({56, 57, 58, 255}, {10, 20, 30, 51})}},
                           {{"uri", png({1, 2, 3, 51}, {4, 5, 6, 51})}}};
  writer.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
  writer.json["samplers"] = {{{"wrapS", 33071}}};
  auto const material = [](char const* name, nlohmann::json const& more) {
    nlohmann::json properties = {{"diffuseFactor", {0.5, 0.25, 0.125, 0.5}}, {"specularFactor", {1, 0.5, 2}}};
    properties.update(more);
    return nlohmann::json{{"name", name}, {"extensions", {{"KHR_materials_pbrSpecularGlossiness", properties}}}};
  };
  nlohmann::json const picture = {{"index", 0}, {"texCoord", 1}};
  writer.json["materials"] = {
      material("half", {{"glossinessFactor", 0.5}, {"specularGlossinessTexture", picture}}),
      material("same", {{"glossinessFactor", 0.5}, {"specularGlossinessTexture", {{"index", 0}}}}),
      material("full", {{"specularGlossinessTexture", picture}}),
      material("even", {{"glossinessFactor", 0.5}, {"specularGlossinessTexture", {{"index", 1}}}}),
      material("bare", {{"glossinessFactor", 0.25}})};
  Model const model = import_model(writer);
  CHECK(messages(model) == "");
  auto const pbr = [&](char const* name) { return *(*model.scene.materials.find(name))->pbr(); };

  PbrModel const half = pbr("half");
  CHECK(half.base_color == Rgb(0.5, 0.25, 0.125));
  CHECK(half.alpha == 0.5);
  CHECK(half.metallic == 0);
  CHECK(half.ior == 0);  // all of the specular colour
  CHECK(half.specular == 1);
  CHECK(half.specular_color == Rgb(1, 0.5, 1));
  REQUIRE(half.specular_color_texture);
  CHECK(half.specular_color_texture.texcoord == 1);
  CHECK(half.specular_color_texture.texture->image->rgba[0] == 56);
  CHECK(half.roughness == 1);
  TextureSlot const& made = half.metallic_roughness_texture;
  REQUIRE(made);
  CHECK(made.texcoord == 1);
  CHECK(made.texture->wrap_s == TextureWrap::clamp_to_edge);
  CHECK(made.texture->image->width == 2);
  CHECK(made.texture->image->height == 1);
  CHECK(made.texture->image->rgba == std::vector<std::uint8_t>{255, 128, 255, 255, 255, 230, 255, 255});

  CHECK(pbr("same").metallic_roughness_texture.texture->image == made.texture->image);  // made once
  CHECK(pbr("full").metallic_roughness_texture.texture->image->rgba[5] == 204);
  CHECK(pbr("even").roughness == Approx(0.9));
  CHECK(!pbr("even").metallic_roughness_texture);
  CHECK(pbr("even").specular_color_texture);

  CHECK(pbr("bare").base_color == half.base_color);
  CHECK(pbr("bare").metallic == 0);
  CHECK(pbr("bare").ior == 0);
  CHECK(pbr("bare").specular_color == half.specular_color);
  CHECK(!pbr("bare").specular_color_texture);
  CHECK(!pbr("bare").metallic_roughness_texture);
  CHECK(pbr("bare").roughness == 0.75);
}

TEST_CASE("Whitted's integrator takes what specular-glossiness reflects for metal as far as it is strong",
          "[unit][gltf]") {
  PbrModel metal;
  metal.base_color = Rgb(1, 0.5, 0.2);
  metal.metallic = 1;
  metal.roughness = 0.25;
  PbrModel glossy = metal;
  glossy.base_color = Rgb(0);
  glossy.metallic = 0;
  glossy.ior = 0;
  glossy.specular_color = metal.base_color;
  Material const expected("", metal), found("", glossy);
  CHECK(glm::distance(found.kd(), expected.kd()) < 0.03);
  CHECK(glm::distance(found.ks(), expected.ks()) < 1e-6);
  CHECK(found.reflect() == Approx(expected.reflect()));

  glossy.base_color = Rgb(0.75, 0.5, 0.25);
  glossy.specular_color = Rgb(0.04);
  Material const plastic("", glossy);
  CHECK(glm::distance(plastic.kd(), glossy.base_color) < 1e-6);
  CHECK(plastic.reflect() == Approx(0).margin(1e-6));

  glossy.specular_color = Rgb(0.52);  // half a metal
  Material const half("", glossy);
  CHECK(glm::distance(half.kd(), 0.5 * glossy.base_color + Rgb(0.2)) < 1e-6);
}

TEST_CASE("a thin film's factor, index, range of thickness and textures are read", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions)["material"] = 0;
  for (int const red : {10, 20}) {
    std::array<std::uint8_t, 4> const texel{std::uint8_t(red), 2, 3, 255};
    writer.json["images"].push_back(
        {{"bufferView", writer.add_view(test::encode_png(1, 1, {&texel, 1}))}, {"mimeType", "image/png"}});
  }
  writer.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  nlohmann::json const film = {{"iridescenceFactor", 0.75},
                               {"iridescenceTexture", {{"index", 1}}},
                               {"iridescenceIor", 1.5},
                               {"iridescenceThicknessMinimum", 200},
                               {"iridescenceThicknessMaximum", 150},
                               {"iridescenceThicknessTexture", {{"index", 0}, {"texCoord", 1}}}};
  writer.json["materials"] = {{{"name", "soap"}, {"extensions", {{"KHR_materials_iridescence", film}}}}};
  Model const model = import_model(writer);
  PbrModel const& soap = *(*model.scene.materials.find("soap"))->pbr();
  CHECK(soap.iridescence == 0.75);
  CHECK(soap.iridescence_ior == 1.5);
  CHECK(soap.iridescence_thickness_minimum == 200);
  CHECK(soap.iridescence_thickness_maximum == 150);  // the other way round is allowed
  REQUIRE(soap.iridescence_texture);
  CHECK(soap.iridescence_texture.texture->image->rgba[0] == 20);
  REQUIRE(soap.iridescence_thickness_texture);
  CHECK(soap.iridescence_thickness_texture.texture->image->rgba[0] == 10);
  CHECK(soap.iridescence_thickness_texture.texcoord == 1);
}

TEST_CASE("a variant gives primitives the materials that they have in it", "[unit][gltf]") {
  GltfWriter writer;
  auto const mappings = [](nlohmann::json const& list) {
    return nlohmann::json{{"KHR_materials_variants", {{"mappings", list}}}};
  };
  auto& shoe = writer.add_mesh(triangle_positions);
  shoe["material"] = 0;
  shoe["extensions"] = mappings({{{"material", 1}, {"variants", {0}}}, {{"material", 2}, {"variants", {1, 2}}}});
  auto& lace = writer.add_mesh(triangle_positions);
  lace["material"] = 0;
  lace["extensions"] = mappings({{{"material", 99}, {"variants", {1}}}, {{"material", 2}, {"variants", {0, "1"}}}});
  writer.add_mesh(triangle_positions)["material"] = 1;
  writer.json["materials"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}};
  writer.json["extensions"]["KHR_materials_variants"]["variants"] = {
      {{"name", "beach"}}, {{"name", "street"}}, {{"name", "1"}}};
  auto const shown = [&](std::string const& variant) {
    ModelOptions options;
    options.variant = variant;
    Model const model = import_model(writer, options);
    CHECK(model.contents.variants == std::vector<std::string>{"beach", "street", "1"});
    std::string names;
    for (char const* const mesh : {"mesh_0", "mesh_1", "mesh_2"}) {
      auto const* const shape = model.scene.shapes.find(mesh);
      REQUIRE(shape);
      names += (*shape)->material()->name();
    }
    return names;
  };
  CHECK(shown("") == "aab");
  CHECK(shown("beach") == "bcb");
  CHECK(shown("0") == "bcb");
  CHECK(shown("street") == "cab");  // a material that does not exist changes nothing
  CHECK(shown("1") == "cab");       // numbers come before names
  CHECK(shown("2") == "cab");
  CHECK_THROWS_WITH(shown("moon"),
                    contains_text("there is no variant 'moon' in the model; it has: 0 'beach', 1 'street', 2 '1'"));
  writer.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  ModelOptions other_scene;
  other_scene.scene = "7";
  CHECK_THROWS_WITH(import_model(writer, other_scene),
                    contains_text("there is no scene '7' in the model; it has: 0 (unnamed), 1 (unnamed)"));
  writer.json.erase("scenes");
  writer.json.erase("extensions");
  CHECK_THROWS_WITH(shown("beach"), contains_text("there is no variant 'beach': the model has no variants"));
}

TEST_CASE("each index of a variant's mapping is compared with its list", "[unit][gltf]") {
  GltfWriter writer;
  writer.add_mesh(triangle_positions);
  writer.json["materials"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}};
  writer.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "beach"}}, {{"name", "street"}}};
  ModelOptions options;
  options.variant = "street";
  using List = std::vector<nlohmann::json>;
  auto const told = [&](List const& list) {
    writer.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = list;
    std::string text = messages(import_model(writer));
    CHECK(messages(import_model(writer, options)) == text);
    for (std::size_t at;
         (at = text.find("/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings")) != std::string::npos;) {
      text.erase(at, std::string("/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings").size());
    }
    return text;
  };
  CHECK(told(List{{{"material", 1}, {"variants", {0, 0}}}, {{"material", 2}, {"variants", {1}}}}).empty());
  CHECK_THAT(told(List{{{"material", 3}, {"variants", {1}}}}),
             contains_text("/0/material: material 3 is out of range (3)"));
  CHECK_THAT(told(List{{{"variants", {1}}}}), contains_text("/0/material: it is missing"));
  CHECK_THAT(told(List{{{"material", "1"}, {"variants", {1}}}}),
             contains_text("/0/material: expected a non-negative integer"));
  CHECK_THAT(told(List{{{"material", 1}, {"variants", {0, 2}}}}),
             contains_text("/0/variants/1: variant 2 is out of range (2)"));
  CHECK_THAT(told(List{{{"material", 1}, {"variants", {-1}}}}),
             contains_text("/0/variants/0: expected a non-negative integer"));
  CHECK_THAT(told(List{{{"material", 1}, {"variants", {0, 1}}}, {{"material", 2}, {"variants", {1}}}}),
             contains_text("/1/variants/0: mapping 0 has variant 1 already, and counts"));

  // One that is left out counts for nothing: the next one does.
  CHECK_THAT(told(List{{{"material", 3}, {"variants", {1}}}, {{"material", 2}, {"variants", {1}}}}),
             !contains_text("already"));
  Model const model = import_model(writer, options);
  auto const* const shape = model.scene.shapes.find("mesh_0");
  REQUIRE(shape);
  CHECK((*shape)->material()->name() == "c");
}
