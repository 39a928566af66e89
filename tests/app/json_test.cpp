#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "lichtraum.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"

using Json = nlohmann::json;

namespace {

void collect_keys(Json const& json, std::set<std::string>& keys) {
  if (!json.is_structured()) return;
  for (auto const& item : json.items()) {
    if (json.is_object()) keys.insert(item.key());
    collect_keys(item.value(), keys);
  }
}

/// The chapter of docs/JSON.md that has this title, with what goes for all of them.
std::string documented(std::string const& title) {
  std::string const text = read_project_file("docs/JSON.md");
  auto const chapter = [&](std::string const& heading) {
    std::size_t const begin = text.find("\n## " + heading);
    REQUIRE(begin != std::string::npos);
    return text.substr(begin, text.find("\n## ", begin + 1) - begin);
  };
  std::string const of_check = title == "`lichtraum render" ? chapter("`lichtraum check") : "";
  return chapter("Diagnostics") + of_check + chapter(title);
}

std::string const faulty = std::string(ball_scene) + "define shape sphere t 0 0 -3 1 rad\n";

}  // namespace

TEST_CASE("docs/JSON.md has every key that is printed", "[app][json]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", std::string(ball_scene) +
                                      "camera lens 40 aperture=0.1 focus=3\n"
                                      "define light environment all 1 1 1\n"
                                      "define light diffuse lamp 1 1 1 1 1 1 radius=0.5\n");
  lichtraum.folder.write("bad.sdf", faulty);
  struct Command {
    std::string words;
    std::string title;
    std::size_t least;
  };
  for (Command const& c : std::vector<Command>{
           {"render -q --json --device reference --integrator whitted a.sdf bad.sdf", "`lichtraum render", 45},
           {"check -q --json --device reference a.sdf bad.sdf", "`lichtraum check", 25},
           {"info --json a.sdf", "`lichtraum info", 42},
           {"devices --json", "`lichtraum devices", 11},
       }) {
    INFO(c.words);
    std::set<std::string> keys;
    collect_keys(Json::parse(lichtraum(c.words).out), keys);
    CHECK(keys.size() >= c.least);
    std::string const text = documented(c.title);
    for (std::string const& key : keys) CHECK_THAT(text, contains_text("`" + key + "`"));
  }
}

TEST_CASE("only pictures of a turntable tell of degrees", "[app][json]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  auto const degrees = [&](std::string const& words) {
    return Json::parse(lichtraum.render("a.sdf -q --json " + words).out)["scenes"][0]["pictures"][0]["turn_degrees"];
  };
  CHECK(degrees("").is_null());
  CHECK(degrees("--turntable 2") == 0);
}

TEST_CASE("check and render give each diagnostic as an object, the same ones", "[app][json]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("bad.sdf", faulty + "define light l 1 2\n");
  lichtraum.folder.write("away.sdf", "define camera eye 40\nrender eye a.gif 64 48\n");
  Json const check =
      Json::parse(lichtraum("check -q --json --device reference bad.sdf away.sdf missing.sdf").out)["scenes"];
  Json const render =
      Json::parse(lichtraum("render -q --json --device reference bad.sdf away.sdf missing.sdf").out)["scenes"];
  REQUIRE(check.size() == 3);
  REQUIRE(render.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(check[i]["file"] == render[i]["file"]);
    CHECK(check[i]["exit_status"] == render[i]["exit_status"]);
    CHECK(check[i]["diagnostics"] == render[i]["diagnostics"]);
  }
  CHECK(check[0]["exit_status"] == 65);
  REQUIRE(check[0]["diagnostics"].size() == 2);
  CHECK(check[0]["diagnostics"][0] == Json({{"severity", "error"},
                                            {"code", "E0412"},
                                            {"message", "material 'rad' is not defined"},
                                            {"file", "bad.sdf"},
                                            {"line", 7},
                                            {"column", 32},
                                            {"length", 3},
                                            {"notes", {"did you mean 'red'?"}}}));
  CHECK(check[0]["pictures"].empty());
  CHECK(check[1]["exit_status"] == 0);
  REQUIRE(check[1]["diagnostics"].size() == 2);
  CHECK(check[1]["diagnostics"][0]["line"] == 2);
  CHECK(check[1]["diagnostics"][1]["line"] == 2);
  REQUIRE(check[1]["pictures"].size() == 1);
  CHECK(check[1]["pictures"][0]["output"] == "a.gif.png");
  CHECK(check[1]["pictures"][0]["width"] == 64);
  CHECK(check[1]["pictures"][0]["line"] == 2);
  CHECK(check[2]["exit_status"] == 66);
  CHECK(check[2]["diagnostics"][0]["file"].is_null());
  CHECK(check[2]["diagnostics"][0]["code"] == "E0206");
  CHECK(lichtraum("check -q --json --device reference away.sdf missing.sdf").exit_code == 66);
  CHECK(lichtraum("check --json --nonsense").out.empty());
}
