#include "job/json_values.hpp"

#include <set>

namespace lichtraum::json_values {
namespace {

constexpr int most_levels = 4;

std::string place(std::string_view text, std::size_t offset) {
  std::string_view const before = text.substr(0, std::min(offset, text.size()));
  std::size_t const line_start = before.rfind('\n') + 1;  // 0 in the first line
  return fmt::format("line {}, column {}", std::count(before.begin(), before.end(), '\n') + 1,
                     before.size() - line_start + 1);
}

/// Refuses while it is read what would grow without bounds, or hide a value behind another.
class Guard {
 public:
  Guard(std::string_view kind, std::size_t most_values) : kind_(kind), most_values_(most_values) {}

  bool operator()(int depth, Json::parse_event_t event, Json const& parsed) {
    using Event = Json::parse_event_t;
    if (++count_ > most_values_) fail(fmt::format("more than {} values", most_values_));
    if (event == Event::object_start || event == Event::array_start) {
      if (depth >= most_levels) fail(fmt::format("nested deeper than {} levels", most_levels));
    }
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second) {
      fail(fmt::format("the key {} is there twice", parsed.dump(-1, ' ', false, Json::error_handler_t::replace)));
    }
    return true;
  }

 private:
  [[noreturn]] void fail(std::string const& what) const {
    throw Error(ErrorKind::usage, fmt::format("not a {}: {}", kind_, what));
  }

  std::string_view kind_;
  std::size_t most_values_;
  std::size_t count_ = 0;
  std::vector<std::set<std::string>> keys_;  // of each object that is open
};

}  // namespace

Json parse(std::string_view text, std::string_view kind, std::size_t most_values) {
  try {
    return Json::parse(text, Guard(kind, most_values));
  } catch (Json::parse_error const& error) {
    throw Error(ErrorKind::usage, fmt::format("{}: not JSON", place(text, error.byte > 0 ? error.byte - 1 : 0)));
  } catch (Json::exception const&) {
    throw Error(ErrorKind::usage, "not JSON: a number is too large");
  }
}

}  // namespace lichtraum::json_values
