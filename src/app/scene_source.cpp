#include "app/scene_source.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "lichtraum/orbit.hpp"
#include "lichtraum/turntable.hpp"

namespace lichtraum::app {
namespace {

constexpr std::size_t max_standard_input_bytes = std::size_t(1) << 30;

std::string read_standard_input() {
  std::string text;
  std::string buffer(std::size_t(1) << 16, '\0');
  for (;;) {
    ssize_t const count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Error(ErrorKind::io, fmt::format("cannot read standard input: {}", std::strerror(errno)));
    text.append(buffer, 0, static_cast<std::size_t>(count));
    if (text.size() > max_standard_input_bytes) {
      throw Error(ErrorKind::io, "standard input is longer than 1 GiB: give the scene as a file");
    }
  }
}

/// Without the moment at the end, which a film that is repeated begins with. Empty for an animation of no length.
std::vector<double> whole_animation(double duration_seconds, double rate, std::string const& name) {
  constexpr double most_frames = 100'000;
  double const count = std::round(duration_seconds * rate);
  if (count > most_frames) {
    throw Error(ErrorKind::usage,
                fmt::format("{}: the animation is {:.3g} s long: --frames chooses some of it", name, duration_seconds));
  }
  std::vector<double> times;
  for (int frame = 0; frame < count; ++frame) times.push_back(frame / rate);
  return times;
}

/// Of the studio, beside lights that a model has itself.
constexpr double dim = 0.3;

bool shines(Scene const& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), [](auto const& material) {
    PbrModel const* const pbr = material->pbr();
    return pbr ? pbr->emissive != Rgb(0) : material->phong().emission != Rgb(0);
  });
}

/// What lights a model by paths, whose lights are its own, or were made up so that it is not black.
void light_model(Scene& scene, bool is_studio_chosen) {
  if (!scene.environment && !shines(scene)) return;
  if (!scene.has_own_lights) {
    scene.lights = {};
  } else if (scene.environment && !is_studio_chosen) {
    scene.environment->brightness *= dim;
  }
}

/// Turns what was made up to light a model without lights, so that it comes from above where `up` is that.
void turn_lights(Scene& scene, Vec3 const& up) {
  Vec3 const center = center_of_interest(scene, {}, scene.cameras.front());
  Transform const upright = orbit_rotation({0, 0}, up) * orbit_rotation({0, 0}, scene.up).inverse();
  Registry<Light> turned;
  for (Light const& light : scene.lights) {
    Light::Model model = light.model();
    if (auto* const point = std::get_if<PointLight>(&model)) {
      point->position = center + upright.vector(point->position - center);
    }
    turned.insert(Light(light.name(), std::move(model)));
  }
  scene.lights = std::move(turned);
}

/// Gives a scene the environment that was chosen. Empty where nothing was.
std::function<void(Scene&)> chooser(EnvironmentChoice choice, bool stands_in_studio, LoadOptions const& options) {
  if (stands_in_studio) {
    bool const is_chosen = !choice.source.empty();
    if (!is_chosen) choice.source = "studio";
    return [adjust = chooser(choice, false, options), is_chosen](Scene& scene) {
      adjust(scene);
      light_model(scene, is_chosen);
    };
  }
  if (choice == EnvironmentChoice()) return {};
  return [choice, maps = options.environments, on_read = options.on_read](Scene& scene) {
    scene.environment = chosen_environment(choice, scene.environment,
                                           [&](std::string const& source) { return maps->find(source, on_read); });
  };
}

}  // namespace

std::function<void(Scene&)> scene_adjustment(EnvironmentChoice const& choice, bool is_model, LoadOptions const& given) {
  LoadOptions options = given;
  if (!options.environments) options.environments = std::make_shared<EnvironmentMaps>();
  bool const is_by_paths = options.integrator.value_or(usual_integrator(is_model, options.device)) == Integrator::path;
  auto const choose = chooser(choice, is_model && is_by_paths, options);
  if (!is_model || !options.up) return choose;
  return [choose, up = *options.up](Scene& scene) {
    if (choose) choose(scene);
    if (!scene.has_own_lights) turn_lights(scene, up);
    scene.up = up;
  };
}

SceneSource::SceneSource(std::string argument, std::string input_format) : name_(std::move(argument)) {
  if (name_ != "-") return;
  name_ = "<stdin>";
  bytes_ = read_standard_input();
  if (input_format.empty()) input_format = model_format_of(*bytes_);
  if (!input_format.empty() && input_format != "sdf") name_ += "." + input_format;
}

std::string SceneSource::stem() const { return bytes_ ? "stdin" : std::filesystem::path(name_).stem().string(); }

LoadedScene SceneSource::load(SceneReading const& reading, LoadOptions const& given) const {
  auto const files = std::make_shared<FilesRead>();
  LoadOptions options = given;
  options.on_read = [files, on_read = given.on_read](std::filesystem::path const& file) {
    files->add(file);
    if (on_read) on_read(file);
  };
  LoadedScene scene = read(reading, options);
  scene.set_files(files);
  return scene;
}

LoadedScene SceneSource::read(SceneReading const& reading, LoadOptions const& given) const {
  std::error_code ignored;
  if (!bytes_ && std::filesystem::is_directory(name_, ignored)) {
    std::string const pattern = (std::filesystem::path(name_) / "*.sdf").string();
    throw Error(ErrorKind::no_input,
                fmt::format("cannot open '{}': it is a folder; the scenes in it are '{}'", name_, pattern));
  }
  LoadOptions options = given;
  if (!options.environments) options.environments = std::make_shared<EnvironmentMaps>();
  bool const is_model = is_model_file(name_);
  bool const is_gltf = is_gltf_file(name_);
  if (!options.times_seconds.empty() && !is_gltf) throw Error(ErrorKind::usage, frames_need_gltf);
  auto const adjust = scene_adjustment(reading.environment, is_model, options);
  if (!is_model) {
    auto const find_map = [maps = options.environments](std::string const& source) { return maps->find(source, {}); };
    EsdfOptions const esdf{reading.dialect,
                           reading.allowed_paths,
                           EsdfOptions().max_diagnostics,
                           options.on_read,
                           options.models,
                           find_map,
                           adjust,
                           {},
                           options.has_size};
    return LoadedScene(bytes_ ? EsdfScript::from_text(*bytes_, name_, esdf) : EsdfScript::from_file(name_, esdf));
  }
  auto const adjusted = [&](Model model) {
    if (adjust) adjust(model.scene);
    return LoadedScene(std::move(model));
  };
  ModelOptions model{reading.model, reading.allowed_paths, nullptr, options.on_read};
  bool const is_sequence = !options.times_seconds.empty() || options.whole_animation_rate;
  if (is_sequence && !is_gltf) model.time_seconds = 0;  // for the warning that it has no effect
  if (!is_gltf || !(is_sequence || options.is_posed_later)) {
    return adjusted(bytes_ ? import_model_bytes(*bytes_, name_, model) : import_model(name_, model));
  }
  GltfAnimation animation = bytes_ ? GltfAnimation(*bytes_, name_, model) : GltfAnimation(name_, model);
  if (!is_sequence) return LoadedScene(std::move(animation), reading.model.time_seconds, {}, adjust);
  std::vector<double> times = options.times_seconds;
  if (times.empty()) times = whole_animation(animation.duration_seconds(), *options.whole_animation_rate, name_);
  if (times.empty()) return adjusted(animation.pose(std::nullopt));
  animation.frame_whole_animation();
  return LoadedScene(std::move(animation), std::nullopt, std::move(times), adjust);
}

}  // namespace lichtraum::app
