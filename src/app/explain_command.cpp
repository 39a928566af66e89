#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "core/edit_distance.hpp"
#include "lichtraum/explanation.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* explain_description =
    "Says what errors and warnings mean, by the code at the end of their line: a\n"
    "paragraph and an example of each CODE. Without one, lists all codes.";

constexpr char const* explain_examples =
    "  lichtraum explain E0412\n"
    "  lichtraum explain e0301 w0506\n"
    "  lichtraum explain\n";

std::string upper_case(std::string word) {
  std::ranges::transform(word, word.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return word;
}

/// "did you mean E0411, E0412 or E0413?", three at most: the nearest, and of these those that begin alike.
std::string codes_like(std::string const& word) {
  struct Near {
    std::size_t distance;
    std::ptrdiff_t unlike;
    std::string_view text;
  };
  constexpr std::size_t farthest = 2, most = 3;
  std::vector<Near> near;
  for (DiagnosticCodeEntry const& entry : diagnostic_codes) {
    if (entry.code == DiagnosticCode::none) continue;
    std::size_t const distance = edit_distance(word, entry.text, farthest);
    auto const alike = std::ranges::mismatch(word, entry.text).in1 - word.begin();
    if (distance <= farthest) near.push_back({distance, -alike, entry.text});
  }
  if (near.empty()) return "lichtraum explain lists all codes";
  std::ranges::stable_sort(near, {}, [](Near const& code) { return std::pair(code.distance, code.unlike); });
  near.resize(std::min(near.size(), most));
  std::string text(near.front().text);
  for (std::size_t i = 1; i < near.size(); ++i) text.append(i + 1 < near.size() ? ", " : " or ").append(near[i].text);
  return fmt::format("did you mean {}?", text);
}

/// Letters say no more than how bad it is: the number tells a kind, with any or none before it.
DiagnosticCodeEntry const& find_code(std::string const& argument) {
  std::string const word = upper_case(argument);
  std::string number = word.substr(word.starts_with('E') || word.starts_with('W') ? 1 : 0);
  constexpr std::size_t digits = 4;
  if (!number.empty() && number.size() < digits) number.insert(0, digits - number.size(), '0');  // E412 is E0412
  for (DiagnosticCodeEntry const& entry : diagnostic_codes) {
    if (entry.code != DiagnosticCode::none && entry.text.substr(1) == number) return entry;
  }
  throw Error(ErrorKind::usage, fmt::format("explain: there is no code '{}': {}", argument, codes_like(word)));
}

std::string indented(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    std::size_t const end = lines.find('\n') + 1;
    text.append(end > 1 ? "    " : "").append(lines.substr(0, end));
    lines.remove_prefix(end);
  }
  return text;
}

std::string explained(DiagnosticCodeEntry const& entry) {
  Explanation const& explanation = *explanation_of(entry.code);
  std::string text = fmt::format("{}: {}\n\n{}", entry.text, entry.title, explanation.text);
  if (explanation.example.empty()) return text;
  std::string const how =
      explanation.command == Explanation{}.command ? "For example" : fmt::format("With {}", explanation.command);
  return text +
         fmt::format("\n{}:\n\n{}\nInstead:\n\n{}", how, indented(explanation.example), indented(explanation.instead));
}

std::string list_of_codes() {
  std::string text;
  for (ExplanationGroup const& group : explanation_groups()) {
    text += fmt::format("{}\n", group.title);
    for (Explanation const& explanation : group.explanations) {
      auto const& entry = diagnostic_codes[static_cast<std::size_t>(explanation.code)];
      text += fmt::format("  {}  {}\n", entry.text, entry.title);
    }
    text += '\n';
  }
  return text + "lichtraum explain CODE says more about one.\n";
}

}  // namespace

int explain_command(Arguments const& arguments, Console& console) {
  std::vector<std::string> words;
  auto const parser = make_parser("explain", explain_description, explain_examples);
  add_inputs(*parser, words, "[CODE...]");
  parser->get_option("inputs")->required(false);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;

  std::string text;
  for (std::string const& word : words) text += (text.empty() ? "" : "\n") + explained(find_code(word));
  write_standard_output(words.empty() ? list_of_codes() : text);
  return 0;
}

}  // namespace lichtraum::app
