#include "io/esdf/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <vector>

#include "io/esdf/interpreter.hpp"

namespace lichtraum::esdf {
namespace {

bool read_key(Interpreter& interpreter, std::string_view what, Token argument, std::span<Key const> keys,
              std::string const& usage, std::string_view other, std::unordered_set<std::string_view>& seen) {
  if (!has_key(argument)) {
    interpreter.error(Code::expected_key, argument,
                      fmt::format("{}: expected key=value, found {}", what, in_quotes(argument)), usage);
    return false;
  }
  std::size_t const equals = argument.find('=');
  Token const word = argument.substr(0, equals);
  Token const value = argument.substr(equals + 1);
  auto const known = std::find_if(keys.begin(), keys.end(), [&](Key const& key) { return key.word == word; });
  if (known == keys.end()) {
    std::vector<std::string_view> words;
    for (Key const& key : keys) words.push_back(key.word);
    std::string const hint = interpreter.suggest(word, words);
    interpreter.error(Code::unknown_key, word.empty() ? argument : word,
                      fmt::format("{}: unknown key {}", what, in_quotes(word)),
                      hint.empty() ? fmt::format("{} takes {}", with_article(what), list_of(keys, other)) : hint);
    return false;
  }
  if (!seen.insert(word).second) {
    interpreter.error(Code::given_twice, argument, fmt::format("{}: {} is given twice", what, word));
    return false;
  }
  if (value.empty()) {
    interpreter.error(Code::key_without_value, argument, fmt::format("{}: {}= has no value", what, word),
                      "write it without spaces around '='");
    return false;
  }
  if (known->is_dialect && !interpreter.dialect(argument, fmt::format("{}=", word))) return false;
  return known->read(value);
}

}  // namespace

std::string list_of(std::span<Key const> keys, std::string_view other) {
  std::vector<std::string> items;
  for (Key const& key : keys) items.push_back(fmt::format("{}=", key.word));
  if (!other.empty()) items.emplace_back(other);
  return listed(items, "and");
}

std::size_t first_key(Statement const& statement, std::size_t names) {
  auto const& arguments = statement.arguments;
  auto const begin = arguments.begin() + std::ptrdiff_t(std::min(names, arguments.size()));
  return std::size_t(std::find_if(begin, arguments.end(), has_key) - arguments.begin());
}

bool read_keys(Interpreter& interpreter, Statement const& statement, std::size_t first, std::span<Key const> keys,
               std::string const& usage, std::string_view other) {
  std::unordered_set<std::string_view> seen;
  bool good = true;
  for (Token const argument : statement.arguments.subspan(first)) {
    good &= read_key(interpreter, statement.what, argument, keys, usage, other, seen);
  }
  return good;
}

}  // namespace lichtraum::esdf
