#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lichtraum/error.hpp"
#include "lichtraum/film.hpp"
#include "lichtraum/words.hpp"

/// Kinds of values in JSON. Each has `write` (a value to JSON) and `read`, which is its opposite and throws
/// Error{usage} for JSON that is none.

namespace lichtraum::json_values {

using Json = nlohmann::ordered_json;

/// Text that nobody trusts, of a document of some kind: "job". Throws Error{usage}, for what is not JSON with line and
/// column, for what names a key of an object twice, is nested deeper or has larger objects than any of ours, or has
/// more values (and keys, and ends of objects and arrays) than one of this kind.
Json parse(std::string_view text, std::string_view kind, std::size_t most_values);

/// A place in JSON text (RFC 6901).
class Pointer {
 public:
  Pointer operator/(std::string_view key) const {
    Pointer result = *this;
    result.text_ += '/';
    for (char const c : key) result.text_ += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return result;
  }
  Pointer operator/(std::size_t index) const { return *this / std::string_view(std::to_string(index)); }

  [[noreturn]] void fail(std::string const& message) const {
    throw Error(ErrorKind::usage, text_.empty() ? message : text_ + ": " + message);
  }
  void expect(bool holds, std::string_view what) const {
    if (!holds) fail(fmt::format("expected {}", what));
  }

 private:
  std::string text_;
};

/// 0 <= low <= high.
template <class Integer>
struct Whole {
  Integer low;
  Integer high;

  static Json write(Integer value) { return value; }
  Integer read(Json const& json, Pointer const& at) const {
    bool const is_good = json.is_number_unsigned() && json.get<std::uint64_t>() >= std::uint64_t(low) &&
                         json.get<std::uint64_t>() <= std::uint64_t(high);
    if (!is_good) at.fail(fmt::format("expected a whole number from {} to {}", low, high));
    return json.get<Integer>();
  }
};
template <class Integer>
Whole(Integer, Integer) -> Whole<Integer>;

/// One of a few numbers.
struct Choice {
  std::vector<int> numbers;

  static Json write(int value) { return value; }
  int read(Json const& json, Pointer const& at) const {
    for (int const number : numbers) {
      if (json.is_number_integer() && json == number) return number;
    }
    at.fail(fmt::format("expected {}", fmt::join(numbers, " or ")));
  }
};

/// A finite number.
struct Number {
  double low;
  double high;
  std::string expected;

  static Json write(double value) {
    if (!std::isfinite(value)) throw Error(ErrorKind::usage, fmt::format("JSON cannot hold the number {}", value));
    return value;
  }
  double read(Json const& json, Pointer const& at) const {
    bool const is_good = json.is_number() && json.get<double>() >= low && json.get<double>() <= high;
    at.expect(is_good, expected);
    return json.get<double>();
  }
};

struct Flag {
  static Json write(bool value) { return value; }
  static bool read(Json const& json, Pointer const& at) {
    at.expect(json.is_boolean(), "true or false");
    return json.get<bool>();
  }
};

struct Text {
  static Json write(std::string const& value) { return value; }
  static std::string read(Json const& json, Pointer const& at) {
    at.expect(json.is_string(), "a text");
    return json.get<std::string>();
  }
};

/// A text that is not empty.
struct Name {
  static Json write(std::string const& value) { return value; }
  static std::string read(Json const& json, Pointer const& at) {
    std::string name = Text::read(json, at);
    at.expect(!name.empty(), "a name");
    return name;
  }
};

struct Path {
  static Json write(std::filesystem::path const& value) { return value.string(); }
  static std::filesystem::path read(Json const& json, Pointer const& at) { return Name::read(json, at); }
};

template <class Value>
struct OneOf {
  std::vector<Word<Value>> words;

  Json write(Value value) const {
    for (Word<Value> const& entry : words) {
      if (entry.value == value) return entry.word;
    }
    return {};
  }
  Value read(Json const& json, Pointer const& at) const {
    std::span<Word<Value> const> const known(words);
    Value const* const value = json.is_string() ? find_value(known, json.get_ref<std::string const&>()) : nullptr;
    if (!value) at.fail("expected " + list_of(known));
    return *value;
  }
};

template <class Value, std::size_t count>
OneOf<Value> one_of(std::array<Word<Value>, count> const& words) {
  return {{words.begin(), words.end()}};
}

template <class Element>
struct ListOf {
  Element element;

  template <class Value>
  Json write(std::vector<Value> const& values) const {
    Json array = Json::array();
    for (Value const& value : values) array.push_back(element.write(value));
    return array;
  }
  auto read(Json const& json, Pointer const& at) const {
    at.expect(json.is_array(), "an array");
    std::vector<std::decay_t<decltype(element.read(json, at))>> values;
    for (std::size_t i = 0; i < json.size(); ++i) values.push_back(element.read(json[i], at / i));
    return values;
  }
};
template <class Element>
ListOf(Element) -> ListOf<Element>;

struct PlaneNames {
  static Json write(PlaneSet const& planes) { return ListOf{OneOf<FilmPlane>{plane_words()}}.write(planes.list()); }
  static PlaneSet read(Json const& json, Pointer const& at) {
    PlaneSet planes;
    for (FilmPlane const plane : ListOf{OneOf<FilmPlane>{plane_words()}}.read(json, at)) planes.add(plane);
    at.expect(!planes.is_empty(), "at least one plane");
    return planes;
  }
};

/// A struct. `fields` is a function that calls one for each member, with its key, the member, and its kind. A member
/// that is left open has no key; one whose key is left out is as its struct has it.
template <class Fields>
struct Object {
  Fields fields;

  template <class Struct>
  Json write(Struct const& value) const {
    Json json = Json::object();
    fields(value, [&]<class Member, class Kind>(char const* key, Member const& member, Kind const& kind) {
      if constexpr (requires { member.has_value(); }) {
        if (member) json[key] = kind.write(*member);
      } else {
        json[key] = kind.write(member);
      }
    });
    return json;
  }

  template <class Struct>
  Struct read(Json const& json, Pointer const& at) const {
    at.expect(json.is_object(), "an object");
    Struct value;
    std::vector<std::string_view> known;
    fields(value, [&]<class Member, class Kind>(char const* key, Member& member, Kind const& kind) {
      known.push_back(key);
      auto const found = json.find(key);
      if (found == json.end()) return;
      if constexpr (requires { kind.template read<typename Member::value_type>(*found, at), member.has_value(); }) {
        member = kind.template read<typename Member::value_type>(*found, at / key);
      } else if constexpr (requires { kind.template read<Member>(*found, at); }) {
        member = kind.template read<Member>(*found, at / key);
      } else {
        member = kind.read(*found, at / key);
      }
    });
    for (auto const& [key, ignored] : json.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      (at / key).fail(fmt::format("unknown key; there are: {}", fmt::join(known, ", ")));
    }
    return value;
  }
};
template <class Fields>
Object(Fields) -> Object<Fields>;

}  // namespace lichtraum::json_values
