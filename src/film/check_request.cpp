#include "film/check_request.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

void require(bool holds, std::string const& message) {
  if (!holds) throw Error(ErrorKind::usage, message);
}

}  // namespace

void check_request(RenderRequest const& request) {
  auto const [width, height] = request.resolution;
  require(width > 0 && height > 0, fmt::format("a picture of {}x{} has no pixels", width, height));

  Region const& r = request.region;
  bool const is_inside =
      r.x >= 0 && r.y >= 0 && r.width > 0 && r.height > 0 && r.x <= width - r.width && r.y <= height - r.height;
  require(is_inside, fmt::format("the region {},{},{},{} does not lie in the picture of {}x{}", r.x, r.y, r.width,
                                 r.height, width, height));

  int const count = request.sampling.count;
  require(count > 0, fmt::format("{} samples per pixel: at least 1 is needed", count));
  if (request.sampling.pattern == Sampling::Pattern::grid) {
    auto const side = int(std::lround(std::sqrt(double(count))));
    require(std::int64_t(side) * side == count, fmt::format("a grid of {} samples is not square", count));
  }
  if (request.samples) {
    auto const [first, end] = *request.samples;
    require(first >= 0 && first < end && end <= count,
            fmt::format("samples {} to {} are not among the {} of each pixel", first, end - 1, count));
    require(first % Film::block_size == 0,
            fmt::format("a range of samples begins at a multiple of {}, not at {}", Film::block_size, first));
  }
  require(!request.planes.is_empty(), "no plane is asked for");
  bool const needs_environment = request.background && request.background->kind == Background::Kind::environment;
  require(!needs_environment || request.integrator != Integrator::whitted,
          "--background environment: it can be seen only with an environment, and whitted draws none");
  require(request.max_indirect > 0, fmt::format("a limit of indirect light of {} leaves none", request.max_indirect));
  require(request.ground == Ground::none || request.integrator != Integrator::whitted,
          "--ground: whitted draws none; --integrator path does");
  require(request.ground == Ground::none || request.max_depth > 0,
          "--ground: with a depth of 0 there are no shadows of light from all around; it takes 1 or more");
  require(
      request.ground != Ground::glossy || !request.planes.has(FilmPlane::alpha),
      "--ground=glossy: what it mirrors would be lost where the picture is transparent; --ground alone keeps shadows");
  require(request.max_depth >= 0, fmt::format("a depth of {} is negative", request.max_depth));
}

}  // namespace lichtraum
