#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/project_files.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct Case {
  std::string text;
  std::string expected;
};

// esdf_diagnostics.txt: a text, "-->", what is shown for it, "---", the next one.
std::vector<Case> read_cases() {
  std::string const file = read_project_file("tests/unit/esdf_diagnostics.txt");
  std::vector<Case> cases;
  for (std::size_t at = 0; at < file.size();) {
    std::size_t const arrow = file.find("-->\n", at);
    REQUIRE(arrow != std::string::npos);
    std::size_t const end = file.find("---\n", arrow);
    cases.push_back({file.substr(at, arrow - at), file.substr(arrow + 4, end - arrow - 4)});
    at = end == std::string::npos ? file.size() : end + 4;
  }
  return cases;
}

}  // namespace

TEST_CASE("every diagnostic to the column, word and hint", "[unit][esdf]") {
  auto const cases = read_cases();
  REQUIRE(cases.size() > 90);
  for (Case const& c : cases) {
    INFO(c.text);
    CHECK(shown(c.text) == c.expected);
  }
}

TEST_CASE("no problem hides another one", "[unit][esdf]") {
  std::string const text =
      "nonsense\n" + red + "define shape sphere s 0 0 0 red\ntransform s scale 0\n" + eye + "render eye a.png 640\n";
  auto const found = findings(text);
  REQUIRE(found.size() == 4);
  CHECK(found[0].location.line == 1);
  CHECK(found[1].location.line == 3);
  CHECK(found[2].location.line == 4);
  CHECK(found[3].location.line == 6);
}

TEST_CASE("what refers to a faulty definition is not a second error", "[unit][esdf]") {
  CHECK(findings("define material red 1\ndefine shape sphere s 0 0 0 1 red\n").size() == 1);
  CHECK(findings(red + "define shape sphere s 0 red\ndefine shape composite c s\ntransform s scale 2\n").size() == 1);
  CHECK(findings("define shape teapot t 1 2 3\ndefine shape composite c t\n").size() == 1);
  CHECK(findings("define camera eye {{fov}}\ntransform eye scale 2\nrender eye a.png 1 1\n").size() == 1);
  CHECK(findings("define camera eye \x01 45\ntransform eye scale 2\nrender eye a.png 1 1\n").size() == 1);
  CHECK(findings("define camera eye 200\ntransform eye scale 2\nrender eye a.png 1 1\n").size() == 1);
}

TEST_CASE("a misspelt keyword hides no name", "[unit][esdf]") {
  for (std::string const shape : {"define shap sphere", "define Shape sphere", "define sphere", "defin shape sphere",
                                  "Define shape sphere", "shape sphere", "sphere", "Define Shape Sphere"}) {
    INFO(shape);
    std::string const text =
        red + shape + " a 0 0 0 1 red\ndefine shape composite c a\ntransform a scale 2\ndefine shape composite d b\n";
    auto const found = findings(text);
    REQUIRE(found.size() == 2);
    CHECK(found[0].location.line == 2);
    CHECK(found[1].message == "shape 'b' is not defined");
  }
  CHECK(findings("define materiel m 1 0 0 1 0 0 1 0 0 1\ndefine shape sphere s 0 0 0 1 m\n").size() == 1);
  CHECK(findings("define camra eye 45\ntransform eye scale 2\nrender eye a.png 1 1\n").size() == 1);
  CHECK(findings("Camera eye 45\nrender eye a.png 1 1\n").size() == 1);
  CHECK(findings("Define Material m 1 0 0 1 0 0 1 0 0 1\ndefine shape sphere s 0 0 0 1 m\n").size() == 1);
  // What the word was meant to be is not known, so neither is what the line defines.
  CHECK(findings("define teapot sphere a 0 0 0 1\ntransform a scale 2\n").size() == 2);
  // The name is one of shapes, and of nothing else.
  CHECK(findings("define shap sphere a 0 0 0 1 red\nrender a x.png 1 1\n").size() == 2);
}

TEST_CASE("an undefined name is one finding, however often it is used", "[unit][esdf]") {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "define shape sphere s" + std::to_string(i) + " 0 0 0 1 m\n";
  auto const found = findings(text + "define material m 1 0 0 1 0 0 1 0 0 10\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].location.line == 1);
  CHECK(found[0].message == "material 'm' is not defined (and in 4999 more lines)");
  CHECK(found[0].hint == "it is defined later, in line 5001: statements run in order");
  // Twice in one line is one line; a material is no shape.
  auto const both = findings("define shape composite c a a\ntransform a scale 2\ndefine shape sphere s 0 0 0 1 a\n");
  REQUIRE(both.size() == 2);
  CHECK(both[0].message == "shape 'a' is not defined (and in 1 more line)");
  CHECK(both[1].message == "material 'a' is not defined");
}

TEST_CASE("many problems are cut with a warning", "[unit][esdf]") {
  std::string text;
  for (int i = 0; i < 250; ++i) text += "nonsense\n";
  auto const found = findings(text);
  REQUIRE(found.size() == 101);
  CHECK(found[99].location.line == 100);
  CHECK(found[100].severity == Severity::warning);  // is shown: notes are not
  CHECK(found[100].message == "too many errors: from line 101 on the file was not checked");

  EsdfOptions options;
  options.max_diagnostics = 3;
  CHECK(findings(text, options).size() == 4);
  options.keep_going = true;
  auto const kept = findings(text, options);
  REQUIRE(kept.size() == 4);
  CHECK(kept[3].message == "too many to show: 247 more errors");
  options.max_diagnostics = 0;
  CHECK(findings(text, options).size() == 2);
}

TEST_CASE("warnings do not crowd out errors", "[unit][esdf]") {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "define material m" + std::to_string(i) + " 1 0 0 1 0 0 1 0 0 10 1\n";
  text += "nonsense\n";
  auto const found = findings(text);
  REQUIRE(found.size() == 101);
  CHECK(count_errors(found) == 1);
  CHECK(found[99].message == "unknown statement 'nonsense'");
  CHECK(found[100].message == "too many to show: 51 more warnings");
}

TEST_CASE("foreign files are recognised", "[unit][esdf]") {
  struct Foreign {
    std::string text;
    std::string message;
    std::string hint = "";
  };
  for (Foreign const& foreign : {Foreign{"{\\rtf1\\ansi\n\\f0 # materials\\\n", "an RTF document"},
                                 {"<?xml version=\"1.0\"?>\n", "an XML document"},
                                 {"\xEF\xBB\xBF<?xml version=\"1.0\"?>\n", "an XML document"},
                                 {"\n  <!DOCTYPE html>\n", "an HTML document"},
                                 {"<!DOCTYPE svg>\n", "an HTML or XML document"},
                                 {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"},
                                 {std::string("\xFF\xFE#\0", 4), "UTF-16 text"},
                                 {"\x89PNG\r\n", "a PNG picture"},
                                 {"P6\n4 4\n255\n", "a PPM picture"},
                                 {"%PDF-1.4", "a PDF document"},
                                 {"{\"asset\": {}}", "a JSON document (a glTF model?)", "the extension .gltf"},
                                 {"# a box\n\nmtllib box.mtl\no box\nv 0 0 0\n", "a model (.obj)", "extension .obj"},
                                 {"ply\nformat ascii 1.0\n", "a model (.ply)", "--format-in ply"},
                                 {"solid box\n facet normal 0 0 1\n", "a model (.stl)", "extension .stl"},
                                 {"glTF\x02", "a binary glTF model", "the extension .glb"},
                                 {std::string("\x7F"
                                              "ELF\0\0",
                                              6),
                                  "a binary file"},
                                 {"# a\n" + std::string(1, '\0') + "\n", "a binary file"}}) {
    for (bool const keep_going : {false, true}) {
      EsdfOptions options;
      options.keep_going = keep_going;
      auto const found = findings(foreign.text, options);
      REQUIRE(found.size() == 1);
      CHECK(found[0].severity == Severity::error);
      CHECK(found[0].location.line == 1);
      CHECK(found[0].message == "this is " + foreign.message + ", not an eSDF scene");
      CHECK(found[0].code == DiagnosticCode::not_a_scene);
      CHECK_FALSE(found[0].hint.empty());
      CHECK_THAT(found[0].hint, contains_text(foreign.hint));
    }
  }
}

TEST_CASE("models in formats that are not read are recognised, by their bytes or names", "[unit][esdf]") {
  struct Unread {
    std::string name;
    std::string text;
    std::string what;
    std::string converter;
  };
  for (Unread const& unread :
       {Unread{"a.fbx", "v 0 0 0\n", "an FBX model", "assimp export"},
        {"a.sdf", std::string("Kaydara FBX Binary  \0\x1A", 22), "an FBX model", "assimp export"},
        {"a.txt", "; FBX 7.3.0 project file\n", "an FBX model", "assimp export"},
        {"a.USDZ", "PK\x03\x04", "a USD scene", "usd2gltf"},
        {"a.usd", "", "a USD scene", "usd2gltf"},
        {"a.usdc", std::string(1, '\0'), "a USD scene", "usd2gltf"},
        {"<stdin>", "#usda 1.0\n(\n)\n", "a USD scene", "usd2gltf"},
        {"a.sdf", "PXR-USDC", "a USD scene", "usd2gltf"},
        {"a.3mf", "PK\x03\x04", "a 3MF model", "assimp export"},
        {"a.txt", "OFF\n4 4 0\n", "an OFF model", "assimp export"},
        {"a.txt", "ISO-10303-21;\nHEADER;\n", "a STEP model", "gmsh"},
        {"a.txt", "# vtk DataFile Version 3.0\n", "a VTK data set", "python3"},
        {"a.dae", "<?xml version=\"1.0\"?>", "a COLLADA model", "assimp export"},
        {"a.xml", "<?xml version=\"1.0\"?>\r\n<COLLADA xmlns=\"\">", "a COLLADA model", "assimp export"},
        {"a.blend", "\x28\xB5\x2F\xFD", "a Blender file", "blender -b"},
        {"a.sdf", "BLENDER-v300", "a Blender file", "blender -b"}}) {
    INFO(unread.name << ": " << unread.text);
    try {
      EsdfScript::from_text(unread.text, unread.name);
      FAIL("it was read");
    } catch (SceneError const& error) {
      REQUIRE(error.diagnostics().size() == 1);
      CHECK(error.diagnostics()[0].message == "this is " + unread.what + ", which lichtraum does not read");
      CHECK(error.diagnostics()[0].code == DiagnosticCode::unread_format);
      CHECK_THAT(error.diagnostics()[0].hint, contains_text(" of it: " + unread.converter));
    }
  }
  CHECK(shown("#usd 1.0\n# BLENDER\n").empty());
  CHECK_THROWS_WITH(import_model("a.DAE"),
                    "'a.DAE' is a COLLADA model, which lichtraum does not read: make a .glb of it: "
                    "assimp export in.dae out.glb -fglb2");
  CHECK_THAT(shown("<?xml version=\"1.0\"?>\n<svg>"), contains_text("an XML document"));
  CHECK_THAT(shown("<?xml version=\"1.0\""), contains_text("an XML document"));
}

TEST_CASE("control characters and bytes that are not UTF-8", "[unit][esdf]") {
  CHECK_THAT(shown("define camera e\x1Bye 45\n"),
             contains_text("s.sdf:1:16: error: control character U+001B [E0313]\n"));
  std::string const late_nul = std::string(5000, '#') + "\ncamera a" + std::string(1, '\0') + " 45\n";
  CHECK_THAT(shown(late_nul), contains_text("s.sdf:2:9: error: control character U+0000 [E0313]\n"));
  CHECK(shown("# caf\xE9 and \x01\n").empty());
  std::string const latin = "camera k\xFCgel 45\ncamera b\xE4r 45\n";
  auto const found = findings(latin);
  REQUIRE(found.size() == 1);  // said once
  CHECK(found[0].severity == Severity::warning);
  CHECK(found[0].location.column == 8);
  EsdfOptions strict;
  strict.strict = true;
  CHECK(count_errors(findings(latin, strict)) == 2);
  CHECK(findings("camera kügel 45\n").empty());
}

TEST_CASE("characters that look like blanks or nothing", "[unit][esdf]") {
  auto const hint_of = [](std::string const& text) {
    auto const found = findings(text);
    REQUIRE(found.size() == 1);
    CHECK(found[0].code == DiagnosticCode::control_character);
    return found[0].message + ": " + found[0].hint;
  };
  CHECK(hint_of("camera eye\u00A045\ntransform eye scale 2\n") ==
        "no-break space U+00A0: write an ordinary space instead");
  CHECK(hint_of("camera eye\u202F45\n") == "narrow no-break space U+202F: write an ordinary space instead");
  CHECK(hint_of(eye + "\uFEFFcamera other 45\ntransform other scale 2\n") ==
        "byte order mark U+FEFF: delete it: it cannot be seen");
  CHECK(hint_of("camera eye 4\u200B5\ntransform eye scale 2\n") ==
        "zero-width space U+200B: delete it: it cannot be seen");
  CHECK(hint_of("cam\u00ADera eye 45\n") == "soft hyphen U+00AD: delete it: it cannot be seen");
  CHECK_THAT(shown("camera eye\u00A045\n"), contains_text("s.sdf:1:11: error: no-break space"));
  CHECK(findings("# a\u00A0comment\n\uFEFF# another\n").size() == 1);
  // Joiners belong to some scripts, and to names made of signs.
  CHECK(findings("camera \u0646\u200C\u0645 45\n").empty());
}

TEST_CASE("long tokens and lines are cut in messages", "[unit][esdf]") {
  auto const found = findings(std::string(1'000'000, 'x') + "\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].message.size() < 100);
  CHECK(found[0].source_line.size() < 10'000);
  CHECK(format_diagnostic(found[0]).size() < 2'000);
  auto const comma = findings("define camera eye 4," + std::string(1'000'000, '5') + "\n");
  REQUIRE(comma.size() == 1);
  CHECK(comma[0].message.size() + comma[0].hint.size() < 200);
  auto const far = findings("define shape composite c" + std::string(1'000'000, ' ') + "nobody\n");
  REQUIRE(far.size() == 1);
  CHECK(far[0].location.column == 1'000'025);
  CHECK(far[0].source_line.empty());
}
