/// Pictures of textured meshes: every layout agrees with the reference renderer, and small glTF models show what they
/// must.

#include <fmt/format.h>

#include <functional>

#include "lichtraum/gltf.hpp"
#include "reference/thin_film.hpp"
#include "support/catch.hpp"
#include "support/encode_png.hpp"
#include "support/gltf_import.hpp"
#include "support/gltf_writer.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"
#include "support/textured_meshes.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using nlohmann::json;

namespace {

using Rgba = std::array<std::uint8_t, 4>;
Rgba const red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255}, half_white{255, 255, 255, 128};

/// A square from (-1, -1) to (1, 1) with a picture of 2 x 2 texels on it (upper row first), seen from the front.
testing::GltfWriter square_model(std::array<Rgba, 4> const& texels) {
  testing::GltfWriter writer;
  auto& primitive = writer.add_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  int const texcoords = writer.add_accessor("VEC2", 2, std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0});
  int const indices = writer.add_accessor("SCALAR", 1, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3});
  primitive["attributes"]["TEXCOORD_0"] = texcoords;
  primitive["indices"] = indices;
  primitive["material"] = 0;
  int const view = writer.add_view(encode_png(2, 2, texels));
  writer.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  writer.json["samplers"] = {{{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33071}}};
  writer.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  writer.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}},
                               {"extensions", {{"KHR_materials_unlit", json::object()}}}}};
  // tan(45 degrees) * 1: the square fills the picture.
  writer.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.57079632679}, {"znear", 0.1}, {"aspectRatio", 1}}}}};
  writer.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 1}}});
  return writer;
}

/// The picture of a model on every device in every layout; `check` gets each.
void for_each_picture(testing::GltfWriter const& writer, std::function<void(Image const&)> const& check) {
  TemporaryFolder const folder;
  Model model = import_gltf(folder.write("model.glb", writer.glb()));
  for (Diagnostic const& d : model.diagnostics) UNSCOPED_INFO(d.message);
  CHECK(model.diagnostics.empty());
  model.scene.background = Rgb(0.25);
  RenderRequest const request = whole_picture(model.scene.cameras.front(), {16, 16});
  {
    INFO("reference");
    check(render_reference(model.scene, request));
  }
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [name, traversal] : layouts_of(device)) {
      INFO("device " << device.index << ", " << name);
      check(render_on(device, model.scene, request, traversal));
    }
  }
}

void check_pixel(Image const& image, int x, int y, Rgb const& expected) {
  float const* const c = image.pixel(x, y);
  INFO("pixel " << x << ", " << y << ": " << c[0] << " " << c[1] << " " << c[2]);
  CHECK(glm::distance(Rgb(c[0], c[1], c[2]), expected) < 0.005);
}

}  // namespace

TEST_CASE("textured meshes look alike on the reference renderer and on every device, in every layout", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = make_textured_scene();
  for (int const depth : {0, 4}) {
    RenderRequest request = whole_picture(scene.cameras.front(), *scene.cameras.front().resolution());
    request.max_depth = depth;
    check_layouts(scene, request, fmt::format("textured at depth {}", depth));
  }
}

TEST_CASE("a texture's first texel is at the top left, and stored sRGB becomes light", "[image]") {
  for_each_picture(square_model({red, green, blue, Rgba{128, 128, 128, 255}}), [](Image const& image) {
    check_pixel(image, 3, 3, {1, 0, 0});
    check_pixel(image, 12, 3, {0, 1, 0});
    check_pixel(image, 3, 12, {0, 0, 1});
    check_pixel(image, 12, 12, Rgb(0.2158605));  // 128 / 255 decoded
  });
}

TEST_CASE("a texture transform turns, scales and moves", "[image]") {
  testing::GltfWriter writer = square_model({red, green, blue, Rgba{255, 255, 255, 255}});
  // KHR_texture_transform: a quarter turn counter-clockwise about (0, 0) and back into the picture.
  writer.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"rotation", 1.57079632679}, {"offset", {0, 1}}};
  for_each_picture(writer, [](Image const& image) {
    // u' = v, v' = 1 - u: the picture is turned clockwise.
    check_pixel(image, 3, 3, {0, 0, 1});
    check_pixel(image, 12, 3, {1, 0, 0});
    check_pixel(image, 3, 12, {1, 1, 1});
    check_pixel(image, 12, 12, {0, 1, 0});
  });
}

TEST_CASE("a mask cuts, a blend lets its share through", "[image]") {
  testing::GltfWriter writer = square_model({red, half_white, Rgba{0, 255, 0, 0}, half_white});
  SECTION("opaque") {
    for_each_picture(writer, [](Image const& image) {
      check_pixel(image, 12, 3, Rgb(1));
      check_pixel(image, 3, 12, {0, 1, 0});
    });
  }
  SECTION("mask") {
    writer.json["materials"][0]["alphaMode"] = "MASK";
    writer.json["materials"][0]["alphaCutoff"] = 0.6;
    for_each_picture(writer, [](Image const& image) {
      check_pixel(image, 3, 3, {1, 0, 0});
      check_pixel(image, 12, 3, Rgb(0.25));
      check_pixel(image, 3, 12, Rgb(0.25));
    });
  }
  SECTION("blend") {
    writer.json["materials"][0]["alphaMode"] = "BLEND";
    double const share = 128.0 / 255;
    for_each_picture(writer, [=](Image const& image) {
      check_pixel(image, 3, 3, {1, 0, 0});
      check_pixel(image, 12, 3, Rgb(share + (1 - share) * 0.25));
      check_pixel(image, 3, 12, Rgb(0.25));
    });
  }
}

TEST_CASE("vertex colours multiply the texture", "[image]") {
  testing::GltfWriter writer = square_model({red, red, green, green});
  int const colors = writer.add_accessor(
      "VEC4", 4, std::vector<float>{0.5f, 0.5f, 1, 1, 0.5f, 0.5f, 1, 1, 0.5f, 0.5f, 1, 1, 0.5f, 0.5f, 1, 1});
  writer.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colors;
  for_each_picture(writer, [](Image const& image) {
    check_pixel(image, 3, 3, {0.5, 0, 0});
    check_pixel(image, 12, 12, {0, 0.5, 0});
  });
}

TEST_CASE("specular-glossiness looks the same by its factors and by a picture of one colour", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Rgba const white{255, 255, 255, 255};
  auto const picture = [&](json extension, Integrator integrator, bool has_picture) {
    auto writer = square_model({white, white, white, white});
    if (has_picture) extension["specularGlossinessTexture"] = {{"index", 0}};
    writer.json["materials"][0] = {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", extension}}}};
    TemporaryFolder const folder;
    Model const model = import_gltf(folder.write("model.glb", writer.glb()));
    CHECK(model.diagnostics.empty());
    RenderRequest request = whole_picture(model.scene.cameras.front(), {16, 16});
    request.integrator = integrator;
    return render_on(opencl_devices().front(), model.scene, request).data();
  };
  json const plastic = {
      {"diffuseFactor", {0.8, 0.4, 0.2, 1}}, {"specularFactor", {0.2, 0.3, 0.4}}, {"glossinessFactor", 0.6}};
  json const gold = {{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1, 0.8, 0.3}}, {"glossinessFactor", 0.7}};
  for (json const& material : {plastic, gold}) {
    for (Integrator const integrator : {Integrator::whitted, Integrator::path}) {
      INFO(material.dump() << ' ' << int(integrator));
      auto const by_factors = picture(material, integrator, false);
      CHECK(by_factors == picture(material, integrator, true));
      CHECK(by_factors[3 * (16 * 8 + 8)] > 0.05f);
    }
  }
}

TEST_CASE("a thin film's share is in the red of its texture, its thickness in the green", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::array<Rgba, 4> const texels{{{255, 255, 0, 0}, {255, 0, 0, 0}, {0, 255, 255, 255}, {102, 51, 255, 255}}};
  auto writer = square_model(texels);
  json const texture = {{"index", 0}};
  writer.json["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorFactor", {0.8, 0.6, 0.4, 1}}}},
                                 {"extensions",
                                  {{"KHR_materials_iridescence",
                                    {{"iridescenceFactor", 0.75},
                                     {"iridescenceTexture", texture},
                                     {"iridescenceIor", 1.8},
                                     {"iridescenceThicknessMinimum", 500},
                                     {"iridescenceThicknessMaximum", 250},
                                     {"iridescenceThicknessTexture", texture}}}}}};
  TemporaryFolder const folder;
  Model const model = import_gltf(folder.write("model.glb", writer.glb()));
  CHECK(model.diagnostics.empty());
  RenderRequest request = whole_picture(model.scene.cameras.front(), {16, 16});
  request.integrator = Integrator::path;
  request.planes = {FilmPlane::albedo};
  Rgb const metal(0.8, 0.6, 0.4);
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    Film const film = film_on(device, model.scene, request);
    auto const albedo = film.values(FilmPlane::albedo);
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        Rgba const& texel = texels[std::size_t(row / 8 * 2 + column / 8)];
        double const share = 0.75 * texel[0] / 255, thickness_nm = 500 - 250 * texel[1] / 255.0;
        double const x = (column - 7.5) / 8, y = (row - 7.5) / 8, cosine = 1 / std::sqrt(1 + x * x + y * y);
        double const grazing = std::pow(1 - cosine, 5);
        Rgb const head_on = (thin_film_reflectance(1.8, thickness_nm, cosine, metal) - grazing) / (1 - grazing);
        Rgb const expected = glm::mix(metal, glm::clamp(head_on, 0.0, 1.0), share);
        INFO(device.name << ", row " << row << ", column " << column);
        for (int c = 0; c < 3; ++c) {
          CHECK(albedo[std::size_t(3 * (16 * row + column) + c)] == Approx(expected[c]).margin(1e-4));
        }
      }
    }
  }
}

TEST_CASE("what diffuse transmission lets through has the colour and the share of its textures", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  testing::GltfWriter writer = square_model({Rgba{255, 128, 64, 255}, Rgba{64, 255, 128, 128}, red, half_white});
  json const texture = {{"index", 0}};
  writer.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}}},
                               {"doubleSided", true},
                               {"extensions",
                                {{"KHR_materials_specular", {{"specularFactor", 0}}},
                                 {"KHR_materials_diffuse_transmission",
                                  {{"diffuseTransmissionFactor", 1},
                                   {"diffuseTransmissionTexture", texture},
                                   {"diffuseTransmissionColorFactor", {0.5, 0.9, 0.7}},
                                   {"diffuseTransmissionColorTexture", texture}}}}}}};
  Model model = testing::import_model(writer);
  model.scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
  RenderRequest request = whole_picture(model.scene.cameras.front(), {8, 8});
  request.integrator = Integrator::path;
  request.sampling = {Sampling::Pattern::seeded, 1024};
  Image const picture = render_on(opencl_devices().front(), model.scene, request);
  double const half = 128 / 255.0, dark = 0.21586, darker = 0.05127;  // sRGB's 128 and 64
  auto const check = [&](int x, int y, Rgb const& expected) {
    Rgb mean(0);
    for (int i = 0; i < 4; ++i) {
      float const* const c = picture.pixel(x + i % 2, y + i / 2);
      mean += 0.25 * Rgb(c[0], c[1], c[2]);
    }
    INFO(mean.r << " " << mean.g << " " << mean.b);
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == Approx(expected[c]).margin(0.01));
  };
  check(1, 1, Rgb(0.5, 0.9 * dark, 0.7 * darker));
  check(5, 1, half * Rgb(0.5 * darker, 0.9, 0.7 * dark));
  check(1, 5, Rgb(0.5, 0, 0));
  check(5, 5, half * Rgb(0.5, 0.9, 0.7));
}
