#include "core/edit_distance.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"

using lichtraum::edit_distance;

namespace {

// The textbook's full table.
std::size_t full_table(std::string const& a, std::string const& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

TEST_CASE("edit distance of known words", "[unit]") {
  CHECK(edit_distance("blue", "blue", 3) == 0);
  CHECK(edit_distance("bleu", "blue", 3) == 1);
  CHECK(edit_distance("defin", "define", 3) == 1);
  CHECK(edit_distance("transfrom", "transform", 3) == 1);
  CHECK(edit_distance("kitten", "sitting", 3) == 3);
  CHECK(edit_distance("kitten", "sitting", 2) == 3);
  CHECK(edit_distance("", "abc", 3) == 3);
  CHECK(edit_distance("a", "b", 0) == 1);
  CHECK(edit_distance(std::string(65, 'a'), std::string(65, 'a'), 3) == 4);
}

TEST_CASE("edit distance agrees with the full table", "[unit]") {
  std::mt19937 random(3);
  auto const word = [&] {
    std::string result;
    for (std::size_t n = random() % 9; n > 0; --n) result += static_cast<char>('a' + random() % 3);
    return result;
  };
  for (int i = 0; i < 20'000; ++i) {
    std::string const a = word();
    std::string const b = word();
    for (std::size_t limit = 0; limit < 5; ++limit) {
      if (edit_distance(a, b, limit) != std::min(full_table(a, b), limit + 1)) FAIL(a + " " + b);
    }
  }
}
