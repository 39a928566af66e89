#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <new>

#include "core/ascii.hpp"
#include "core/read_file.hpp"
#include "io/gltf/extensions.hpp"
#include "io/gltf/materials.hpp"
#include "io/gltf/scene_graph.hpp"
#include "io/gltf/views.hpp"
#include "lichtraum/gltf.hpp"

namespace lichtraum {
namespace gltf {
namespace {

void check_extensions(tinygltf::Model const& model, Findings& findings) {
  for (std::string const& name : model.extensionsRequired) {
    if (is_supported_extension(name)) continue;
    findings.warn("/extensionsRequired",
                  fmt::format("the model needs {}, which is not supported; what can be read without it is", name));
  }
}

/// The element of `list` with that index or name. Throws Error{usage} that lists what there is.
template <class List>
int select(List const& list, std::string const& selector, char const* kind) {
  int index = -1;
  auto const [end, error] = std::from_chars(selector.data(), selector.data() + selector.size(), index);
  bool const is_number = error == std::errc() && end == selector.data() + selector.size();
  if (is_number && index >= 0 && std::size_t(index) < list.size()) return index;
  std::string known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].name == selector) return int(i);
    known += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, list[i].name);
  }
  throw Error(ErrorKind::usage, fmt::format("there is no {} '{}' in the model; it has: {}", kind, selector,
                                            known.empty() ? "none" : known));
}

int select_scene(tinygltf::Model const& model, std::string const& selector) {
  if (!selector.empty()) return select(model.scenes, selector, "scene");
  if (model.defaultScene >= 0) return model.defaultScene;
  return model.scenes.empty() ? -1 : 0;
}

class Importer {
 public:
  Importer(std::filesystem::path const& path, GltfOptions const& options) : options_(options), findings_(path) {
    document_.path = path;
    document_.allowed_paths = options.allowed_paths;
    document_.bytes = read_file(path);
  }

  GltfModel run() {
    parse_document(document_, findings_);
    tinygltf::Model const& model = document_.model;
    check_extensions(model, findings_);

    Buffers buffers(document_, findings_);
    Accessors accessors(document_, buffers, findings_);
    std::vector<NodePose> pose = rest_pose(model, findings_);
    if (options_.time_seconds) {
      int const animation = options_.animation.empty() ? 0 : select(model.animations, options_.animation, "animation");
      if (model.animations.empty()) {
        findings_.warn("/animations", "there is none; the time has no effect");
      } else {
        apply_animation(model, animation, *options_.time_seconds, accessors, findings_, pose);
      }
    }
    int const scene_number = select_scene(model, options_.scene);
    NodeTree const tree = build_node_tree(model, scene_number, pose, findings_);

    GltfModel result;
    auto const own_materials = read_materials(document_, options_.max_texture, buffers, findings_);
    for (auto const& material : own_materials) result.scene.materials.insert(material);
    std::vector<std::shared_ptr<Material const>> materials(own_materials.begin(), own_materials.end());
    if (options_.material) std::fill(materials.begin(), materials.end(), options_.material);

    Primitives primitives(document_, buffers, accessors, findings_);
    Names names;
    SceneGraph graph(document_, tree, pose, primitives, accessors, materials, names, findings_);
    std::string const scene_name = scene_number >= 0 ? model.scenes[std::size_t(scene_number)].name : "";
    graph.build(scene_name.empty() ? document_.path.stem().string() : scene_name, result.scene);
    if (graph.triangles() == 0) {
      if (graph.faulty_primitives() > 0) findings_.fail("", "nothing of the model can be drawn");
      findings_.warn("", "the scene shows no triangles");
    }

    add_view(tree, result.scene);
    result.diagnostics = findings_.take();
    return result;
  }

 private:
  void add_view(NodeTree const& tree, Scene& scene) {
    WorldBox const box = bounds_of(scene.roots());
    for (Camera& camera : read_cameras(document_.model, tree, findings_)) scene.cameras.insert(std::move(camera));
    if (scene.cameras.empty()) scene.cameras.insert(frame_box("default", box));
    std::vector<Light> lights = read_lights(document_.model, tree, box, findings_);
    if (lights.empty()) lights = studio_lights(box);
    for (Light& light : lights) scene.lights.insert(std::move(light));
  }

  GltfOptions const& options_;
  Findings findings_;
  Document document_;
};

}  // namespace
}  // namespace gltf

bool is_gltf_file(std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  return extension == ".gltf" || extension == ".glb";
}

GltfModel import_gltf(std::filesystem::path const& path, GltfOptions const& options) {
  try {
    return gltf::Importer(path, options).run();
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::scene, fmt::format("{}: the model needs more memory than there is", path.string()));
  }
}

Scene load_gltf(std::filesystem::path const& path, GltfOptions const& options) {
  return std::move(import_gltf(path, options).scene);
}

}  // namespace lichtraum
