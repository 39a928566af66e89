#include "job/json_values.hpp"

#include <set>

namespace lichtraum::json_values {
namespace {

constexpr std::size_t most_levels = 4;
constexpr std::size_t most_keys = 200;  // each is looked for among those before it

std::string place(std::string_view text, std::size_t offset) {
  std::string_view const before = text.substr(0, std::min(offset, text.size()));
  std::size_t const line_start = before.rfind('\n') + 1;  // 0 in the first line
  return fmt::format("line {}, column {}", std::count(before.begin(), before.end(), '\n') + 1,
                     before.size() - line_start + 1);
}

/// Refuses while it is read what would grow without bounds, or hide a value behind another. Not a callback of
/// Json::parse(), which looks through all elements of an array after each of them.
class Guard : public Json::json_sax_t {
 public:
  Guard(std::string_view kind, std::size_t most_values) : kind_(kind), most_values_(most_values) {}

  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(Json::number_integer_t) override { return count(); }
  bool number_unsigned(Json::number_unsigned_t) override { return count(); }
  bool number_float(Json::number_float_t, std::string const&) override { return count(); }
  bool string(std::string&) override { return count(); }
  bool binary(Json::binary_t&) override { return count(); }
  bool start_object(std::size_t) override { return open(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    auto& keys = keys_.back();
    if (!keys.insert(name).second) {
      fail(fmt::format("the key {} is there twice", Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)));
    }
    if (keys.size() > most_keys) fail(fmt::format("an object of more than {} keys", most_keys));
    return count();
  }

  bool parse_error(std::size_t, std::string const&, nlohmann::detail::exception const&) override { return false; }

 private:
  bool count() {
    if (++count_ > most_values_) fail(fmt::format("more than {} values", most_values_));
    return true;
  }

  bool open() {
    if (keys_.size() == most_levels) fail(fmt::format("nested deeper than {} levels", most_levels));
    keys_.emplace_back();
    return count();
  }

  bool close() {
    keys_.pop_back();
    return count();
  }

  [[noreturn]] void fail(std::string const& what) const {
    throw Error(ErrorKind::usage, fmt::format("not a {}: {}", kind_, what));
  }

  std::string_view kind_;
  std::size_t most_values_;
  std::size_t count_ = 0;
  std::vector<std::set<std::string>> keys_;  // of each object and array that is open; an array has none
};

}  // namespace

Json parse(std::string_view text, std::string_view kind, std::size_t most_values) {
  Guard guard(kind, most_values);
  Json::sax_parse(text, &guard);  // stops at what is not JSON, which is reported below
  try {
    return Json::parse(text);
  } catch (Json::parse_error const& error) {
    throw Error(ErrorKind::usage, fmt::format("{}: not JSON", place(text, error.byte > 0 ? error.byte - 1 : 0)));
  } catch (Json::exception const&) {
    throw Error(ErrorKind::usage, "not JSON: a number is too large");
  }
}

}  // namespace lichtraum::json_values
