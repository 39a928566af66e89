#pragma once

#include <fmt/format.h>

#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "reference.hpp"
#include "shared/bsdf_fields.h"
#include "shared/sobol.h"
#include "support/opencl_probe.hpp"

/// Surfaces for tests of kernels/bsdf, and its functions as probes.
namespace lichtraum::test {

inline constexpr double pi = 3.14159265358979;

/// The device's struct of that name.
struct BsdfParameters {
#define BSDF_COLOR(name) float name[3];
#define BSDF_NUMBER(name) float name;
  BSDF_FIELDS(BSDF_COLOR, BSDF_NUMBER)
#undef BSDF_COLOR
#undef BSDF_NUMBER
};

inline void set_color(float (&color)[3], double value) { color[0] = color[1] = color[2] = float(value); }

/// Black, and as smooth as can be.
inline BsdfParameters black_bsdf() {
  BsdfParameters out{};
  out.opacity = out.stretch = out.ior = out.coat_alpha = out.sheen_alpha = out.film_ior = 1;
  out.alpha = 0.001f;
  set_color(out.attenuation_color, 1);
  return out;
}

/// Lobes that know nothing of each other; the colours' channels differ.
inline BsdfParameters phong_bsdf(double kd, double ks, double alpha, double mirror = 0, double glass = 0,
                                 double ior = 1) {
  BsdfParameters out = black_bsdf();
  for (int c = 0; c < 3; ++c) {
    out.diffuse[c] = float((1 - mirror - glass) * kd * (1 - 0.3 * c));
    out.f0[c] = out.f90[c] = float(ks * (1 - 0.2 * c));
  }
  out.alpha = float(alpha);
  out.mirror = float(mirror);
  out.glass = float(glass);
  out.ior = float(ior);
  return out;
}

/// glTF's material, of one colour, index 1.5.
inline BsdfParameters layered_bsdf(double color, double metallic, double roughness) {
  BsdfParameters out = black_bsdf();
  set_color(out.diffuse, color * (1 - metallic));
  set_color(out.f0, 0.04);
  set_color(out.f90, 1);
  set_color(out.metal, color);
  out.metallic = float(metallic);
  out.alpha = std::max(float(roughness * roughness), 0.001f);
  out.is_layered = 1;
  return out;
}
inline BsdfParameters coated(BsdfParameters out, double share, double roughness) {
  out.coat = float(share);
  out.coat_alpha = std::max(float(roughness * roughness), 0.001f);
  return out;
}
/// Microfacets of the same roughness along y, and rougher along x: KHR_materials_anisotropy.
inline BsdfParameters stretched(BsdfParameters out, double strength) {
  double const along_y = out.alpha, along_x = along_y + strength * strength * (1 - along_y);
  out.alpha = float(std::sqrt(along_x * along_y));
  out.stretch = float(std::sqrt(along_x / along_y));
  return out;
}
/// Cloth of a colour, whose channels differ where `is_colored`.
inline BsdfParameters with_sheen(BsdfParameters out, double color, double roughness, bool is_colored = false) {
  for (int c = 0; c < 3; ++c) out.sheen[c] = float(color * (is_colored ? 1 - 0.4 * c : 1));
  out.sheen_alpha = std::max(float(roughness * roughness), 0.0049f);
  return out;
}
/// Under a thin film, whose thickness is in nm: KHR_materials_iridescence.
inline BsdfParameters iridescent(BsdfParameters out, double share, double ior, double thickness) {
  out.film = float(share);
  out.film_ior = float(ior);
  out.film_thickness = float(thickness);
  return out;
}
/// Lets `share` through of what was diffuse; a solid where `ior` is not 1.
inline BsdfParameters transmitting(BsdfParameters out, double share, double ior = 1) {
  for (int c = 0; c < 3; ++c) {
    out.transmitted[c] = float(share) * out.diffuse[c];
    out.diffuse[c] *= float(1 - share);
    if (ior != 1) out.f0[c] = float(std::pow((ior - 1) / (ior + 1), 2));
  }
  out.ior = float(ior);
  return out;
}

/// KHR_materials_specular's factor.
inline BsdfParameters with_specular(BsdfParameters out, double factor) {
  for (int c = 0; c < 3; ++c) {
    out.f0[c] *= float(factor);
    out.f90[c] *= float(factor);
  }
  return out;
}

/// Lets `share` through of what was diffuse, to all directions: KHR_materials_diffuse_transmission.
inline BsdfParameters translucent(BsdfParameters out, double share) {
  for (int c = 0; c < 3; ++c) {
    out.translucent[c] = float(share * (1 - 0.2 * c)) * out.diffuse[c];
    out.diffuse[c] *= float(1 - share);
  }
  return out;
}

struct BsdfCase {
  std::string name;
  BsdfParameters parameters;
  bool from_outside = true;
  Vec3 coat_normal{0, 0, 1};
  Vec3 smooth_normal{0, 0, 1};
};

/// For tests that take their time, and for those of every day.
inline std::vector<double> const all_roughnesses{0.25, 0.35, 0.45, 0.6, 0.8, 1.0};
inline std::vector<double> const some_roughnesses{0.35, 0.8};

/// One of each kind of lobe and of their mixtures, each glossy one at these roughnesses.
inline std::vector<BsdfCase> bsdf_cases(std::vector<double> const& roughnesses = all_roughnesses) {
  std::vector<BsdfCase> cases{
      {"matt", phong_bsdf(0.8, 0, 1)},
      {"matt and glossy", phong_bsdf(0.5, 0.5, 1)},
      {"glossy", phong_bsdf(0, 1, 0.5)},
      {"glossy mirror", phong_bsdf(0.3, 0.6, 0.3, 0.1)},
      {"glossy glass", phong_bsdf(0.4, 0.3, 0.1, 0.2, 0.3, 1.5)},
      {"glossy glass from within", phong_bsdf(0.4, 0.3, 0.1, 0.2, 0.3, 1.5), false},
  };
  Vec3 const tilted = glm::normalize(Vec3(0.3, -0.2, 1));
  cases.push_back({"bumpy and matt", phong_bsdf(0.8, 0, 1), true, {0, 0, 1}, tilted});
  cases.push_back({"bumpy leaf under sheen",
                   with_sheen(translucent(layered_bsdf(0.8, 0, 0.6), 0.6), 0.7, 0.5),
                   true,
                   {0, 0, 1},
                   tilted});
  for (double const roughness : roughnesses) {
    auto const add = [&](std::string const& name, BsdfParameters const& parameters, bool from_outside = true,
                         Vec3 const& coat_normal = Vec3(0, 0, 1)) {
      cases.push_back({fmt::format("{}, roughness {}", name, roughness), parameters, from_outside, coat_normal});
    };
    add("dielectric", layered_bsdf(0.7, 0, roughness));
    add("metal", layered_bsdf(0.9, 1, roughness));
    add("half metal", layered_bsdf(0.6, 0.5, roughness));
    add("coated dielectric", coated(layered_bsdf(0.7, 0, 0.6), 1, roughness));
    add("dielectric under a tilted coat", coated(layered_bsdf(0.7, 0, 0.6), 1, roughness), true, tilted);
    add("half coated metal", coated(layered_bsdf(0.8, 1, roughness), 0.5, 0.3));
    add("sheen", with_sheen(layered_bsdf(0, 0, 1), 1, roughness, true));
    add("sheen over matt cloth, coated", coated(with_sheen(layered_bsdf(0.5, 0, 0.9), 0.8, roughness), 0.5, 0.4));
    add("stretched metal", stretched(layered_bsdf(0.9, 1, roughness), 0.6));
    add("coated, stretched thin wall",
        coated(stretched(transmitting(layered_bsdf(0.9, 0, 0.45), 0.8), roughness), 0.5, 0.4));
    add("stretched solid", stretched(transmitting(layered_bsdf(1, 0, 0.45), 1, 1.5), roughness));
    add("thin wall", transmitting(layered_bsdf(0.9, 0, roughness), 0.8));
    add("leaf", translucent(layered_bsdf(0.8, 0, roughness), 0.6));
    add("translucent, stained solid under sheen",
        with_sheen(translucent(transmitting(layered_bsdf(0.9, 0, roughness), 0.5, 1.4), 0.5), 0.5, 0.5));
    add("solid", transmitting(layered_bsdf(1, 0, roughness), 1, 1.5));
    add("solid from within", transmitting(layered_bsdf(1, 0, roughness), 1, 1.5), false);
    add("solid with specular 0.3", with_specular(transmitting(layered_bsdf(0.9, 0, roughness), 1, 1.5), 0.3));
    add("coated, half matt solid", coated(transmitting(layered_bsdf(0.9, 0.2, roughness), 0.5, 1.3), 0.5, 0.4));
  }
  return cases;
}

inline Vec3 direction_at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// In a plane that is none of the axes'.
inline Vec3 viewer_at(double degrees) {
  double const angle = glm::radians(degrees);
  return {0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle)};
}
inline constexpr std::array<double, 5> viewer_angles_degrees{0, 30, 60, 80, 88};

/// kernels/bsdf for one lane or sixteen, which give the same to the last bit.
class BsdfProbe {
 public:
  explicit BsdfProbe(std::size_t lanes = 1)
      : lanes_(lanes), program_("bsdf.cl", lanes == 1 ? "-D LANES=1" : "-D LANES=16 -D LAYOUT_WIDE") {}

  /// f |wi.z|, and the density as w.
  std::vector<float4> evaluate(BsdfCase const& surface, std::vector<float4> const& viewers,
                               std::vector<float4> const& lights) const {
    std::vector<float4> values;
    run("probe_evaluate", surface, viewers, &lights, {&values});
    return values;
  }

  struct Samples {
    std::vector<float4> directions;  ///< w: the density; 0: lost, or mirrored and refracted sharply
    std::vector<float4> weights;
  };
  /// `uniforms`: which lobe, u, v.
  Samples sample(BsdfCase const& surface, std::vector<float4> const& viewers,
                 std::vector<float4> const& uniforms) const {
    Samples samples;
    run("probe_sample", surface, viewers, &uniforms, {&samples.directions, &samples.weights});
    return samples;
  }

  /// The probabilities of the lobes.
  struct Choices {
    double coat, glossy, diffuse, transmitted, mirror, glass, sheen, translucent;
    double delta() const { return mirror + glass; }
    double sum() const { return coat + sheen + glossy + diffuse + translucent + transmitted + delta(); }
  };
  /// One for each viewer.
  std::vector<Choices> choices(BsdfCase const& surface, std::vector<float4> const& viewers) const {
    std::vector<float4> spread, delta;
    run("probe_choices", surface, viewers, nullptr, {&spread, &delta});
    std::vector<Choices> choices;
    for (std::size_t i = 0; i < viewers.size(); ++i) {
      choices.push_back(
          {spread[i].x, spread[i].y, spread[i].z, spread[i].w, delta[i].x, delta[i].y, delta[i].z, delta[i].w});
    }
    return choices;
  }

 private:
  /// A work-item has as many viewers as there are lanes: the last is repeated until there are enough for all.
  void run(char const* kernel, BsdfCase const& surface, std::vector<float4> const& viewers,
           std::vector<float4> const* others, std::vector<std::vector<float4>*> const& results) const {
    std::size_t const count = viewers.size(), items = (count + lanes_ - 1) / lanes_;
    if (items * lanes_ != count) {
      auto const padded = [&](std::vector<float4> some) {
        some.resize(items * lanes_, some.back());
        return some;
      };
      std::vector<float4> const more = others != nullptr ? padded(*others) : std::vector<float4>{};
      run(kernel, surface, padded(viewers), others != nullptr ? &more : nullptr, results);
      for (std::vector<float4>* result : results) result->resize(count);
      return;
    }
    std::vector<BsdfParameters> const parameters{surface.parameters};
    std::vector<ProbeArgument> arguments{in(parameters), value(device::uint(surface.from_outside)),
                                         value(to_float4(surface.smooth_normal)), value(to_float4(surface.coat_normal)),
                                         in(viewers)};
    if (others != nullptr) arguments.push_back(in(*others));
    for (std::vector<float4>* result : results) {
      result->resize(count);
      arguments.push_back(out(*result));
    }
    program_.run(kernel, items, arguments);
  }

  std::size_t lanes_;
  ProbeProgram program_;
};

inline std::vector<float4> random_uniforms(Random& random, std::size_t count) {
  std::vector<float4> uniforms(count);
  auto const number = [&] { return float(random.index(1 << 24)) * 0x1p-24f; };
  for (float4& u : uniforms) {
    u.x = number();
    u.y = number();
    u.z = number();
  }
  return uniforms;
}

/// Points of the unit cube that fill it evenly, for means: Hammersley's with Sobol's first two dimensions. `count`: a
/// power of two.
inline std::vector<float4> even_uniforms(std::size_t count) {
  std::vector<float4> uniforms(count);
  for (device::uint i = 0; i < count; ++i) {
    uniforms[i] = {(float(i) + 0.5f) / float(count), device::unit_real(device::reverse_bits(i)),
                   device::unit_real(device::reverse_bits(device::sobol_second_reversed(i))), 0};
  }
  return uniforms;
}

}  // namespace lichtraum::test
