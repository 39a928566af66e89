#pragma once

#include <fmt/format.h>

#include <string>
#include <unordered_map>

namespace lichtraum {

/// Hands out names that nothing else has: "Wheel", "Wheel#2", "Wheel#3".
class Names {
 public:
  std::string unique(std::string const& wanted) {
    std::size_t& count = counts_[wanted];
    std::string name = ++count == 1 ? wanted : fmt::format("{}#{}", wanted, count);
    while (name != wanted && counts_.contains(name)) name = fmt::format("{}#{}", wanted, ++count);
    if (name != wanted) counts_.emplace(name, 1);
    return name;
  }

 private:
  std::unordered_map<std::string, std::size_t> counts_;
};

}  // namespace lichtraum
