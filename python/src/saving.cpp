#include "saving.hpp"

#include <fmt/format.h>

namespace lichtraum::python {
namespace {

std::string text_of(std::optional<Resolution> const& size) {
  return size ? fmt::format("{}x{}", size->width, size->height) : "-";
}

std::string text_of(Camera const& camera) {
  Mat4 const& matrix = camera.world_from_camera().matrix();
  std::string text = fmt::format("camera {} {} {} {} {} {}", camera.name(), camera.fov_x_degrees(), camera.width(),
                                 camera.lens().aperture, camera.lens().focus_distance, text_of(camera.resolution()));
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) text += fmt::format(" {}", matrix[column][row]);
  }
  return text + '\n';
}

std::string text_of(RenderCommand const& render) {
  return fmt::format("render {} {} {} {} {} {}\n", render.camera, render.file, text_of(render.resolution),
                     render.integrator ? int(*render.integrator) : -1, render.samples.value_or(-1),
                     render.depth.value_or(-1));
}

}  // namespace

std::vector<EsdfStatement> statements_of(std::string text, std::string const& path, app::RenderOptions const& options) {
  std::vector<EsdfStatement> statements;
  EsdfOptions how;
  static_cast<EsdfDialect&>(how) = options.job.reading.dialect;
  how.allowed_paths = options.job.reading.allowed_paths;
  how.on_statement = [&](EsdfStatement const& statement) { statements.push_back(statement); };
  std::filesystem::path const file(path);
  EsdfScript::from_text(std::move(text), path, how, file.has_parent_path() ? file.parent_path() : ".");
  return statements;
}

std::string identity_of(ReadScene& read) {
  std::lock_guard const lock(*read.mutex);
  Scene const& scene = read.scene;
  std::string text = make_renderer(reference_device())->prepare(scene)->fingerprint + '\n';
  for (Camera const& camera : scene.cameras) text += text_of(camera);
  text += text_of(scene.resolution) + '\n';
  if (!scene.renders.empty()) text += text_of(scene.renders.front());  // what a picture is unless another is asked for
  return text;
}

}  // namespace lichtraum::python
