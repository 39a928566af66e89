#include "app/scene_loader.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/stopwatch.hpp"

namespace lichtraum::app {
namespace {

/// Thrown inside the loader when its results are no longer wanted.
struct Stopped {};

bool is_done_already(PicturePlan const& plan, std::string const& fingerprint) {
  ImageFormat const& format = *plan.output.format;
  std::error_code ignored;
  return format.read_fingerprint && std::filesystem::is_regular_file(plan.output.path, ignored) &&
         format.read_fingerprint(plan.output.path) == fingerprint;
}

/// Of one of several scenes, which not every message names.
std::exception_ptr with_name(Error const& error, std::string const& input) {
  std::string const name = input == "-" ? "<stdin>" : input;
  std::string const message = error.what();
  bool const is_named = message.find(name) != std::string::npos;
  return std::make_exception_ptr(Error(error.kind(), is_named ? message : fmt::format("{}: {}", name, message)));
}

/// The pictures of one scene, while it is played.
class Pictures {
 public:
  Pictures(SceneOpened const& opened, RenderOptions const& options, Renderer const& renderer, Denoiser& denoiser,
           Channel<LoaderMessage>& channel, std::shared_ptr<PreparedScene const>& previous)
      : opened_(opened),
        options_(options),
        renderer_(renderer),
        denoiser_(denoiser),
        channel_(channel),
        previous_(previous) {}

  void send_all_of(Scene const& scene, std::size_t scene_number) {
    double const load_ms = stopwatch_.milliseconds();
    auto const prepared = previous_ = prepare(scene);
    std::optional<Vec3> turn_center;
    for (; next_ < opened_.plans.size() && opened_.plans[next_].scene_number == scene_number; ++next_) {
      PicturePlan const& plan = opened_.plans[next_];
      PictureReady picture;
      picture.number = next_;
      picture.request = request_for(plan, scene, turn_center);
      picture.background = picture.request.background.value_or(scene.background);
      picture.scene = prepared;
      picture.light = light_in(scene, picture.request.integrator);
      if (scene.environment) picture.map_repairs = scene.environment->map->repairs;
      if (plan.output.format->encode) picture.development = development_of(plan.job, scene);
      picture.fingerprint = fmt::format("{}-{}", picture_fingerprint(*prepared, picture.request, picture.development),
                                        plan.job.encoding.bits);
      if (plan.job.noise) picture.fingerprint += fmt::format("-noise-{}", *plan.job.noise);
      if (plan.job.denoising != Denoising::off) {
        picture.denoiser = denoiser_.name(plan.job.denoising);
        picture.fingerprint += "-" + picture.denoiser;
      }
      picture.is_done = options_.resume && is_done_already(plan, picture.fingerprint);
      picture.load_ms = load_ms;
      if (!channel_.send(std::move(picture))) throw Stopped();
    }
    stopwatch_ = {};
  }

 private:
  std::shared_ptr<PreparedScene const> prepare(Scene const& scene) const {
    std::string const& root = options_.job.root;
    try {
      return renderer_.prepare(scene, root, previous_);
    } catch (Error const& error) {
      if (root.empty() || scene.shapes.contains(root)) throw;
      throw Error(error.kind(), fmt::format("{}: --root: {}", opened_.source->name(), error.what()));
    }
  }

  SceneOpened const& opened_;
  RenderOptions const& options_;
  Renderer const& renderer_;
  Denoiser& denoiser_;
  Channel<LoaderMessage>& channel_;
  std::shared_ptr<PreparedScene const>& previous_;
  Stopwatch stopwatch_;
  std::size_t next_ = 0;
};

}  // namespace

SceneLoader::SceneLoader(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
                         Renderer const& renderer, Denoiser& denoiser)
    : options_(options), names_(names), renderer_(renderer), denoiser_(denoiser), thread_([this, &inputs] {
        for (std::string const& input : inputs) {
          SceneClosed closed;
          try {
            load(input);
          } catch (Stopped const&) {
            return;
          } catch (SceneError const&) {
            closed.failure = std::current_exception();
          } catch (Error const& error) {
            closed.failure = inputs.size() > 1 && error.kind() != ErrorKind::internal ? with_name(error, input)
                                                                                      : std::current_exception();
          } catch (...) {
            closed.failure = std::current_exception();
          }
          if (!channel_.send(std::move(closed))) return;
        }
      }) {}

SceneLoader::~SceneLoader() { channel_.close(); }

std::optional<LoaderMessage> SceneLoader::next() { return channel_.receive(std::chrono::milliseconds(50)); }

LoadedScene SceneLoader::read(SceneSource const& source) {
  try {
    return source.load(options_.job.reading, options_.load);
  } catch (...) {
    names_.begin_scene(1);  // nobody knows how many it has
    throw;
  }
}

void SceneLoader::load(std::string const& input) {
  Stopwatch const stopwatch;
  SceneOpened opened;
  opened.source = std::make_shared<SceneSource>(input, options_.input_format);
  LoadedScene script = read(*opened.source);
  opened.load_ms = stopwatch.milliseconds();
  opened.is_model = script.is_model();
  if (ModelContents const* const contents = script.contents(); contents && contents->animation) {
    opened.animation = contents->animations.at(*contents->animation);
  }
  opened.has_environment = script.scene().environment.has_value();
  opened.diagnostics = script.diagnostics();
  std::exception_ptr faulty_plan;
  try {
    opened.plans = plan_pictures(script, *opened.source, options_, names_);
  } catch (Error const&) {
    faulty_plan = std::current_exception();  // what was found in the scene is told first
  }
  if (!channel_.send(opened)) throw Stopped();
  if (faulty_plan) std::rethrow_exception(faulty_plan);
  Pictures pictures(opened, options_, renderer_, denoiser_, channel_, previous_);
  script.play([&](Scene const& scene, std::size_t number) {
    pictures.send_all_of(scene, number);
    return true;
  });
}

}  // namespace lichtraum::app
