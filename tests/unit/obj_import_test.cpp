#include <filesystem>

#include "support/gltf_triangles.hpp"
#include "support/obj_import.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using testing::Corners;
using testing::world_triangles;

TEST_CASE("OBJ: a triangle, with a camera and lights that show it", "[unit][obj]") {
  Model const model = import_text("# a comment\r\n\r\n" + triangle);
  CHECK(shown(model.diagnostics) == "");
  auto const triangles = world_triangles(model.scene);
  REQUIRE(triangles.size() == 1);
  CHECK(triangles[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  CHECK(model.scene.cameras.size() == 1);
  CHECK(model.scene.lights.size() == 3);
  CHECK(model.scene.roots().at(0)->name() == "m");
}

TEST_CASE("OBJ: corners with texture coordinates and normals share vertices; missing ones are zeros", "[unit][obj]") {
  Model const model = import_text(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvn 0 0 2\nvn 0 3 4\n"
      "f 1/1/1 2/2/1 3/2/1 4/1/1\nf 1/1/1 2/2/1 3//2\nf -4/-2 -3/-1/-1 -2\n");
  CHECK(shown(model.diagnostics) == "");
  MeshGeometry const& g = *mesh_of(model.scene, "mesh").geometry();
  CHECK(g.triangle_count() == 4);
  CHECK(g.positions.size() == 4 + 1 + 3);  // a corner each of the second face, and all of the third, is another
  REQUIRE(g.texcoords.size() == 1);
  CHECK(g.texcoords[0][0] == Float2{0, 1});  // from above
  CHECK(g.texcoords[0][1] == Float2{1, 0.75f});
  CHECK(g.normals[0] == Float3{0, 0, 1});
  CHECK(g.normals[4] == Float3{0, 0.6f, 0.8f});
  CHECK(g.normals.back() == Float3{0, 0, 0});
  CHECK(g.texcoords[0].back() == Float2{0, 0});
}

TEST_CASE("OBJ: smoothing groups have normals where the file has none", "[unit][obj]") {
  // Three sides of a cube. Around the corner 1 there is one triangle of a side, or two: their angles count.
  std::string const cube = "v 0 0 0\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\nv 0 -1 -1\nv 0 0 -1\nv -1 0 -1\nvn 0 0 9\n";
  auto const normals_of_corner = [&](std::string const& faces) {
    MeshGeometry const geometry = *mesh_of(import_text(cube + faces).scene, "mesh").geometry();
    std::vector<Float3> normals;  // in the order of the faces
    for (std::uint32_t const i : geometry.indices) {
      if (geometry.positions[i] == Float3{0, 0, 0} && !geometry.normals.empty()) normals.push_back(geometry.normals[i]);
    }
    return normals;
  };
  auto const is_near = [](Float3 const& a, Vec3 const& b) {
    return glm::length(Vec3(a[0], a[1], a[2]) - glm::normalize(b)) < 1e-6;
  };
  auto const smooth = normals_of_corner("s 7\nf 1 2 3\nf 1 3 4\nf 1 4 5 6\nf 6 7 2 1\n");
  REQUIRE(smooth.size() == 5);
  for (Float3 const& n : smooth) CHECK(is_near(n, {1, 1, 1}));

  auto const creased = normals_of_corner("s 1\nf 1 2 3 4\ns 2\nf 1 4 5 6\ns 1\nf 6 7 2 1\ns off\nf 1 2 3\n");
  REQUIRE(creased.size() == 6);
  for (std::size_t const i : {0u, 1u, 4u}) CHECK(is_near(creased[i], {0, 1, 1}));
  CHECK(is_near(creased[2], {1, 0, 0}));
  CHECK(creased[5] == Float3{0, 0, 0});  // its triangle's own

  auto const given = normals_of_corner("s on\nf 1//1 2//1 3//1 4//1\nf 1 4 5 6\n");
  REQUIRE(given.size() == 4);
  CHECK(given[0] == Float3{0, 0, 1});
  CHECK(given[2] == Float3{1, 0, 0});

  CHECK(normals_of_corner("f 1 2 3 4\nf 1 4 5 6\n").empty());
  CHECK(normals_of_corner("s 0\nf 1 2 3 4\n").empty());
  // Triangles that are left out take no other's group with them.
  auto const faulty = normals_of_corner("s 1\nf 1 2 99\ns 0\nf 1 2 3 4\ns 1\nf 1 4 5 6\n");
  REQUIRE(faulty.size() == 4);
  CHECK(faulty[0] == Float3{0, 0, 0});
  CHECK(is_near(faulty[2], {1, 0, 0}));
}

TEST_CASE("OBJ: a mesh for each material of each object and group, however they alternate", "[unit][obj]") {
  Model const model = import_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\no car\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n"
      "g wheel left\nf 1 2 3\no car\nf 1 2 3\n");
  CHECK(mesh_of(model.scene, "car.red").geometry()->triangle_count() == 3);
  CHECK(mesh_of(model.scene, "car.blue").geometry()->triangle_count() == 1);
  CHECK(mesh_of(model.scene, "car.wheel left.red").geometry()->triangle_count() == 1);
  CHECK(shown(model.diagnostics) == "m.obj:5:8: there is no material 'red' nor 1 other: no mtllib names an MTL file\n");
}

TEST_CASE("OBJ: colours of vertices become linear", "[unit][obj]") {
  Model const model = import_text("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
  auto const& colors = mesh_of(model.scene, "mesh").geometry()->colors;
  REQUIRE(colors.size() == 3);
  CHECK(colors[0] == Float4{1, 1, 1, 1});
  CHECK(colors[1][0] == 1);
  CHECK(colors[1][1] == Approx(0.2140411));  // IEC 61966-2-1
  CHECK(colors[1][2] == 0);
  CHECK(mesh_of(model.scene, "mesh").material()->pbr());  // they change its base colour
}

TEST_CASE("OBJ: colours of vertices that are written as bytes are read as such", "[unit][obj]") {
  Model const model = import_text("v 0 0 0 255 128 0\nv 1 0 0\nv 0 1 0 1 1 1\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
  CHECK(shown(model.diagnostics) == "m.obj:0:0: colours go up to 255: read as 0 to 255, though OBJ's go from 0 to 1\n");
  auto const& colors = mesh_of(model.scene, "mesh").geometry()->colors;
  REQUIRE(colors.size() == 4);
  CHECK(colors[0][0] == Approx(1));
  CHECK(colors[0][1] == Approx(0.2158605));  // IEC 61966-2-1
  CHECK(colors[0][2] == 0);
  CHECK(colors[1] == Float4{1, 1, 1, 1});  // has none
  CHECK(colors[2][0] == Approx(1 / (255 * 12.92)));
  CHECK(colors[3] == Float4{1, 1, 1, 1});
  // A little more than white is no byte.
  CHECK(shown(import_text("v 0 0 0 1.01 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").diagnostics) == "");
}

TEST_CASE("OBJ: what is wrong is told with its place and left out", "[unit][obj]") {
  struct Case {
    std::string text;
    std::string expected;
  };
  Case const cases[] = {
      {triangle + "v 1 x 3\n", "m.obj:5:5: 'x' is not a number\n"},
      {triangle + "v 1 2\n", "m.obj:5:6: expected 3 numbers, found 2\n"},
      {triangle + "v 1 1e99 nan\n", "m.obj:5:5: '1e99' is too large\n"},
      {triangle + "v nan 1 1\nf 1 2 4\nf 4 2 3 1\n",
       "m.obj:0:0: 3 triangles left out: they have a vertex that is not finite\n"
       "m.obj:5:3: 'nan' is not a finite number\n"},
      {triangle + "f 1 2 9\n",
       "m.obj:0:0: 1 triangle left out: it has a vertex that is not there\n"
       "m.obj:5:7: there is no vertex 9; the file has 3\n"},
      {triangle + "f 1 2 -4\n", "m.obj:5:7: expected vertex/texture/normal, found '-4': the face is left out\n"},
      {triangle + "f 1 2 0\n", "m.obj:5:7: expected vertex/texture/normal, found '0': the face is left out\n"},
      {triangle + "f 1 2 99999999999999999999\n",
       "m.obj:5:7: expected vertex/texture/normal, found '99999999999999999999': the face is left out\n"},
      {triangle + "f 1 2\n", "m.obj:5:1: a face of 2 corners is left out\n"},
      {triangle + "f 1/5 2 3\n", "m.obj:0:0: 1 corner names a texture coordinate or normal that is not there\n"},
      {triangle + "l 1 2\np 1\n",
       "m.obj:5:0: lines are not drawn beside faces\nm.obj:6:0: points are not drawn beside faces\n"},
      {"p 1\n" + triangle + "p 2\nl 1 2\nl 3 2\n",
       "m.obj:1:0: points are not drawn beside faces\nm.obj:7:0: lines are not drawn beside faces\n"},
      {triangle + "curv 0 1 1 2\nsurf 0 1\n", "m.obj:5:0: free-form curves and surfaces are not drawn\n"},
      {"vx 1 2 3\n" + triangle, "m.obj:1:1: unknown OBJ keyword 'vx': the line is left out\n"},
      {triangle + "s 1x\n", "m.obj:5:3: expected a smoothing group's number or off, found '1x'\n"},
      {triangle + "s -1\n", "m.obj:5:3: expected a smoothing group's number or off, found '-1'\n"},
      {"mtllib nowhere.mtl\n" + triangle, "m.obj:1:8: cannot open '" +
                                              (std::filesystem::current_path() / "nowhere.mtl").string() +
                                              "': No such file or directory\n"},
  };
  for (Case const& c : cases) {
    INFO(c.text);
    CHECK(shown(import_text(c.text).diagnostics) == c.expected);
  }
}

TEST_CASE("OBJ: nothing to draw is an error; faces may come before their vertices; lines may go on", "[unit][obj]") {
  for (char const* text : {"", "garbage", "\x01\x02\xFF", "f 1 2 3\n"}) {
    CHECK_THROWS_AS(import_text(text), SceneError);
  }
  CHECK(world_triangles(import_text("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0").scene).size() == 1);
  Model const model = import_text("v 0 0 \\\n0\nv 1 0 0\nv 0 \\\r\n 1 0\nf 1 2 \\\n3\nl 1 2\n");
  CHECK(shown(model.diagnostics) == "m.obj:8:0: lines are not drawn beside faces\n");
  CHECK(world_triangles(model.scene)[0] == Corners{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
}

TEST_CASE("OBJ: no file outside the model's folder is read", "[unit][obj]") {
  TemporaryFolder const folder;
  folder.write("secret.mtl", "newmtl a\nKd 1 0 0\n");
  std::filesystem::create_directories(folder / "model");
  for (std::string const& library : {std::string("../secret.mtl"), (folder / "secret.mtl").string()}) {
    folder.write("model/m.obj", "mtllib " + library + "\nusemtl a\n" + triangle);
    Model const model = import_obj(folder / "model/m.obj");
    CHECK_THAT(shown(model.diagnostics), contains_text("m.obj:1:8: cannot use '") && contains_text("no material 'a'"));
    ModelOptions options;
    options.allowed_paths = {folder.path()};
    CHECK(shown(import_obj(folder / "model/m.obj", options).diagnostics) == "");
  }
}

TEST_CASE("OBJ: a file that is refused for its place has a hint", "[unit][obj]") {
  TemporaryFolder const folder;
  std::filesystem::create_directories(folder / "model");
  folder.write("model/n.mtl", "newmtl a\nmap_Kd ../tex.png\nmap_Ke nowhere.png\n");
  folder.write("model/m.obj", "mtllib n.mtl ../o.mtl /o.mtl o.mtl\nusemtl a\n" + triangle);
  auto const found = import_obj(folder / "model/m.obj").diagnostics;
  REQUIRE(found.size() == 5);
  std::string const hint = "--allow-path <folder> permits files outside of the model's folder";
  CHECK(found[0].hint == hint);
  CHECK(found[1].hint == hint);
  CHECK(found[2].hint == "");
  CHECK(found[3].hint == hint);
  CHECK(found[4].hint == "");
}

TEST_CASE("OBJ: normals that are no numbers are the triangle's own, without a warning for each", "[unit][obj]") {
  Model const model = import_text(triangle + "vn nan NaN -nan\nvn 0 0 1\nf 1//1 2//2 3//2\n");
  CHECK(shown(model.diagnostics) == "");
  CHECK(mesh_of(model.scene, "mesh").geometry()->normals.at(3) == Float3{0, 0, 0});
}

TEST_CASE("OBJ: another model is told what reads it", "[unit][obj]") {
  try {
    import_text("Kaydara FBX Binary  \n");
    FAIL();
  } catch (SceneError const& error) {
    REQUIRE(error.diagnostics().size() == 1);
    CHECK(error.diagnostics()[0].message == "this is an FBX model, which lichtraum does not read");
    CHECK_THAT(error.diagnostics()[0].hint, contains_text("assimp export"));
  }
}

TEST_CASE("OBJ: what is another file is told so, once", "[unit][obj]") {
  for (auto const& [text, message] : {
           std::pair<std::string, std::string>{"<!DOCTYPE html>\n<title>404</title>\n", "an HTML document"},
           {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"},
           {std::string("PK\3\4\n\0\n", 7), "a ZIP archive or an office document"},
           {"\x1F\x8B\x08\n", "a gzip archive"},
       }) {
    INFO(message);
    try {
      import_text(text);
      FAIL("it was read");
    } catch (SceneError const& error) {
      REQUIRE(error.diagnostics().size() == 1);
      CHECK(error.diagnostics()[0].code == DiagnosticCode::not_obj);
      CHECK(error.diagnostics()[0].message == "this is " + message + ", not an OBJ model");
      CHECK(!error.diagnostics()[0].hint.empty());
    }
  }
}

TEST_CASE("OBJ: hostile sizes end soon", "[unit][obj]") {
  std::string same = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";  // one position with many texture coordinates
  for (int i = 1; i <= 100000; ++i) same += "vt " + std::to_string(i) + "\nf 1/" + std::to_string(i) + " 2/1 3/1\n";
  CHECK(world_triangles(import_text(same).scene).size() == 100000);
  std::string polygon = triangle + "f";
  for (int i = 0; i < 200000; ++i) polygon += " " + std::to_string(1 + i % 3);
  CHECK(world_triangles(import_text(polygon).scene).size() == 1 + 199998);
  std::string groups = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 70000; ++i) groups += "g " + std::to_string(i) + "\nf 1 2 3\n";
  CHECK_THAT(shown(import_text(groups).diagnostics), contains_text("more than 65536 objects and groups"));
}

TEST_CASE("OBJ: a texture coordinate or normal 0 is none; a vertex 0 is a mistake", "[unit][obj]") {
  std::string const vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0\nvn 0 0 2\n";
  Model const model = import_text(vertices + "f 1/1/0 2/1/0 3/0/1\n");
  CHECK(shown(model.diagnostics) == "m.obj:0:0: 3 corners name a texture coordinate or normal that is not there\n");
  MeshGeometry const& g = *mesh_of(model.scene, "mesh").geometry();
  REQUIRE(g.triangle_count() == 1);
  CHECK(g.texcoords.at(0)[g.indices[0]] == Float2{0.5f, 1});
  CHECK(g.texcoords.at(0)[g.indices[2]] == Float2{0, 0});
  CHECK(g.normals[g.indices[0]] == Float3{0, 0, 0});
  CHECK(g.normals[g.indices[2]] == Float3{0, 0, 1});
  CHECK(world_triangles(import_text(vertices + "f 01/01/01 2/1/1 3/1/1\n").scene).size() == 1);
  CHECK_THROWS_WITH(import_text(vertices + "f 0/1/1 2/1/1 3/1/1\n"), contains_text("found '0/1/1'"));
}
