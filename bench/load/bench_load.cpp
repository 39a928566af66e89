// How long a model takes from its file to the arrays that the device reads, hierarchies aside, next to Assimp reading
// the same file. Both read once before it counts; then they take turns.
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "lichtraum/model.hpp"
#include "node_model.hpp"
#include "scene/flatten.hpp"

using namespace lichtraum;

namespace {

double milliseconds(std::function<void()> const& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

struct Result {
  std::string file;
  double file_megabytes = 0;
  std::size_t triangles = 0;  // in the device's arrays
  std::size_t instances = 0;
  double import_ms = 0;
  double flatten_ms = 0;
  double total_ms = 0;
  std::optional<double> assimp_ms;  // nothing: it cannot read the file
};

/// Freeing what was read is part of neither side's time.
Result measure(std::string const& file, int repetitions) {
  Result result;
  result.file = file;
  result.file_megabytes = double(std::filesystem::file_size(file)) / 1e6;
  std::vector<double> import_ms, flatten_ms, total_ms, assimp_ms;
  for (int i = -1; i < repetitions; ++i) {
    Model model;
    FlatScene flat;
    double const a = milliseconds([&] { model = import_model(file); });
    double const b = milliseconds([&] { flat = flatten(model.scene.roots()); });
    result.triangles = result.instances = 0;
    for (FlatObject const& object : flat.objects) result.triangles += object.triangles.size();
    result.instances = flat.instances.size();
    flat = {};
    model = {};

    aiScene const* scene = nullptr;
    double const c = milliseconds([&] { scene = aiImportFile(file.c_str(), aiProcess_Triangulate); });
    if (scene) aiReleaseImport(scene);
    if (i < 0) continue;
    import_ms.push_back(a);
    flatten_ms.push_back(b);
    total_ms.push_back(a + b);
    if (scene) assimp_ms.push_back(c);
  }
  result.import_ms = median(import_ms);
  result.flatten_ms = median(flatten_ms);
  result.total_ms = median(total_ms);
  if (!assimp_ms.empty()) result.assimp_ms = median(assimp_ms);
  return result;
}

nlohmann::ordered_json to_json(Result const& r) {
  nlohmann::ordered_json json{{"file", r.file},           {"file_megabytes", r.file_megabytes},
                              {"triangles", r.triangles}, {"instances", r.instances},
                              {"import_ms", r.import_ms}, {"flatten_ms", r.flatten_ms},
                              {"total_ms", r.total_ms}};
  json["assimp_ms"] = r.assimp_ms ? nlohmann::ordered_json(*r.assimp_ms) : nullptr;
  json["assimp_over_total"] = r.assimp_ms ? nlohmann::ordered_json(*r.assimp_ms / r.total_ms) : nullptr;
  return json;
}

void print(Result const& r) {
  std::string const name = std::filesystem::path(r.file).filename().string();
  fmt::print("{:<32} {:>8.2f} {:>10} {:>10} {:>9.2f} {:>9.2f} {:>9.2f} {:>9} {:>7}\n", name, r.file_megabytes,
             r.triangles, r.instances, r.import_ms, r.flatten_ms, r.total_ms,
             r.assimp_ms ? fmt::format("{:.2f}", *r.assimp_ms) : "-",
             r.assimp_ms ? fmt::format("{:.2f}", *r.assimp_ms / r.total_ms) : "-");
}

}  // namespace

int main(int argc, char* argv[]) {
  CLI::App app("Loads models with lichtraum and with Assimp, in turns; medians in milliseconds.");
  std::vector<std::string> files;
  int repetitions = 9;
  int nodes = 0;
  std::string json_file;
  app.add_option("files", files, "glTF models");
  app.add_option("--repetitions", repetitions)->check(CLI::PositiveNumber);
  app.add_option("--nodes", nodes, "also a model of that many nodes that share one mesh")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--json", json_file, "write all numbers to this file");
  CLI11_PARSE(app, argc, argv);

  auto const node_model = std::filesystem::temp_directory_path() / fmt::format("lichtraum-{}-nodes.glb", nodes);
  if (nodes > 0) {
    bench::write_node_model(node_model, nodes);
    files.push_back(node_model.string());
  }
  fmt::print("{:<32} {:>8} {:>10} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7}\n", "file", "MB", "triangles", "instances",
             "import", "flatten", "total", "Assimp", "ratio");
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::string const& file : files) {
    Result const result = measure(file, repetitions);
    print(result);
    all.push_back(to_json(result));
  }
  if (nodes > 0) std::filesystem::remove(node_model);
  if (!json_file.empty()) std::ofstream(json_file) << all.dump(2) << "\n";
}
