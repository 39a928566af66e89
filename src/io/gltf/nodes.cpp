#include "io/gltf/nodes.hpp"

#include <nlohmann/json.hpp>

namespace lichtraum::gltf {
namespace {

using nlohmann::json;

/// Recursive: parse_document has limited the depth.
tinygltf::Value to_value(json& source) {
  if (source.is_object()) {
    tinygltf::Value::Object object;
    for (auto& [name, member] : source.items()) object.emplace(name, to_value(member));
    return tinygltf::Value(std::move(object));
  }
  if (source.is_array()) {
    tinygltf::Value::Array array;
    for (json& element : source) array.push_back(to_value(element));
    return tinygltf::Value(std::move(array));
  }
  if (source.is_string()) return tinygltf::Value(std::move(source.get_ref<std::string&>()));
  if (source.is_boolean()) return tinygltf::Value(source.get<bool>());
  if (source.is_number()) return tinygltf::Value(source.get<double>());
  return {};
}

template <class T>
std::vector<T> to_numbers(json const& array) {
  std::vector<T> numbers;
  numbers.reserve(array.size());
  for (json const& number : array) numbers.push_back(number.get<T>());
  return numbers;
}

tinygltf::Node to_node(json& source) {
  tinygltf::Node node;
  for (auto& [name, value] : source.items()) {
    if (name == "name") node.name = std::move(value.get_ref<std::string&>());
    if (name == "mesh") node.mesh = value.get<int>();
    if (name == "camera") node.camera = value.get<int>();
    if (name == "skin") node.skin = value.get<int>();
    if (name == "children") node.children = to_numbers<int>(value);
    if (name == "matrix") node.matrix = to_numbers<double>(value);
    if (name == "translation") node.translation = to_numbers<double>(value);
    if (name == "rotation") node.rotation = to_numbers<double>(value);
    if (name == "scale") node.scale = to_numbers<double>(value);
    if (name == "weights") node.weights = to_numbers<double>(value);
    if (name != "extensions") continue;
    for (auto& [extension, parameters] : value.items()) node.extensions.emplace(extension, to_value(parameters));
  }
  return node;
}

}  // namespace

std::vector<tinygltf::Node> take_nodes(json& model) {
  std::vector<tinygltf::Node> nodes;
  auto const list = model.find("nodes");
  if (list == model.end()) return nodes;
  nodes.reserve(list->size());
  for (json& source : *list) nodes.push_back(to_node(source));
  model.erase(list);
  return nodes;
}

}  // namespace lichtraum::gltf
