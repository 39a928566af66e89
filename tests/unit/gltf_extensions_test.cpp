#include <fstream>
#include <set>
#include <sstream>

#include "io/gltf/extensions.hpp"
#include "support/catch.hpp"
#include "support/project_files.hpp"

using namespace lichtraum;

TEST_CASE("docs/GLTF.md lists the extensions that the importer reads", "[unit][gltf]") {
  std::ifstream in(project_path("docs/GLTF.md"));
  REQUIRE(in);
  std::set<std::string> documented;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("| KHR_") || line.starts_with("| EXT_")) documented.insert(line);
  }
  std::set<std::string> known;
  for (auto const& extension : gltf::supported_extensions()) {
    known.insert("| " + std::string(extension.name) + " | " + std::string(extension.support) + " |");
  }
  CHECK(documented == known);
}
