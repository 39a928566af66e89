#include "view/edited_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <vector>

#include "lichtraum/error.hpp"
#include "view/values_as_esdf.hpp"

namespace lichtraum::view {
namespace {

[[noreturn]] void refuse(std::string const& why) { throw Error(ErrorKind::cannot_create, "nothing is saved: " + why); }

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream in{std::string(line.substr(0, line.find('#')))};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
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

/// A light with one number for its brightness: it also chooses the tones of the picture.
bool is_dialect(std::vector<std::string> const& words) {
  if (words[2] == "environment") return false;
  constexpr std::size_t standard = 12;
  return words[1] == "light" && words[2] != "diffuse" && words[2] != "ambient" && words.size() < standard;
}

using NewLine = std::function<std::string(std::vector<std::string> const& words)>;

/// The same map, turned and dimmed in another way.
std::string environment_line(std::vector<std::string> const& words, EnvironmentLight const& environment) {
  std::string line;
  for (std::string const& word : words) {
    if (word.starts_with("rotation=") || word.starts_with("brightness=")) continue;
    line += line.empty() ? word : ' ' + word;
  }
  if (environment.rotation_degrees != 0) line += fmt::format(" rotation={}", environment.rotation_degrees);
  if (environment.brightness != 1) line += fmt::format(" brightness={}", environment.brightness);
  return line + '\n';
}

/// What the line of each edited thing becomes, from its words.
std::map<std::string, NewLine> new_lines(SceneValues const& values) {
  std::map<std::string, NewLine> lines;
  auto const replace = [&](std::string const& what, std::string line) {
    lines[what] = [line = std::move(line)](auto const&) { return line; };
  };
  for (auto const& material : values.materials) {
    // A scene's names are words of it, and other lines use them: they stay as they are.
    std::string const& name = material.original->name();
    if (material.is_edited) replace("material " + name, material_statement(name, material.value) + '\n');
  }
  for (std::size_t i = 0; i < values.lights.size(); ++i) {
    Light const& light = values.lights[i];
    if (light != values.original_light(i)) {
      replace("light " + light.name(), light_statement(light.name(), light) + '\n');
    }
  }
  if (values.is_environment_edited()) {
    if (values.environment->name.empty()) {
      refuse("the environment is not from the scene's file; --environment-rotation and -brightness set it");
    }
    lines["environment " + values.environment->name] = [environment = *values.environment](auto const& words) {
      return environment_line(words, environment);
    };
  }
  return lines;
}

}  // namespace

std::string edited_scene(std::string_view text, SceneValues const& values) {
  auto missing = new_lines(values);
  if (missing.empty()) refuse("no light, environment or material was changed");
  std::string result;
  while (!text.empty()) {
    std::string_view const line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    auto const words = words_of(line);
    auto const found = missing.find(thing_defined_by(words));
    if (found == missing.end()) {
      result.append(line) += '\n';
      continue;
    }
    if (is_dialect(words)) refuse(fmt::format("{} is defined in a dialect; copy it instead", found->first));
    result += found->second(words);
    missing.erase(found);
  }
  if (!missing.empty()) {
    refuse(fmt::format("no line of the scene's file defines {}; copy it instead", missing.begin()->first));
  }
  return result;
}

}  // namespace lichtraum::view
