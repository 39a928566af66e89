/// Frames of materials on meshes: along what anisotropic ones are stretched, and the normals of coats, against
/// directions made by hand.

#include <glm/trigonometric.hpp>

#include "reference.hpp"
#include "scene/flatten.hpp"
#include "scene_arguments.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// A square that faces z; its texture's u is along x, and v is down.
MeshGeometry square() {
  MeshGeometry mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.texcoords = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

PbrModel anisotropic(double rotation_degrees = 0) {
  PbrModel pbr;
  pbr.roughness = 0.3;
  pbr.anisotropy = 0.5;
  pbr.anisotropy_rotation = glm::radians(rotation_degrees);
  return pbr;
}

TextureSlot one_texel(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  auto image = std::make_shared<TextureImage>();
  image->width = image->height = 1;
  image->rgba = {red, green, blue, 255};
  TextureSlot slot;
  slot.texture = std::make_shared<Texture const>(Texture{image});
  return slot;
}

std::shared_ptr<Shape> shape(MeshGeometry const& mesh, PbrModel const& pbr) {
  return std::make_shared<Mesh>("mesh", std::make_shared<MeshGeometry>(mesh), std::make_shared<Material>("", pbr));
}

/// What a kernel of points.cl says of the point that a ray along z meets near the middle, in both layouts.
Vec3 at_middle(std::shared_ptr<Shape> const& shape, std::string const& kernel, double from_z = 5) {
  std::vector<float4> const origins{to_float4({0.1, 0.2, from_z})}, directions{to_float4({0, 0, from_z > 0 ? -1 : 1})};
  std::vector<Vec3> found;
  for (Traversal const traversal : {Traversal::scalar, Traversal::wide}) {
    auto const buffers = compile_scene(flatten({shape}), {}, traversal.layout);
    CHECK((buffers.shading.features & SCENE_TANGENTS) != 0);
    std::vector<float4> vectors(1);
    auto arguments = scene_arguments(buffers);
    arguments.insert(arguments.end(), {in(origins), in(directions), out(vectors)});
    ProbeProgram("points.cl", scene_options(buffers, traversal)).run(kernel, 1, arguments);
    REQUIRE(std::isfinite(vectors[0].w));
    found.push_back(to_vec3(vectors[0]));
  }
  CHECK(found[0] == found[1]);
  return found[0];
}

Vec3 tangent(std::shared_ptr<Shape> const& shape, double from_z = 5) {
  return at_middle(shape, "probe_tangents", from_z);
}
Vec3 tangent(MeshGeometry const& mesh, PbrModel const& pbr) { return tangent(shape(mesh, pbr)); }

void check_near(Vec3 const& found, Vec3 const& expected) {
  CAPTURE(found.x, found.y, found.z, expected.x, expected.y, expected.z);
  CHECK(glm::distance(found, expected) < 1e-5);
}

}  // namespace

TEST_CASE("anisotropic materials are stretched along tangents, turned by rotation and texture", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  MeshGeometry mesh = square();
  Vec3 const x(1, 0, 0), y(0, 1, 0);
  SECTION("texture coordinates say where u is") {
    check_near(tangent(mesh, anisotropic()), x);
    check_near(tangent(mesh, anisotropic(90)), y);
    check_near(tangent(mesh, anisotropic(30)), {std::sqrt(0.75), 0.5, 0});
    for (Float2& uv : mesh.texcoords[0]) uv = {uv[1], 1 - uv[0]};
    check_near(tangent(mesh, anisotropic()), -y);
    check_near(tangent(mesh, anisotropic(90)), x);
  }
  SECTION("vertices' tangents come first") {
    mesh.tangents.assign(4, {0, 1, 0, 1});
    check_near(tangent(mesh, anisotropic()), y);
    check_near(tangent(mesh, anisotropic(90)), -x);
    mesh.tangents.assign(4, {0, 1, 0, -1});
    check_near(tangent(mesh, anisotropic(90)), x);
    mesh.texcoords.clear();
    check_near(tangent(mesh, anisotropic()), y);
  }
  SECTION("the texture holds a direction") {
    PbrModel pbr = anisotropic();
    pbr.anisotropy_texture = one_texel(0, 255, 255);
    check_near(tangent(mesh, pbr), glm::normalize(y - x));
    pbr.anisotropy_rotation = glm::radians(45.0);
    check_near(tangent(mesh, pbr), -x);
  }
  SECTION("nodes turn and mirror it") {
    auto const turned = shape(mesh, anisotropic(90));
    turned->rotate(90, {0, 0, 1});
    check_near(tangent(turned), -x);
    mesh.tangents.assign(4, {1, 0, 0, 1});
    auto const mirrored = shape(mesh, anisotropic(30));
    mirrored->scale({-1, 1, 1});
    check_near(tangent(mirrored), {-std::sqrt(0.75), 0.5, 0});
  }
  SECTION("both sides are stretched along one line") {
    Vec3 const front = tangent(shape(mesh, anisotropic(30)));
    check_near(tangent(shape(mesh, anisotropic(30)), -5), front);
  }
  SECTION("without tangents and texture coordinates nothing says so") {
    mesh.texcoords.clear();
    check_near(tangent(mesh, anisotropic()), Vec3(0));
  }
}

TEST_CASE("a coat has the normal of its own map, and none of the base's", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  MeshGeometry mesh = square();
  PbrModel pbr;
  pbr.clearcoat = 1;
  pbr.normal_texture = one_texel(255, 128, 255);
  auto const coat = [&](double from_z = 5) { return at_middle(shape(mesh, pbr), "probe_coat_normals", from_z); };
  check_near(coat(), {0, 0, 1});
  check_near(coat(-5), {0, 0, -1});
  mesh.normals.assign(4, {0, 0.6f, 0.8f});
  check_near(coat(), {0, 0.6, 0.8});
  mesh.normals.assign(4, {0, 0, 1});
  pbr.clearcoat_normal_texture = one_texel(255, 0, 255);
  check_near(coat(), glm::normalize(Vec3(1, -1, 1)));
  pbr.clearcoat_normal_scale = 0.5;
  check_near(coat(), glm::normalize(Vec3(0.5, -0.5, 1)));
  check_near(coat(-5), -glm::normalize(Vec3(0.5, -0.5, 1)));
  pbr.normal_texture = {};
  check_near(coat(), glm::normalize(Vec3(0.5, -0.5, 1)));
}
