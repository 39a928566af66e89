#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "lichtraum/environment.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/graph_summary.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::fuzz {

/// Reads any bytes as an eSDF scene, and calls draw(scene, request) for a picture of 16x16 pixels of each of its
/// `render` statements, or else of the scene at its end, as long as that is small enough to be drawn at once.
inline void draw_scenes(std::uint8_t const* data, std::size_t size,
                        std::function<void(Scene const&, RenderRequest const&)> const& draw) {
  constexpr std::uint64_t most_primitives = 1000;
  constexpr int most_pictures = 3;
  EsdfOptions options;
  options.keep_going = size % 2 == 0;
  options.find_environment = [](std::string const&) { return uniform_environment(1, 0.5f, 0.25f); };
  try {
    EsdfScript const script = EsdfScript::from_text(std::string(reinterpret_cast<char const*>(data), size), "fuzz.sdf",
                                                    options, "/nonexistent");
    Job job;
    job.size = Resolution{16, 16};
    job.sampling = Sampling{Sampling::Pattern::seeded, 1};
    job.denoising = Denoising::off;
    auto const draw_one = [&](Scene const& scene) {
      if (summarise(scene.roots()).drawn.primitives() > most_primitives) return;
      Job const decided = resolved(job, script.scene());
      RenderRequest request = request_of(decided, scene);
      request.max_depth = std::min(request.max_depth, 4);
      draw(scene, request);
    };
    job.picture = -1;
    script.play([&](Scene const& scene, RenderCommand const&) {
      ++job.picture;
      draw_one(scene);
      return job.picture + 1 < most_pictures;
    });
    if (job.picture < 0) {
      job.picture = 0;
      draw_one(script.scene());
    }
  } catch (Error const&) {  // what a faulty scene must end in; anything else is a finding
  }
}

}  // namespace lichtraum::fuzz
