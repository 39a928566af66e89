#include "options.hpp"

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"

namespace lichtraum::python {
namespace {

std::unique_ptr<CLI::App> parser_for(app::RenderOptions& options) {
  auto parser = app::make_parser("render", "", "");
  app::add_picture_options(*parser, options);
  app::add_drawing_options(*parser, options);
  return parser;
}

}  // namespace

app::RenderOptions parse_options(std::vector<std::string> const& words) {
  app::RenderOptions options;
  app::parse(*parser_for(options), words);
  return options;
}

std::vector<std::string> option_names() {
  app::RenderOptions options;
  std::vector<std::string> names;
  auto const parser = parser_for(options);
  for (CLI::Option const* const option : parser->get_options()) {
    for (std::string const& name : option->get_lnames()) names.push_back(name);
  }
  return names;
}

}  // namespace lichtraum::python
