#include "app/render_statistics.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/report_json.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::app {
namespace {

using Json = nlohmann::ordered_json;

/// Nothing where a limit of noise decided how many, once before.
Json samples_json(PictureReport const& report) {
  if (!report.is_skipped) return report.samples;
  return report.plan.job.noise ? Json() : Json(report.plan.job.sampling->count);
}

Json picture_json(PictureReport const& report) {
  RayCounts const& rays = report.render.rays;
  Job const& job = report.plan.job;
  Region const& region = *job.region;
  return {{"output", report.written_to.empty() ? Json() : Json(report.written_to)},
          {"complete", report.is_complete},
          {"skipped", report.is_skipped},
          {"format", report.plan.output.is_film ? "film" : report.plan.output.format->name},
          {"time_seconds", job.reading.model.time_seconds ? Json(*job.reading.model.time_seconds) : Json()},
          {"turn_degrees", job.turn_degrees ? Json(*job.turn_degrees) : Json()},
          {"camera", job.camera},
          {"width", job.size->width},
          {"height", job.size->height},
          {"region", {region.x, region.y, region.width, region.height}},
          {"integrator", find_word<Integrator>(integrator_words, *job.integrator)},
          {"integrator_reason", report.plan.integrator_reason},
          {"samples", samples_json(report)},
          {"noise", report.noise ? Json(*report.noise) : Json()},
          {"depth", *job.max_depth},
          {"triangles", report.scene.triangles},
          {"spheres", report.scene.spheres},
          {"boxes", report.scene.boxes},
          {"instances", report.scene.instances},
          {"bvh_nodes", report.scene.bvh_nodes},
          {"device_bytes", report.scene.device_bytes},
          {"load_ms", report.load_ms},
          {"flatten_ms", report.scene.flatten_ms},
          {"build_ms", report.scene.build_ms},
          {"upload_ms", report.scene.upload_ms},
          {"program_ms", report.render.program_ms},
          {"trace_ms", report.render.trace_ms},
          {"denoiser", report.denoiser.empty() ? Json() : Json(report.denoiser)},
          {"denoise_ms", report.denoise_ms},
          {"write_ms", report.write_ms},
          {"rays",
           {{"camera", rays.camera},
            {"camera_hits", rays.camera_hits},
            {"shadow", rays.shadow},
            {"secondary", rays.secondary},
            {"total", rays.total()}}},
          {"mrays_per_second", report.mrays_per_second()}};
}

}  // namespace

std::string to_json(RunReport const& report) {
  Json scenes = Json::array();
  for (SceneReport const& scene : report.scenes) {
    Json pictures = Json::array();
    for (PictureReport const& picture : scene.pictures) pictures.push_back(picture_json(picture));
    scenes.push_back({{"file", scene.file},
                      {"load_ms", scene.load_ms},
                      {"pictures", pictures},
                      {"diagnostics", json_of(scene.diagnostics)},
                      {"error", scene.error.empty() ? Json() : Json(scene.error)},
                      {"exit_status", scene.exit_code}});
  }
  return printed({{"lichtraum", LICHTRAUM_VERSION},
                  {"device", json_of(report.device)},
                  {"scenes", scenes},
                  {"film", report.film.empty() ? Json() : Json(report.film)},
                  {"total_ms", report.total_ms}});
}

std::string summary(PictureReport const& report) {
  std::string const denoising =
      report.denoiser.empty() ? "" : fmt::format(", denoised in {:.1f} ms", report.denoise_ms);
  // Units were traced elsewhere.
  std::string const tracing =
      report.render.trace_ms > 0
          ? fmt::format(", {:.1f} ms, {:.1f} Mrays/s", report.render.trace_ms, report.mrays_per_second())
          : "";
  return fmt::format("{}: {}x{}{}{}", report.written_to, report.plan.job.region->width, report.plan.job.region->height,
                     tracing, denoising);
}

std::string details(PictureReport const& report) {
  SceneStatistics const& s = report.scene;
  RayCounts const& rays = report.render.rays;
  std::string const noise =
      report.noise ? fmt::format("\n  noise {:.2g} after {} samples", *report.noise, report.samples) : "";
  char const* const secondary = report.plan.job.integrator == Integrator::path ? "scattered" : "mirror and glass";
  std::string const denoiser = report.denoiser.empty() ? "" : fmt::format("\n  denoised by {}", report.denoiser);
  return fmt::format(
      "  drawn by {}, as {}\n"
      "  scene: {} triangles, {} spheres, {} boxes, {} instances, {} nodes, {} bytes on the device\n"
      "  flatten {:.1f} ms, build {:.1f} ms, upload {:.1f} ms, program {:.1f} ms, trace {:.1f} ms, write {:.1f} ms\n"
      "  rays: {} camera ({} hit something), {} shadow, {} {}{}{}",
      find_word<Integrator>(integrator_words, *report.plan.job.integrator), report.plan.integrator_reason, s.triangles,
      s.spheres, s.boxes, s.instances, s.bvh_nodes, s.device_bytes, s.flatten_ms, s.build_ms, s.upload_ms,
      report.render.program_ms, report.render.trace_ms, report.write_ms, rays.camera, rays.camera_hits, rays.shadow,
      rays.secondary, secondary, noise, denoiser);
}

}  // namespace lichtraum::app
