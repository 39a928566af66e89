#include "session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/option_effects.hpp"
#include "app/renderer_choice.hpp"
#include "app/scene_source.hpp"

namespace lichtraum::python {
namespace {

/// Of files, not of standard input: "-" would be that, and any other way to its name is not.
app::SceneSource source_of(std::string const& path) { return app::SceneSource(path == "-" ? "./-" : path); }

std::optional<Traversal> traversal_of(std::string const& word) {
  return word.empty() ? std::nullopt : app::parse_traversal(word);
}

/// Gives a scene back the lights, the environment and the direction upwards that it had.
class SceneAsItWas {
 public:
  explicit SceneAsItWas(Scene& scene) : scene_(scene), environment_(scene.environment), up_(scene.up) {
    for (Light const& light : scene.lights) lights_.push_back(light);
  }
  ~SceneAsItWas() {
    scene_.up = up_;
    scene_.environment = environment_;
    scene_.lights = {};
    for (Light& light : lights_) scene_.lights.insert(std::move(light));
  }
  SceneAsItWas(SceneAsItWas const&) = delete;
  SceneAsItWas& operator=(SceneAsItWas const&) = delete;

 private:
  Scene& scene_;
  std::optional<EnvironmentLight> environment_;
  Vec3 up_;
  std::vector<Light> lights_;
};

void warn_of(std::vector<app::OptionWithoutEffect> const& useless, std::vector<Diagnostic>& diagnostics) {
  for (auto const& [option, why] : useless) {
    diagnostics.push_back({Severity::warning,
                           DiagnosticCode::option_without_effect,
                           {},
                           1,
                           fmt::format("{} has no effect{}", option, why),
                           {},
                           {}});
  }
}

}  // namespace

ReadScene read_scene(std::string const& path, app::RenderOptions const& options) {
  ReadScene read;
  app::SceneSource const source = source_of(path);
  read.name = source.name();
  read.is_model = is_model_file(source.name());
  SceneReading const& reading = options.job.reading;
  FileObserver const on_read = [&read](std::filesystem::path const& file) { read.files.add(file); };
  if (read.is_model) {
    Model model = import_model(source.name(), {reading.model, reading.allowed_paths, nullptr, on_read});
    read.scene = std::move(model.scene);
    read.diagnostics = std::move(model.diagnostics);
  } else {
    EsdfOptions how;
    static_cast<EsdfDialect&>(how) = reading.dialect;
    how.allowed_paths = reading.allowed_paths;
    how.on_read = on_read;
    EsdfScript script = EsdfScript::from_file(source.name(), how);
    read.diagnostics = script.diagnostics();
    read.scene = std::move(script).take_scene();
  }
  warn_of(app::options_without_effect(reading, read.is_model), read.diagnostics);
  return read;
}

Session::Session(std::string const& device, std::string const& traversal)
    : renderer_(app::choose_renderer(
          device, traversal_of(traversal), [this](std::string const& text) { warnings_.push_back(text); },
          [](std::string const&) {})) {}

app::LoadOptions Session::load_options(app::RenderOptions const& options, SourceFiles& files) {
  app::LoadOptions load;
  load.on_read = [&files](std::filesystem::path const& file) { files.add(file); };
  load.models = models_;
  load.environments = environments_;
  load.set_drawing(options.job, renderer_->device().kind);
  return load;
}

Picture Session::draw_file(std::string const& path, app::RenderOptions const& options, int number, Control& control) {
  std::lock_guard const lock(mutex_);
  app::SceneSource const source = source_of(path);
  SourceFiles files;
  app::LoadedScene loaded = source.load(options.job.reading, load_options(options, files));
  Job job = source.job(options.job);
  job.picture = number;
  auto const count = std::max<std::size_t>(1, loaded.scene().renders.size());
  if (number < 0 || std::size_t(number) >= count) {
    throw Error(ErrorKind::usage,
                fmt::format("{}: there is no picture {}: it has {}, counted from 0", path, number, count));
  }
  Picture picture;
  loaded.play([&](Scene const& scene, std::size_t index) {
    if (index != std::size_t(number)) return true;
    picture = draw(*renderer_, scene, is_model_file(source.name()), job, previous_, control);
    warn_of(app::options_without_effect(job, picture.job, is_model_file(source.name()), scene.environment.has_value()),
            picture.diagnostics);
    return false;
  });
  picture.files = std::move(files);
  auto const& found = loaded.diagnostics();
  picture.diagnostics.insert(picture.diagnostics.begin(), found.begin(), found.end());
  return picture;
}

Picture Session::draw_scene(ReadScene& read, app::RenderOptions const& options, int number, Control& control) {
  std::lock_guard const lock(mutex_);
  std::lock_guard const scene_lock(*read.mutex);
  SceneAsItWas const as_it_was(read.scene);
  SourceFiles files = read.files;
  if (auto const adjust =
          app::scene_adjustment(options.job.reading.environment, read.is_model, load_options(options, files))) {
    adjust(read.scene);
  }
  Job job = options.job;
  job.scene = read.name;
  job.picture = number;
  Picture picture = draw(*renderer_, read.scene, read.is_model, job, previous_, control);
  picture.files = std::move(files);
  warn_of(app::options_without_effect(job, picture.job, read.is_model, read.scene.environment.has_value()),
          picture.diagnostics);
  return picture;
}

}  // namespace lichtraum::python
