#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compile/scene_buffers.hpp"
#include "layout_scenes.hpp"
#include "scene_arguments.hpp"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

inline constexpr Traversal all_layouts[] = {Traversal::scalar, Traversal::wide, Traversal::packet};

/// What a ray has met, as in layouts.cl.
struct LayoutHit {
  float t;
  device::uint shape;
  device::uint instance;
  device::uint padding;
};

/// One compiled scene in one layout, and the probes for it.
class LayoutProbe {
 public:
  /// With a stack of what the scene needs, so that Oclgrind sees when that is not enough; or at least of `least_stack`
  /// entries, so that many scenes share a program.
  LayoutProbe(FlatScene scene, Traversal traversal, std::size_t least_stack = 0)
      : scene_(compiled(std::move(scene), traversal.layout, least_stack)),
        packets_(traversal.grouping == RayGrouping::packet),
        program_(program_for(scene_options(scene_, traversal))) {}

  std::vector<LayoutHit> closest(Rays const& rays) const {
    std::vector<LayoutHit> hits(rays.size());
    run(packets_ ? "probe_packet_closest" : "probe_closest", rays, {out(hits)}, packets_ ? packet_size : 1);
    return hits;
  }
  /// Of the same rays, a few in turn.
  std::vector<LayoutHit> closest_in_turn(Rays const& rays) const {
    std::vector<LayoutHit> hits(rays.size());
    run("probe_stream_closest", rays, {out(hits)}, packet_size);
    return hits;
  }
  /// What gets through to t_max, 0..1.
  std::vector<float> visibility(Rays const& rays, float t_max) const {
    std::vector<float> visibility(rays.size());
    run("probe_visibility", rays, {value(t_max), out(visibility)}, 1);
    return visibility;
  }
  std::vector<float> visibility_in_turn(Rays const& rays, float t_max) const {
    std::vector<float> visibility(rays.size());
    run("probe_stream_visibility", rays, {value(t_max), out(visibility)}, packet_size);
    return visibility;
  }
  std::vector<device::uint> hidden(Rays const& rays, float t_max) const {
    std::vector<device::uint> hidden(rays.size());
    run(packets_ ? "probe_packet_hidden" : "probe_hidden", rays, {value(t_max), out(hidden)},
        packets_ ? packet_size : 1);
    return hidden;
  }
  SceneBuffers const& scene() const { return scene_; }

 private:
  static SceneBuffers compiled(FlatScene scene, TreeLayout layout, std::size_t least_stack) {
    SceneBuffers buffers = compile_scene(std::move(scene), {}, layout);
    buffers.stack_size = std::max(buffers.stack_size, least_stack);
    return buffers;
  }
  /// Compiled once, however many scenes need it. Never destroyed: what a driver needs for that is gone by then.
  static ProbeProgram const& program_for(std::string_view wanted) {
    static auto& programs = *new std::map<std::string, ProbeProgram>;
    std::string const options(wanted);
    return programs.try_emplace(options, "layouts.cl", options).first->second;
  }
  void run(std::string const& kernel, Rays const& rays, std::vector<ProbeArgument> const& last,
           std::size_t rays_per_item) const {
    std::vector<ProbeArgument> arguments = scene_arguments(scene_);
    arguments.insert(arguments.end(), {in(rays.origins), in(rays.directions)});
    arguments.insert(arguments.end(), last.begin(), last.end());
    // Small groups: each work-item has much memory of its own.
    program_.run(kernel, rays.size() / rays_per_item, arguments, 1, rays_per_item > 1 ? 1 : 16, 1);
  }

  SceneBuffers scene_;
  bool packets_;
  ProbeProgram const& program_;
};

/// How many of about `count` rays that must meet something meet nothing: where the closest hit is looked for, and where
/// any is. `add_packet` adds some to Rays.
template <class AddPacket>
std::size_t count_misses(LayoutProbe const& probe, std::size_t count, AddPacket const& add_packet) {
  std::size_t misses = 0;
  std::size_t const batch = std::max<std::size_t>(1, std::min<std::size_t>(count, 1 << 18) / packet_size);
  for (std::size_t done = 0; done < count; done += batch * packet_size) {
    Rays rays;
    for (std::size_t i = 0; i < batch; ++i) add_packet(rays);
    for (LayoutHit const& hit : probe.closest(rays)) misses += std::isfinite(hit.t) ? 0 : 1;
    for (device::uint const hidden : probe.hidden(rays, 1e6f)) misses += hidden == 3 ? 0 : 1;
  }
  return misses;
}

}  // namespace lichtraum::test
