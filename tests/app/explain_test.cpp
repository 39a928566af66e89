#include <nlohmann/json.hpp>

#include "lichtraum.hpp"
#include "lichtraum/explanation.hpp"
#include "support/catch.hpp"

using namespace lichtraum;
using Json = nlohmann::json;

TEST_CASE("explain says what a code means, in any case and with any letter", "[app][explain]") {
  Lichtraum const lichtraum;
  auto const one = lichtraum("explain E0412");
  CHECK(one.exit_code == 0);
  CHECK(one.err.empty());
  CHECK(one.out.substr(0, 38) == "E0412: a material that is not defined\n");
  CHECK_THAT(one.out, contains_text("\nFor example:\n\n    define material white") &&
                          contains_text("ball  0 0 -5  1  whit\n\nInstead:\n\n    define material white"));
  for (char const* const same : {"e0412", "0412", "W0412", "w0412", "e412", "412"}) {
    CHECK(lichtraum(std::string("explain ") + same).out == one.out);
  }
  std::string const two = lichtraum("explain E0301 E0412").out;
  CHECK(two.substr(0, 7) == "E0301: ");
  CHECK_THAT(two, contains_text("\n\n" + one.out));
  // An example that needs an option says so; what cannot be shown has none.
  CHECK_THAT(lichtraum("explain E0315").out, contains_text("\nWith lichtraum check --strict scene.sdf:\n"));
  CHECK(lichtraum("explain W0205").out.find("Instead") == std::string::npos);
}

TEST_CASE("explain without a code lists all in groups", "[app][explain]") {
  Lichtraum const lichtraum;
  auto const all = lichtraum("explain");
  CHECK(all.exit_code == 0);
  CHECK_THAT(all.out,
             contains_text("\nNames\n  E0401  ") && contains_text("\n  E0412  a material that is not defined\n"));
  CHECK_THAT(all.out, !contains_text("\n    "));
}

TEST_CASE("a code that there is not is one error with near ones", "[app][explain]") {
  Lichtraum const lichtraum;
  auto const refused = [&](std::string const& words, std::string const& error) {
    auto const result = lichtraum("explain " + words);
    INFO(words);
    CHECK(result.exit_code == 64);
    CHECK(result.out.empty());
    CHECK(result.err == "lichtraum: error: explain: " + error + "\n");
  };
  refused("E0410", "there is no code 'E0410': did you mean E0411, E0412 or E0413?");
  refused("E0412 material", "there is no code 'material': lichtraum explain lists all codes");
  refused("E", "there is no code 'E': lichtraum explain lists all codes");
}

TEST_CASE("the code at the end of an error's line is one that explain knows", "[app][explain]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", "define shape sphere ball  0 0 -5  1  whit\n");
  std::string const said = lichtraum("check a.sdf").err;
  CHECK_THAT(said, contains_text("a.sdf:1:38: error: material 'whit' is not defined [E0412]\n"));
}

TEST_CASE("each example of what a picture shows has that finding and no other, and is right instead",
          "[app][explain]") {
  int examples = 0;
  for (ExplanationGroup const& group : explanation_groups()) {
    for (Explanation const& explanation : group.explanations) {
      std::string_view const words = explanation.command;
      if (explanation.example.empty() || words.find("lichtraum render ") != 0) continue;
      std::string const code(code_text(explanation.code));
      INFO(code);
      Lichtraum const lichtraum;
      auto const codes = [&](std::string_view text) {
        lichtraum.folder.write("scene.sdf", text);
        std::string const command(words.substr(words.find(' ') + 1));
        auto const report = Json::parse(lichtraum(command + " -q --json").out);
        std::vector<std::string> found;
        for (Json const& diagnostic : report["scenes"].at(0)["diagnostics"]) {
          if (diagnostic["severity"] != "note") found.push_back(diagnostic["code"]);
        }
        return found;
      };
      CHECK(codes(explanation.example) == std::vector<std::string>{code});
      CHECK(codes(explanation.instead).empty());
      ++examples;
    }
  }
  CHECK(examples == 9);
}

TEST_CASE("a failure that has no place in a scene has a code, a refused command line none", "[app][explain]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("a.sdf", ball_scene);
  lichtraum.folder.write("blind.sdf", "define material red  1 0 0  1 0 0  0 0 0  10\n");
  struct Failure {
    std::string words;
    std::string end;
  };
  for (Failure const& failure : {Failure{"render missing.sdf", " [E0206]\n"},
                                 {"check missing.sdf", " [E0206]\n"},
                                 {"render a.sdf --device reference -o nowhere/a.png", " [E0207]\n"},
                                 {"render a.sdf --device 99", "reference: [E0102]\n"},
                                 {"render blind.sdf --device reference", " [E0820]\n"},
                                 {"render a.sdf --nonsense", "(lichtraum render --help shows how)\n"},
                                 {"render", "(lichtraum render --help shows how)\n"}}) {
    INFO(failure.words);
    std::string const err = lichtraum(failure.words).err;
    std::string const line = err.substr(0, err.find('\n') + 1);
    INFO(line);
    REQUIRE(line.size() > failure.end.size());
    CHECK(line.substr(line.size() - failure.end.size()) == failure.end);
  }
}
