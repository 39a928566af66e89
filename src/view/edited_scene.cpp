#include "view/edited_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "lichtraum/error.hpp"
#include "view/values_as_esdf.hpp"

namespace lichtraum::view {
namespace {

[[noreturn]] void refuse(std::string const& why) { throw Error(ErrorKind::cannot_create, "nothing is saved: " + why); }

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Cuts the first line off, with its break, which is one that the reader of scenes knows: LF, CR LF or CR.
std::string_view take_line(std::string_view& text) {
  std::size_t const end = std::min(text.find_first_of("\r\n"), text.size());
  std::size_t const break_size = text.substr(end).starts_with("\r\n") ? 2 : 1;
  std::string_view const line = text.substr(0, end + break_size);
  text.remove_prefix(line.size());
  return line;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream in{std::string(without_comment(line))};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The line with another statement, and all that was around the one it had: blanks, a comment, the line break.
std::string with_statement(std::string_view line, std::string const& statement) {
  constexpr char const* blanks = " \t\v\f\r\n";
  std::string_view const old = without_comment(line);
  std::string result(line.substr(0, old.find_first_not_of(blanks)));
  return result.append(statement).append(line.substr(old.find_last_not_of(blanks) + 1));
}

/// "material red", "light lamp" or "environment room" of a line that defines one; empty for others.
std::string thing_defined_by(std::vector<std::string> const& words) {
  if (words.size() < 4 || words[0] != "define") return {};
  if (words[1] == "material") return "material " + words[2];
  if (words[1] != "light") return {};
  if (words[2] == "environment") return "environment " + words[3];
  bool const has_kind = words[2] == "diffuse" || words[2] == "ambient";
  return "light " + words[has_kind ? 3 : 2];
}

/// Whether it is `define light <name> [position] [colour] <brightness>`, which also chooses the tones of the picture:
/// no other statement does, so none can stand for it.
bool has_brightness(std::vector<std::string> const& words) {
  if (words[1] != "light" || words[2] == "diffuse" || words[2] == "ambient" || words[2] == "environment") return false;
  auto const is_number = [](std::string const& word) { return word.find('=') == std::string::npos; };
  return std::count_if(words.begin() + 3, words.end(), is_number) == 7;
}

using NewStatement = std::function<std::string(std::vector<std::string> const& words)>;

/// The same map, turned and dimmed in another way.
std::string environment_statement(std::vector<std::string> const& words, EnvironmentLight const& environment) {
  std::string statement;
  for (std::string const& word : words) {
    if (word.starts_with("rotation=") || word.starts_with("brightness=")) continue;
    statement += statement.empty() ? word : ' ' + word;
  }
  if (environment.rotation_degrees != 0) statement += fmt::format(" rotation={}", environment.rotation_degrees);
  if (environment.brightness != 1) statement += fmt::format(" brightness={}", environment.brightness);
  return statement;
}

/// What the statement that defines each edited thing becomes, from its words.
std::map<std::string, NewStatement> new_statements(SceneValues const& values) {
  std::map<std::string, NewStatement> statements;
  auto const replace = [&](std::string const& what, std::string statement) {
    statements[what] = [statement = std::move(statement)](auto const&) { return statement; };
  };
  for (auto const& material : values.materials) {
    // A scene's names are words of it, and other lines use them: they stay as they are.
    std::string const& name = material.original->name();
    if (!material.is_edited) continue;
    if (!material.is_listed) {
      refuse(fmt::format("no line of the scene's file defines the material {} that was changed; copy it instead",
                         name.empty() ? "without a name" : name));
    }
    replace("material " + name, material_statement(name, material.value));
  }
  for (std::size_t i = 0; i < values.lights.size(); ++i) {
    Light const& light = values.lights[i];
    if (light != values.original_light(i)) replace("light " + light.name(), light_statement(light.name(), light));
  }
  if (values.is_environment_edited()) {
    if (values.environment->name.empty()) {
      refuse("the environment is not from the scene's file; --environment-rotation and -brightness set it");
    }
    statements["environment " + values.environment->name] = [environment = *values.environment](auto const& words) {
      return environment_statement(words, environment);
    };
  }
  return statements;
}

}  // namespace

std::string edited_scene(std::string_view text, SceneValues const& values) {
  auto const statements = new_statements(values);
  if (statements.empty()) refuse("no light, environment or material was changed");
  std::set<std::string> written;
  std::string result;
  if (text.starts_with(byte_order_mark)) {
    result = byte_order_mark;
    text.remove_prefix(byte_order_mark.size());
  }
  while (!text.empty()) {
    std::string_view const line = take_line(text);
    auto const words = words_of(line);
    auto const found = statements.find(thing_defined_by(words));
    if (found == statements.end()) {
      result += line;
      continue;
    }
    if (!written.insert(found->first).second) {  // read with --keep-going
      refuse(fmt::format("more than one line of the scene's file defines {}; copy it instead", found->first));
    }
    if (has_brightness(words)) {
      refuse(
          fmt::format("{} is defined as a colour times a brightness, which also chooses the tone map; write Ld "
                      "instead, or copy the light and choose --tonemap",
                      found->first));
    }
    result += with_statement(line, found->second(words));
  }
  for (auto const& [what, statement] : statements) {
    if (!written.contains(what)) {
      refuse(fmt::format("no line of the scene's file defines {}; copy it instead", what));
    }
  }
  return result;
}

void check_readable(std::string const& text, std::filesystem::path const& file, EsdfOptions const& options) {
  try {
    EsdfScript::from_text(text, file.string(), options, file.has_parent_path() ? file.parent_path() : ".");
  } catch (Error const& error) {
    refuse(fmt::format("the file could not be read again; was it changed since it was read?\n{}", error.what()));
  }
}

}  // namespace lichtraum::view
