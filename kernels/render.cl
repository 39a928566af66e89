/* Traces a tile of a picture into a film: one work-item a square of BATCH_SIDE x BATCH_SIDE pixels, at multiples of
 * that from the picture's corner, in a 2D range rounded up to the work-group's size.
 *
 * Samples are added one by one in their order. So a film has the same bytes however pixels and samples are cut into
 * tiles, as long as each pixel's samples are launched in order; a tile has samples of one block (shared/film.h) only.
 *
 * `traced` says how many rays this launch traced: one entry a work-item, row by row. program.clh has what can be chosen
 * when this is compiled. */
#include "camera/generate_rays.clh"
#include "film/film.clh"
#include "integrators/first_surface.clh"
#include "integrators/path.clh"
#include "integrators/whitted.clh"
#include "program.clh"

/* On CPUs a function of its own, as PoCL makes three copies of a kernel's body; a GPU would have to keep the scene in
 * memory for a call. */
#if LANES > 1
#define ONE_COPY NOINLINE
#else
#define ONE_COPY inline
#endif

/* Samples of a square of pixels. */
static ONE_COPY void render_square(Scene const* scene, __global FrameParameters const* frame, Film const* film,
                                   FilmSquare const* square, Tile const* tile, WorkItemRays* counts) {
  if (wants(film, CENTER_PLANES) && tile->first_sample == 0u) {
    RayBatch rays;
    generate_center_rays(frame, tile, square->corner_x, square->corner_y, &rays);
    write_centers(scene, frame, film, square, &rays, counts);
  }
  if (wants(film, MEAN_PLANES)) {
    Samples sums;
    clear_samples(film, &sums);
    if (tile->first_sample % FILM_BLOCK_SIZE != 0u) {
      load_samples(frame, film, square, &sums);
    }
    INTEGRATE(scene, frame, film, square, tile, &sums, counts);
    store_samples(frame, film, square, &sums);
  }
}

__kernel void render_tile(SCENE_PARAMETERS, FILM_PARAMETERS, __global FrameParameters const* frame, Tile const tile,
                          __global WorkItemRays* traced) {
  Scene const scene = SCENE_FROM_PARAMETERS;
  Film const film = FILM_FROM_PARAMETERS;
  Tile const this_tile = tile; /* with an address */
  WorkItemRays counts = {0u, 0u, 0u, 0u};
  uint const column = (uint)get_global_id(0);
  uint const row = (uint)get_global_id(1);
  FilmSquare const square = find_square(&this_tile, column, row);
  uint const work_items_a_row = (tile.x + tile.width + BATCH_SIDE - 1u) / BATCH_SIDE - tile.x / BATCH_SIDE;
  if (is_empty(&square)) {
    return;
  }
  render_square(&scene, frame, &film, &square, &this_tile, &counts);
  traced[(size_t)row * work_items_a_row + column] = counts;
}
