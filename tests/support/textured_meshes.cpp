#include "support/textured_meshes.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

namespace lichtraum::test {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

std::shared_ptr<Texture const> make_texture(int size, TextureWrap wrap, TextureFilter filter,
                                            std::function<Rgba(int, int)> const& texel) {
  auto image = std::make_shared<TextureImage>();
  image->width = size;
  image->height = size / 2;
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      Rgba const rgba = texel(x, y);
      image->rgba.insert(image->rgba.end(), rgba.begin(), rgba.end());
    }
  }
  return std::make_shared<Texture const>(Texture{image, wrap, TextureWrap::mirrored_repeat, filter});
}

std::uint8_t byte(double x) { return std::uint8_t(std::lround(255 * x)); }

/// A patch of a sphere of n x n quads, with everything: two sets of texture coordinates (the second mirrored along u),
/// colours, normals, tangents.
std::shared_ptr<MeshGeometry> make_patch(int n) {
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->texcoords.resize(2);
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      double const u = double(k) / n, v = double(i) / n;
      double const longitude = (u - 0.5) * 2.4, latitude = (0.5 - v) * 2.0;
      Vec3 const p(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                   std::cos(longitude) * std::cos(latitude));
      Vec3 const t(std::cos(longitude), 0, -std::sin(longitude));
      geometry->positions.push_back({float(p.x), float(p.y), float(p.z)});
      geometry->normals.push_back({float(p.x), float(p.y), float(p.z)});
      geometry->tangents.push_back({float(t.x), 0, float(t.z), 1});
      geometry->texcoords[0].push_back({float(u), float(v)});
      geometry->texcoords[1].push_back({float(1.2 - 2 * u), float(3 * v - 0.3)});
      geometry->colors.push_back({float(0.4 + 0.6 * u), float(1 - 0.5 * v), 0.8f, float(0.3 + 0.6 * u * v)});
    }
  }
  auto const vertex = [&](int i, int k) { return std::uint32_t(i * (n + 1) + k); };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      auto const a = vertex(i, k), b = vertex(i + 1, k), c = vertex(i + 1, k + 1), d = vertex(i, k + 1);
      geometry->indices.insert(geometry->indices.end(), {a, b, c, a, c, d});
    }
  }
  return geometry;
}

std::shared_ptr<MeshGeometry> without(MeshGeometry const& geometry, bool normals, bool tangents, bool colors) {
  auto copy = std::make_shared<MeshGeometry>(geometry);
  if (normals) copy->normals.clear();
  if (normals || tangents) copy->tangents.clear();
  if (colors) copy->colors.clear();
  return copy;
}

std::shared_ptr<Material> make_material(std::string name, PbrModel const& pbr) {
  return std::make_shared<Material>(std::move(name), pbr);
}

}  // namespace

Scene make_textured_scene() {
  auto const stripes = [](double low) {
    return [low](int x, int y) {
      return Rgba{byte(0.2 + 0.1 * (x % 8)), byte(0.9), byte(0.1 * (y % 8)), byte((x + y) % 4 < 2 ? low : 0.9)};
    };
  };
  auto const color = make_texture(16, TextureWrap::repeat, TextureFilter::linear, stripes(0.1));
  auto const bumps = make_texture(32, TextureWrap::mirrored_repeat, TextureFilter::linear, [](int x, int y) {
    Vec3 const n = glm::normalize(Vec3(0.6 * std::sin(x * 0.8), 0.5 * std::cos(y * 0.7), 1));
    return Rgba{byte(0.5 + 0.5 * n.x), byte(0.5 + 0.5 * n.y), byte(0.5 + 0.5 * n.z), 255};
  });
  auto const data = make_texture(8, TextureWrap::clamp_to_edge, TextureFilter::linear, [](int x, int y) {
    return Rgba{byte(x / 8.0), byte(0.3 + 0.6 * y / 4.0), byte(x % 2), byte(0.5)};
  });
  auto const slot = [](std::shared_ptr<Texture const> const& texture, int texcoord = 0) {
    TextureSlot result;
    result.texture = texture;
    result.texcoord = texcoord;
    return result;
  };

  PbrModel full;  // everything that Phong's mapping reads
  full.base_color = {1, 0.9, 0.8};
  full.base_color_texture = slot(color, 1);
  full.base_color_texture.scale = {1.5, 0.7};
  full.base_color_texture.rotation_radians = 0.4;
  full.base_color_texture.offset = {0.1, -0.2};
  full.metallic_roughness_texture = slot(data);
  full.occlusion_texture = slot(data, 1);
  full.emissive = Rgb(0.2, 0.1, 0.3);
  full.emissive_texture = slot(data);
  full.specular_texture = slot(data);
  full.specular_color_texture = slot(color);
  full.normal_texture = slot(bumps, 1);
  full.normal_scale = 0.8;
  PbrModel masked;
  masked.base_color_texture = slot(color);
  masked.metallic = 0;
  masked.alpha_mode = AlphaMode::mask;
  PbrModel blended;
  blended.base_color = {0.9, 0.5, 0.4};
  blended.alpha = 0.9;
  blended.metallic = 0.3;
  blended.roughness = 0.5;
  blended.alpha_mode = AlphaMode::blend;
  PbrModel clear;
  clear.metallic = 0;
  clear.roughness = 0.2;
  clear.transmission = 0.8;
  clear.thickness = 1;
  clear.transmission_texture = slot(data);
  PbrModel glowing;
  glowing.unlit = true;
  glowing.base_color_texture = slot(color);

  auto const all = make_patch(6);
  struct Piece {
    std::shared_ptr<MeshGeometry const> geometry;
    std::shared_ptr<Material> material;
  };
  Piece const pieces[] = {
      {without(*all, false, false, true), make_material("full", full)},
      {without(*all, false, true, true), make_material("full without tangents", full)},
      {without(*all, true, true, true), make_material("full without normals", full)},
      {without(*all, false, false, true), make_material("masked", masked)},
      {all, make_material("blended", blended)},
      {without(*all, false, false, true), make_material("clear", clear)},
      {all, make_material("glowing", glowing)},
      {all, std::make_shared<Material>("phong", Rgb(0.3, 0.5, 0.7), Rgb(0.3, 0.5, 0.7), Rgb(0.5), 30)},
  };
  Scene scene;
  Composite::Children row, instances;
  double x = -4.2;
  for (Piece const& piece : pieces) {
    auto mesh = std::make_shared<Mesh>(piece.material->name() + " mesh", piece.geometry, piece.material);
    mesh->scale(Vec3(0.5, 0.8, 0.4));
    mesh->rotate(25, {0.3, 1, 0});
    mesh->translate({x, 1.6, 0});
    row.push_back(mesh);
    instances.push_back(std::make_shared<Mesh>(piece.material->name() + " twice", piece.geometry, piece.material));
    instances.back()->scale(0.5);
    instances.back()->translate({x, 0, 0.1 * x});
    scene.materials.insert(piece.material);
    x += 1.2;
  }
  auto const once = std::make_shared<Composite>("once", row);
  auto const shared = std::make_shared<Composite>("shared", instances);
  auto const mirrored = std::make_shared<Composite>("mirrored", Composite::Children{shared});
  mirrored->scale(Vec3(-1, 1.1, 0.6));
  mirrored->rotate(-12, {0.1, 1, 0.2});
  auto const stretched = std::make_shared<Composite>("stretched", Composite::Children{shared});
  stretched->scale(Vec3(0.9, 1.3, 1.5));
  stretched->rotate(200, {0, 1, 0.02});
  stretched->translate({0, -1.7, 0});
  auto const white = std::make_shared<Material>("white", Rgb(0.8), Rgb(0.8), Rgb(0), 1);
  auto const wall = std::make_shared<Box>("wall", Vec3(-20, -20, -3), Vec3(20, 20, -2), white);
  for (auto const& shape : row) scene.shapes.insert(shape);
  for (auto const& shape : instances) scene.shapes.insert(shape);
  for (auto const& shape : {once, shared, mirrored, stretched}) scene.shapes.insert(shape);
  scene.shapes.insert(wall);
  scene.materials.insert(white);
  scene.lights.insert(Light::ambient("soft", Rgb(0.2)));
  scene.lights.insert(Light::point("constant", {-5, 6, 8}, Rgb(0.3, 0.35, 0.4)));
  scene.lights.insert(Light::falling_off("near", {3, 0.5, 3}, Rgb(3, 2.5, 2), 9));
  scene.lights.insert(Light::spot("spot", {-2, 4, 6}, {0.2, -0.6, -1}, Rgb(25), {5, 20}));
  scene.lights.insert(Light::directional("sun", {0.5, -0.7, -1}, Rgb(0.3)));
  scene.background = Rgb(0.3, 0.4, 0.6);
  scene.cameras.insert(Camera("eye", 50, Transform::translation({0, 0.1, 11}), Resolution{240, 150}));
  return scene;
}

}  // namespace lichtraum::test
