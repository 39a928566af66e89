#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "io/esdf/arguments.hpp"

namespace lichtraum::esdf {

/// A key=value argument that a statement takes.
struct Key {
  std::string_view word;
  std::function<bool(Token value)> read;  ///< reports what is wrong with the value, and then returns false
  bool is_dialect = false;                ///< options.strict refuses it
};

/// Whether an argument is of the form key=value, as far as it goes.
inline bool has_key(Token argument) { return argument.find('=') != Token::npos; }

/// "reflect=, transmit= and ior=", with what else may stand there as the last: "emission <r> <g> <b>".
std::string list_of(std::span<Key const> keys, std::string_view other = {});

/// Where the key=value arguments of a statement begin, which are not among its `names` first ones; its size when it has
/// none.
std::size_t first_key(Statement const& statement, std::size_t names);

/// Reads the arguments at the end of `statement` from `first` on, each of which is to be one of `keys`, and none twice.
/// Every faulty one is reported; then false. `usage`: a hint on arguments that have no key. `other`: as for list_of.
bool read_keys(Interpreter& interpreter, Statement const& statement, std::size_t first, std::span<Key const> keys,
               std::string const& usage, std::string_view other = {});

}  // namespace lichtraum::esdf
