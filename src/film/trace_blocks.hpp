#pragma once

#include <algorithm>

#include "lichtraum/renderer.hpp"

namespace lichtraum {

inline SampleRange wanted_samples(RenderRequest const& request) {
  return request.samples.value_or(SampleRange{0, request.sampling.count});
}

/// Whether tracing can go on with what the film has.
inline bool has_begun(RenderRequest const& request, Film const& film) {
  SampleRange const wanted = wanted_samples(request);
  return !film.is_empty() && film.region() == request.region && film.planes() == request.planes &&
         film.samples().first == wanted.first && film.samples().end <= wanted.end;
}

/// Has what the film lacks traced, block by block. `trace(SampleRange)` adds samples of one block to the film's sums,
/// and returns whether it was not stopped. `film` is one that has_begun, or without samples. Returns whether all is
/// there; else the film is as Renderer::render says.
template <class Trace>
bool trace_blocks(SampleRange const& wanted, Film& film, Trace const& trace) {
  bool const is_new = film.is_empty();
  bool const has_means = film.planes().has(PlaneRule::mean);
  while (film.samples().end < wanted.end) {
    int const first = film.samples().end;
    int const block = first - first % Film::block_size;
    int const end = std::min(wanted.end, block + Film::block_size);
    if (first == block && !film.is_empty()) film.close_block();
    bool const is_traced = first == 0 || has_means;
    if (is_traced && !trace(SampleRange{first, end})) {
      if (block > wanted.first) {
        film.drop_last_block();
      } else if (is_new && first == block) {
        film.set_end(end);
      } else {
        film = Film();
      }
      return false;
    }
    film.set_end(has_means ? end : wanted.end);
  }
  return true;
}

}  // namespace lichtraum
