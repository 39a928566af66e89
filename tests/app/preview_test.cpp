#include <cstdio>
#include <regex>

#include "lichtraum.hpp"
#include "pictures.hpp"
#include "support/catch.hpp"
#include "support/pseudo_terminal.hpp"
#include "support/skip.hpp"

namespace {

std::string const kitty_question = "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\";
std::string const attributes_question = "\x1b[c";
std::string const words = "preview --device reference --samples 1 ball.sdf ";

/// Twice as wide as high.
std::string const wide_scene =
    "define material red 1 0 0 0 0 0 0 0 0 1\ndefine shape sphere ball 0 0 -3 0.5 red\n"
    "define light ambient sky 1 1 1\ndefine background 0 0 1\ndefine camera eye 60 200 100\n";

/// The colours of the pixels that half blocks show: height x width x 3.
struct Blocks {
  int width = 0;
  int height = 0;
  std::vector<int> values;
};

Blocks read_blocks(std::string const& text) {
  std::string const block = "\xe2\x96\x80";
  Blocks blocks;
  std::vector<int> upper(3), lower(3), upper_row, lower_row;
  for (std::size_t i = 0; i < text.size(); ++i) {
    int ground = 0, red = 0, green = 0, blue = 0;
    if (std::sscanf(text.c_str() + i, "\x1b[%d;2;%d;%d;%dm", &ground, &red, &green, &blue) == 4) {
      (ground == 38 ? upper : lower) = {red, green, blue};
    } else if (text.compare(i, block.size(), block) == 0) {
      upper_row.insert(upper_row.end(), upper.begin(), upper.end());
      lower_row.insert(lower_row.end(), lower.begin(), lower.end());
    } else if (text[i] == '\n' && !upper_row.empty()) {
      blocks.width = int(upper_row.size() / 3);
      blocks.height += 2;
      blocks.values.insert(blocks.values.end(), upper_row.begin(), upper_row.end());
      blocks.values.insert(blocks.values.end(), lower_row.begin(), lower_row.end());
      upper_row.clear();
      lower_row.clear();
    }
  }
  return blocks;
}

}  // namespace

TEST_CASE("half blocks show the picture's pixels", "[app][preview]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.sdf", wide_scene);
  // A pipe gets blocks, without a question, for 80 x 24 characters; here the size is given.
  auto const result = lichtraum(words + "--size 40x30");
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("\x1b_G") == std::string::npos);
  CHECK(result.out.find(attributes_question) == std::string::npos);
  Blocks const blocks = read_blocks(result.out);
  REQUIRE(blocks.width == 40);
  REQUIRE(blocks.height == 20);
  REQUIRE(lichtraum.render("ball.sdf --size 40x20 -o ball.ppm").exit_code == 0);
  auto const picture = decode(lichtraum.folder.read("ball.ppm"));
  REQUIRE(picture.values.size() == blocks.values.size());
  for (std::size_t i = 0; i < blocks.values.size(); ++i) {
    INFO("x " << i / 3 % 40 << " y " << i / 120 << " channel " << i % 3);
    CHECK(float(blocks.values[i]) == picture.values[i]);
  }
  CHECK(read_blocks(lichtraum(words).out).width == 80);
  // Limited by its rows.
  Blocks const low = read_blocks(lichtraum(words + "--size 40x5").out);
  CHECK(low.width == 20);
  CHECK(low.height == 10);
  lichtraum.folder.write("ball.sdf", "define camera eye 60\nrender eye a.png\n");  // a size of none
  CHECK(read_blocks(lichtraum(words + "--size 40x30").out).width == 40);
}

TEST_CASE("a terminal that shows graphics gets them", "[app][preview]") {
  if (!has_pseudo_terminals()) SKIP_TEST("there are no pseudo-terminals here");
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.sdf", wide_scene);
  PseudoTerminal terminal;
  terminal.columns = 30;
  terminal.rows = 11;
  terminal.cell_width = 8;
  terminal.cell_height = 16;

  terminal.answers = {{attributes_question, "\x1b_Gi=31;OK\x1b\\\x1b[?62;22c"}};
  auto const kitty = run_in_terminal(terminal, lichtraum.process(words));
  REQUIRE(kitty.exit_code == 0);
  CHECK_THAT(kitty.out, contains_text(kitty_question));
  CHECK_THAT(kitty.out, contains_text("\x1b_Ga=T,f=24,s=240,v=120,q=2,m=1;"));
  CHECK(kitty.out.find("\xe2\x96\x80") == std::string::npos);
  // All pixels in base 64: 240 * 120 * 3 / 3 * 4 characters.
  std::size_t characters = 0;
  std::regex const chunk("\x1b_G[^;]*m=[01];([^\x1b]*)\x1b");
  for (std::sregex_iterator it(kitty.out.begin(), kitty.out.end(), chunk), end; it != end; ++it) {
    characters += (*it)[1].length();
  }
  CHECK(characters == 240 * 120 * 4);

  terminal.answers = {{attributes_question, "\x1b[?64;4;22c"}};
  auto const sixel = run_in_terminal(terminal, lichtraum.process(words));
  REQUIRE(sixel.exit_code == 0);
  CHECK_THAT(sixel.out, contains_text("\x1bP0;1q\"1;1;240;120") && contains_text("#5;2;0;0;100"));
  // The first six rows are background: one run of 240 pixels of pure blue.
  CHECK_THAT(sixel.out, contains_text("#5!240~$-"));

  terminal.answers = {{attributes_question, "\x1b[?62;22c"}};
  auto const neither = run_in_terminal(terminal, lichtraum.process(words));
  REQUIRE(neither.exit_code == 0);
  CHECK(read_blocks(neither.out).width == 30);
  CHECK(read_blocks(neither.out).height == 16);  // 15 rows of pixels
  CHECK(neither.seconds < 5);
}

TEST_CASE("a terminal that does not answer shows blocks, soon", "[app][preview]") {
  if (!has_pseudo_terminals()) SKIP_TEST("there are no pseudo-terminals here");
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.sdf", wide_scene);
  for (std::string const answer : {"", "\x1b[?", "nonsense", "\x1b_Gi=31;ENOENT\x1b\\"}) {
    PseudoTerminal terminal;
    terminal.answers = {{attributes_question, answer}};
    auto const result = run_in_terminal(terminal, lichtraum.process(words));
    REQUIRE(result.exit_code == 0);
    CHECK(read_blocks(result.out).width == 80);
    CHECK(result.seconds < 5);
  }
  PseudoTerminal const terminal;
  auto const forced = run_in_terminal(terminal, lichtraum.process(words + "--graphics sixel"));
  CHECK(forced.out.find(attributes_question) == std::string::npos);
  CHECK_THAT(forced.out, contains_text("\x1bP0;1q"));
}

TEST_CASE("of a film, the first picture is shown as the scene is there", "[app][preview]") {
  Lichtraum const lichtraum;
  lichtraum.folder.write("ball.sdf", wide_scene);
  lichtraum.folder.write("film.sdf", wide_scene + "define camera side 60 300 100\nrender eye a.ppm 200 100\n" +
                                         "transform ball translate 0 0 100\nrender side b.ppm 300 100\n");
  auto const preview = [&](std::string const& scene) {
    auto const result = lichtraum("preview --device reference --size 40x30 " + scene);
    REQUIRE(result.exit_code == 0);
    return result.out;
  };
  CHECK(preview("film.sdf") == preview("ball.sdf"));
}

TEST_CASE("what cannot be previewed is said", "[app][preview]") {
  Lichtraum const lichtraum;
  CHECK(lichtraum("preview").exit_code == 64);
  CHECK(lichtraum("preview none.sdf").exit_code == 66);
  lichtraum.folder.write("bad.sdf", "define nonsense\n");
  CHECK(lichtraum("preview bad.sdf").exit_code == 65);
  lichtraum.folder.write("ball.sdf", wide_scene);
  CHECK(lichtraum(words + "--size 0x3").exit_code == 64);
  CHECK(lichtraum(words + "--size 99999x3").exit_code == 64);
  CHECK(lichtraum(words + "--graphics ascii").exit_code == 64);
  CHECK(lichtraum(words + "--camera nobody").exit_code == 64);
}
