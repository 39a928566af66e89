#include <fmt/format.h>

#include <utility>

#include "core/read_file.hpp"
#include "io/esdf/foreign_file.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/model_cache.hpp"
#include "lichtraum/esdf.hpp"

namespace lichtraum {

/// The result of one run over the text, and what is needed to run again for an animation.
struct EsdfScript::State {
  EsdfOptions options;
  std::string text;  ///< empty when the scene does not change between its renders
  esdf::Source source;
  Scene scene;
  std::vector<Diagnostic> diagnostics;
  bool is_animated = false;
};

EsdfScript::EsdfScript(std::unique_ptr<State> state) : state_(std::move(state)) {}
EsdfScript::~EsdfScript() = default;
EsdfScript::EsdfScript(EsdfScript&&) noexcept = default;
EsdfScript& EsdfScript::operator=(EsdfScript&&) noexcept = default;

EsdfScript EsdfScript::from_file(std::filesystem::path const& path, EsdfOptions const& options) {
  std::filesystem::path const folder = path.has_parent_path() ? path.parent_path() : ".";
  if (options.on_read) options.on_read(path);
  return from_text(read_file(path), path.string(), options, folder);
}

EsdfScript EsdfScript::from_text(std::string text, std::string name, EsdfOptions const& options,
                                 std::filesystem::path const& folder) {
  auto state = std::make_unique<State>();
  state->options = options;
  if (!state->options.models) state->options.models = make_model_cache();
  state->options.models->begin_script();
  state->text = std::move(text);
  normalise_line_breaks(state->text);
  // Nothing of a foreign file is worth keeping, so options.keep_going changes nothing here.
  if (auto const foreign = esdf::recognise_foreign_file(name, state->text)) {
    Diagnostic problem;
    problem.code = foreign->code;
    problem.location = {std::move(name), 1, 0};
    problem.message = foreign->message;
    problem.hint = foreign->hint;
    throw SceneError(std::vector<Diagnostic>{std::move(problem)});
  }
  state->source = {state->text, std::move(name), folder, mesh_formats()};

  esdf::Interpreter interpreter(state->source, state->options);
  interpreter.run();
  state->diagnostics = interpreter.take_diagnostics();
  if (interpreter.has_errors() && !options.keep_going) throw SceneError(std::move(state->diagnostics));
  state->scene = std::move(interpreter.scene);
  if (options.adjust) options.adjust(state->scene);
  state->is_animated = interpreter.is_animated();
  if (!state->is_animated) {
    state->source.text = {};
    state->text = {};
  }
  return EsdfScript(std::move(state));
}

std::vector<Diagnostic> const& EsdfScript::diagnostics() const { return state_->diagnostics; }

Scene const& EsdfScript::scene() const { return state_->scene; }

void EsdfScript::rewind() {
  if (!state_->is_animated) return;
  esdf::Interpreter interpreter(state_->source, state_->options);
  esdf::DrawFunction const stop = [](Scene const&, RenderCommand const&) { return false; };
  interpreter.run(&stop);
  Scene const end = std::exchange(state_->scene, std::move(interpreter.scene));
  for (Camera const& camera : end.cameras) state_->scene.cameras.insert(camera);
  for (auto const& material : end.materials) state_->scene.materials.insert(material);
  state_->scene.renders = end.renders;
}

Scene EsdfScript::take_scene() && { return std::move(state_->scene); }

void EsdfScript::play(std::function<bool(Scene const&, RenderCommand const&)> const& draw) const {
  if (state_->is_animated) {
    esdf::Interpreter(state_->source, state_->options).run(&draw);
    return;
  }
  for (RenderCommand const& command : state_->scene.renders) {
    if (!draw(state_->scene, command)) return;
  }
}

Scene load_esdf(std::filesystem::path const& path, EsdfOptions const& options) {
  return EsdfScript::from_file(path, options).take_scene();
}

}  // namespace lichtraum
