#include "lichtraum/job.hpp"

#include "lichtraum/pbr_model.hpp"
#include "lichtraum/shapes.hpp"
#include "lichtraum/turntable.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"

// What a job asks for, against what a scene says: which wins, and what cannot be.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// Two cameras, two pictures; the second says all that a `render` can.
Scene two_pictures() {
  Scene scene = scene_of(red +
                         "define camera eye 45\ndefine camera side 60\ndefine shape sphere ball 0 0 -5 1 red\n"
                         "render eye first.png 32 24\nrender side second.png 48 36\n");
  scene.renders[1].samples = 9;
  scene.renders[1].depth = 2;
  return scene;
}

Job job_of(int picture = 0) {
  Job job;
  job.scene = "s.sdf";
  job.picture = picture;
  return job;
}

/// What resolving throws.
std::pair<ErrorKind, std::string> refusal(Job const& job, Scene const& scene) {
  try {
    resolved(job, scene);
  } catch (Error const& error) {
    return {error.kind(), error.what()};
  }
  FAIL("nothing is wrong");
  return {};
}

}  // namespace

TEST_CASE("what a job leaves open comes from the scene's render", "[unit][job]") {
  Job const first = resolved(job_of(), two_pictures());
  CHECK(first.camera == "eye");
  CHECK(first.size == Resolution{32, 24});
  CHECK(first.region == Region{0, 0, 32, 24});
  CHECK(first.sampling == Sampling{Sampling::Pattern::grid, 1});
  CHECK(first.max_depth == 5);
  Job blurred = job_of();
  blurred.view.aperture = 0.1;
  blurred.view.focus = 5.0;
  CHECK(resolved(blurred, two_pictures()).sampling == Sampling{Sampling::Pattern::seeded, 64});
  Job const second = resolved(job_of(1), two_pictures());
  CHECK(second.camera == "side");
  CHECK(second.size == Resolution{48, 36});
  CHECK(second.sampling == Sampling{Sampling::Pattern::seeded, 9});
  CHECK(second.max_depth == 2);
}

TEST_CASE("paths take more samples and go deeper, unless somebody says otherwise", "[unit][job]") {
  CHECK(resolved(job_of(), two_pictures()).integrator == Integrator::whitted);
  Job job = job_of();
  job.integrator = Integrator::path;
  Job const usual = resolved(job, two_pictures());
  CHECK(usual.integrator == Integrator::path);
  CHECK(usual.sampling == Sampling{Sampling::Pattern::seeded, 64});
  CHECK(usual.max_depth == 64);
  CHECK(request_of(job, two_pictures()).integrator == Integrator::path);
  job.picture = 1;
  CHECK(resolved(job, two_pictures()).sampling == Sampling{Sampling::Pattern::seeded, 9});
  CHECK(resolved(job, two_pictures()).max_depth == 2);
}

TEST_CASE("models whose colours are painted on keep them", "[unit][job]") {
  Scene scene = two_pictures();
  Job job = job_of();
  job.scene = "photographed.glb";
  job.integrator = Integrator::path;
  auto const curve_with = [&](bool first, bool second) {
    PbrModel model;
    model.unlit = first;
    auto const a = std::make_shared<Material>("a", model);
    model.unlit = second;
    auto const b = std::make_shared<Material>("b", model);
    scene.shapes = {};
    scene.shapes.insert(std::make_shared<Sphere>("s", Vec3(0), 1, a));
    scene.shapes.insert(std::make_shared<Sphere>("t", Vec3(0), 1, b));
    return development_of(job, scene).tone_map;
  };
  CHECK(curve_with(true, true) == ToneMap::none);
  CHECK(curve_with(true, false) == ToneMap::neutral);
  CHECK(curve_with(false, false) == ToneMap::neutral);
  job.tone_map = ToneMap::agx;
  CHECK(curve_with(true, true) == ToneMap::agx);
}

TEST_CASE("the integrator is the job's, the render's, or what the scene needs", "[unit][job]") {
  Scene scene = two_pictures();
  auto const choice = [&](Job const& job) {
    IntegratorChoice const chosen = chosen_integrator(job, scene);
    CHECK(resolved(job, scene).integrator == chosen.integrator);
    return std::pair(chosen.integrator, std::string(chosen.reason));
  };
  using Choice = std::pair<Integrator, std::string>;
  CHECK(choice(job_of()) == Choice(Integrator::whitted, "that is the default for scenes"));
  scene.environment = EnvironmentLight{"studio", std::make_shared<EnvironmentMap>(EnvironmentMap{1, 1, {1, 1, 1}})};
  CHECK(choice(job_of()) == Choice(Integrator::path, "only paths show an environment's light"));
  scene.environment.reset();
  scene.lights.insert(Light("lamp", PointLight{.radius = 0.5}));
  CHECK(choice(job_of()) == Choice(Integrator::path, "only paths show a lamp's size"));
  scene.lights = {};
  scene.materials.insert(std::make_shared<Material>("lamp", PhongModel{.emission = Rgb(0, 0, 1)}));
  CHECK(choice(job_of()) == Choice(Integrator::path, "only paths show what an emission lights"));
  scene.materials = {};
  Job on_ground = job_of();
  on_ground.ground = Ground::matt;
  CHECK(choice(on_ground) == Choice(Integrator::path, "only paths show a ground"));
  CHECK(request_of(on_ground, scene).ground == Ground::matt);
  CHECK(asked_integrator(on_ground) == Integrator::path);
  CHECK(!asked_integrator(job_of()));
  on_ground.integrator = Integrator::whitted;
  CHECK(asked_integrator(on_ground) == Integrator::whitted);
  scene.renders[1].integrator = Integrator::whitted;
  CHECK(choice(job_of(1)) == Choice(Integrator::whitted, "the scene's render asks for it"));
  scene.renders[1].integrator = Integrator::path;
  CHECK(choice(job_of(1)) == Choice(Integrator::path, "the scene's render asks for it"));
  CHECK(choice(job_of(0)).first == Integrator::whitted);
  Job job = job_of(1);
  job.integrator = Integrator::whitted;
  CHECK(choice(job) == Choice(Integrator::whitted, "that is asked for"));
  job.integrator.reset();
  job.scene = "model.glb";
  scene.renders.clear();
  job.picture = 0;
  CHECK(choice(job) == Choice(Integrator::path, "that is the default for models"));
  auto const by_reference = [&] { return chosen_integrator(job, scene, DeviceKind::reference); };
  CHECK(by_reference().integrator == Integrator::whitted);
  CHECK(by_reference().reason == "the reference tracer follows paths too slowly");
  job.integrator = Integrator::path;
  CHECK(by_reference().integrator == Integrator::path);
  job.integrator.reset();
  job.scene = job_of().scene;
  scene.environment = EnvironmentLight{"1 1 1", uniform_environment(1, 1, 1)};
  CHECK(by_reference().integrator == Integrator::path);  // whitted would show it black
}

TEST_CASE("a limit of noise takes up to 4096 random samples", "[unit][job]") {
  Job job = job_of();
  job.noise = 0.05;
  CHECK(resolved(job, two_pictures()).sampling == Sampling{Sampling::Pattern::seeded, 4096});
  job.picture = 1;
  std::string const too_few =
      "--noise: --samples is the most to take, and must be above 16 and no grid, such as --samples 4096";
  CHECK(refusal(job, two_pictures()).second == too_few);  // the render's 9
  job.sampling = Sampling{Sampling::Pattern::grid, 64};
  CHECK(refusal(job, two_pictures()).second == too_few);
  job.planes = {FilmPlane::albedo};
  CHECK(!resolved(job, two_pictures()).noise);
  CHECK(resolved(job, two_pictures()).sampling == job.sampling);
  job.planes = {FilmPlane::radiance};
  job.sampling = Sampling{Sampling::Pattern::seeded, 17};
  CHECK(resolved(job, two_pictures()).noise == 0.05);
  job.sampling.reset();
  job.picture = 0;
  CHECK(view_of(job, two_pictures()).sampling == Sampling());
  job.samples = SampleRange{0, 4};
  CHECK(refusal(job, two_pictures()).second == "--noise: it takes all samples, not a range of them");
}

TEST_CASE("an environment is seen unless the scene has another background, or it is the studio", "[unit][job]") {
  Scene scene = two_pictures();
  auto const shown = [&](Job const& job) { return request_of(job, scene).background; };
  scene.environment = EnvironmentLight{"1 1 1", uniform_environment(1, 1, 1)};
  CHECK(shown(job_of()) == Background::environment());
  Job job = job_of();
  job.integrator = Integrator::whitted;
  CHECK(!shown(job));
  scene.background = Rgb(0, 0, 1);
  CHECK(!shown(job_of()));
  job = job_of();
  job.reading.environment.source = "sky.hdr";  // which the command line asks for
  CHECK(shown(job) == Background::environment());
  scene.background = Rgb(0);
  scene.environment->source = "studio";
  CHECK(!shown(job_of()));
}

TEST_CASE("what a job says wins over the scene", "[unit][job]") {
  Job job = job_of(1);
  job.camera = "eye";
  job.size = Resolution{10, 8};
  job.region = Region{1, 2, 3, 4};
  job.integrator = Integrator::path;
  job.sampling = Sampling{Sampling::Pattern::grid, 4};
  job.max_depth = 0;
  job.denoising = Denoising::builtin;
  CHECK(resolved(job, two_pictures()) == job);
  RenderRequest const request = request_of(job, two_pictures());
  CHECK(request.camera.name() == "eye");
  CHECK(request.resolution == *job.size);
  CHECK(request.region == *job.region);
  CHECK(request.sampling == *job.sampling);
  CHECK(request.max_depth == 0);
}

TEST_CASE("a size comes from the job, the render, the camera, the scene, or is 640x480", "[unit][job]") {
  Scene scene = two_pictures();
  scene.cameras = {};
  scene.cameras.insert(Camera("eye", 45, {}, Resolution{7, 5}));
  scene.resolution = Resolution{6, 4};
  Job job = job_of();
  job.size = Resolution{9, 9};
  CHECK(resolved(job, scene).size == Resolution{9, 9});
  job.size.reset();
  CHECK(resolved(job, scene).size == Resolution{32, 24});
  scene.renders.clear();
  CHECK(resolved(job, scene).size == Resolution{7, 5});
  scene.cameras = {};
  scene.cameras.insert(Camera("eye", 45));
  CHECK(resolved(job, scene).size == Resolution{6, 4});
  scene.resolution.reset();
  CHECK(resolved(job, scene).size == Resolution{640, 480});
}

TEST_CASE("a decided job stays as it is, and asks for the same", "[unit][job]") {
  for (int picture : {0, 1}) {
    Job job = job_of(picture);
    job.camera = "1";  // by its number
    Job const decided = resolved(job, two_pictures());
    CHECK(decided.camera == "side");
    CHECK(resolved(decided, two_pictures()) == decided);
  }
}

TEST_CASE("a camera of which nothing is said is the first", "[unit][job]") {
  Scene const scene = scene_of(red + "define camera one 45\ndefine camera two 45\n");
  CHECK(resolved(job_of(), scene).camera == "one");
}

TEST_CASE("what a job cannot have", "[unit][job]") {
  auto const expect = [](auto change, std::string const& what) {
    Job job = job_of();
    change(job);
    auto const [kind, message] = refusal(job, two_pictures());
    INFO(message);
    CHECK(kind == ErrorKind::usage);
    CHECK(message.find(what) != std::string::npos);
  };
  expect([](Job& job) { job.camera = "nose"; }, "s.sdf: there is no camera 'nose'; there are: 0 eye, 1 side");
  expect([](Job& job) { job.camera = "2"; }, "there is no camera '2'");
  expect([](Job& job) { job.picture = 2; }, "s.sdf: there is no picture 2: the scene has 2, counted from 0");
  expect([](Job& job) { job.picture = -1; }, "there is no picture -1");
  expect([](Job& job) { job.region = Region{30, 0, 3, 5}; }, "does not lie in the picture of 32x24");
  expect([](Job& job) { job.samples = SampleRange{0, 16}; }, "are not among the 1 of each pixel");
  expect([](Job& job) { job.planes = {}; }, "no plane");
  expect([](Job& job) { job.background = JobBackground{Background::environment()}; }, "only with an environment");
  expect([](Job& job) { job.sampling = Sampling{Sampling::Pattern::grid, 5}; }, "not square");
  expect([](Job& job) { job.noise = 2; }, "--noise");
  expect([](Job& job) { job.noise = 0; }, "--noise");
  expect([](Job& job) { job.exposure_ev = std::numeric_limits<double>::quiet_NaN(); }, "--exposure");
  expect([](Job& job) { job.exposure_ev = -101; }, "--exposure: expected stops from -100 to 100");
  expect([](Job& job) { job.turn_degrees = std::numeric_limits<double>::infinity(); }, "turn_degrees");
}

TEST_CASE("what a scene lacks is the scene's fault", "[unit][job]") {
  CHECK(refusal(job_of(), Scene()).first == ErrorKind::scene);
  Scene scene = two_pictures();
  scene.renders[0].camera = "nose";
  CHECK(refusal(job_of(), scene).first == ErrorKind::scene);
}

TEST_CASE("a transparent background needs alpha, but without radiance", "[unit][job]") {
  Job job = job_of();
  CHECK(request_of(job, two_pictures()).planes == PlaneSet{FilmPlane::radiance});
  job.background = JobBackground{Rgb(0.5)};
  CHECK(request_of(job, two_pictures()).planes == PlaneSet{FilmPlane::radiance});
  CHECK(request_of(job, two_pictures()).background == Rgb(0.5));
  job.background = JobBackground{};
  CHECK(request_of(job, two_pictures()).planes == PlaneSet{FilmPlane::radiance, FilmPlane::alpha});
  CHECK(!request_of(job, two_pictures()).background);
  job.planes = {FilmPlane::depth};
  CHECK(request_of(job, two_pictures()).planes == PlaneSet{FilmPlane::depth});
}

TEST_CASE("a turned job looks from where the orbit leads", "[unit][job]") {
  Scene const scene = two_pictures();
  Camera const& eye = *scene.cameras.find("eye");
  auto const pose = [&](Job const& job) { return request_of(job, scene).camera.world_from_camera().matrix(); };
  Job job = job_of();
  CHECK(pose(job) == eye.world_from_camera().matrix());
  job.turn_degrees = 90;
  Camera const wanted = orbited(eye, center_of_interest(scene, "", eye), 90);
  CHECK(pose(job) == wanted.world_from_camera().matrix());
  CHECK(request_of(job, scene, Vec3(1, 2, 3)).camera.world_from_camera().matrix() ==
        orbited(eye, Vec3(1, 2, 3), 90).world_from_camera().matrix());
  job.root = "nothing";
  CHECK_THROWS_AS(pose(job), Error);
}

TEST_CASE("noise is taken out where there is some, or where that is asked for", "[unit][job]") {
  CHECK(decided(Denoising::automatic, Integrator::whitted) == Denoising::off);
  CHECK(decided(Denoising::automatic, Integrator(1)) == Denoising::on);
  for (Denoising const asked : {Denoising::on, Denoising::off, Denoising::builtin}) {
    CHECK(decided(asked, Integrator::whitted) == asked);
  }
  Scene const scene = two_pictures();
  PlaneSet const guided{FilmPlane::radiance, FilmPlane::albedo, FilmPlane::normal};
  Job job = job_of();
  CHECK(resolved(job, scene).denoising == Denoising::off);
  CHECK(request_of(job, scene).planes == PlaneSet{FilmPlane::radiance});
  for (Denoising const asked : {Denoising::on, Denoising::builtin}) {
    job.denoising = asked;
    CHECK(resolved(job, scene).denoising == asked);
    CHECK(request_of(job, scene).planes == guided);
    CHECK(shown_planes(job) == PlaneSet{FilmPlane::radiance});
    CHECK(view_of(job, scene).planes == PlaneSet{FilmPlane::radiance});
  }
  job.planes = {FilmPlane::depth};
  CHECK(traced_planes(job) == PlaneSet{FilmPlane::depth});
}

TEST_CASE("a view is a whole picture of radiance", "[unit][job]") {
  Job job = job_of(1);
  job.region = Region{1, 2, 3, 4};
  job.planes = {FilmPlane::depth, FilmPlane::normal};
  job.background = JobBackground{};
  RenderRequest request = view_of(job, two_pictures());
  CHECK(request.camera.name() == "side");
  CHECK(request.region == Region{0, 0, 48, 36});
  CHECK(request.sampling == Sampling());
  CHECK(request.planes == PlaneSet{FilmPlane::radiance});
  CHECK(request.background == Rgb(0));
  job.sampling = Sampling{Sampling::Pattern::seeded, 64};
  CHECK(view_of(job, two_pictures()).sampling == *job.sampling);
}

TEST_CASE("models are neutral where light bounces, and scenes as they say", "[unit][job]") {
  Scene scene = two_pictures();
  scene.tone_map = ToneMap::reinhard;
  Job job = job_of();
  job.integrator = Integrator::path;
  CHECK(development_of(job, scene).tone_map == ToneMap::reinhard);
  job.scene = "chess.glb";
  CHECK(development_of(job, scene).tone_map == ToneMap::neutral);
  job.tone_map = ToneMap::aces;
  CHECK(development_of(job, scene).tone_map == ToneMap::aces);
  job.tone_map = ToneMap::automatic;
  job.integrator = Integrator::whitted;
  CHECK(development_of(job, scene).tone_map == ToneMap::reinhard);
}

TEST_CASE("scenes are neutral and sRGB in an environment that was asked for, unless they have a curve", "[unit][job]") {
  Scene scene = two_pictures();
  Job job = job_of();
  job.integrator = Integrator::path;
  CHECK(development_of(job, scene).tone_map == ToneMap::none);
  CHECK(development_of(job, scene).transfer == Transfer::linear);
  for (std::string const source : {"studio", "sky.hdr"}) {
    INFO(source);
    job.reading.environment.source = source;
    CHECK(development_of(job, scene).tone_map == ToneMap::neutral);
    CHECK(development_of(job, scene).transfer == Transfer::srgb);
  }
  job.tone_map = ToneMap::agx;
  CHECK(development_of(job, scene).transfer == Transfer::srgb);
  job.transfer = Transfer::linear;
  CHECK(development_of(job, scene).transfer == Transfer::linear);
  job.transfer.reset();
  job.tone_map = ToneMap::automatic;
  auto const is_as_ever = [&](ToneMap tone_map) {
    Development const development = development_of(job, scene);
    return development.tone_map == tone_map && development.transfer == Transfer::linear;
  };
  scene.tone_map = ToneMap::reinhard;
  CHECK(is_as_ever(ToneMap::reinhard));
  scene.tone_map = ToneMap::none;
  job.integrator = Integrator::whitted;  // which shows no environment
  CHECK(is_as_ever(ToneMap::none));
  job.integrator = Integrator::path;
  job.reading.environment.source = "none";
  CHECK(is_as_ever(ToneMap::none));
}

TEST_CASE("how a job is developed", "[unit][job]") {
  Scene scene = two_pictures();
  scene.tone_map = ToneMap::reinhard;
  Job job = job_of();
  job.exposure_ev = 1.5;
  CHECK(development_of(job, scene).exposure_ev == 1.5);
  CHECK(development_of(job, scene).tone_map == ToneMap::reinhard);
  CHECK(development_of(job, scene).transfer == Transfer::linear);
  job.scene = "chess.GLB";
  CHECK(development_of(job, scene).transfer == Transfer::srgb);
  job.text = "define camera eye 45";  // only called like a model
  CHECK(development_of(job, scene).transfer == Transfer::linear);
  job.transfer = Transfer::srgb;
  job.tone_map = ToneMap::none;
  CHECK(development_of(job, scene).transfer == Transfer::srgb);
  CHECK(development_of(job, scene).tone_map == ToneMap::none);
}
