#include "app/device_class.hpp"

#include "app/test_scene.hpp"
#include "core/content_hash.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::app {
namespace {

constexpr Resolution probe_size{64, 48};
constexpr int probe_samples = Film::block_size + 4;  // so that sums of blocks are added, too

PlaneSet all_planes() {
  PlaneSet planes;
  for (std::size_t i = 0; i < plane_count; ++i) planes.add(FilmPlane(i));
  return planes;
}

}  // namespace

farm::DeviceClass device_class_of(Renderer& renderer, std::string const& traversal) {
  DeviceInfo const& device = renderer.device();
  ContentHasher hasher;
  hasher.add(std::string_view(LICHTRAUM_VERSION));
  hasher.add(int(device.kind));  // which decides the default traversal
  hasher.add(std::string_view(traversal));
  TestScene test = make_test_scene();
  renderer.set_scene(test.scene);
  test.request.resolution = probe_size;
  test.request.region = whole_picture(probe_size);
  test.request.sampling = {Sampling::Pattern::seeded, probe_samples};
  test.request.planes = all_planes();
  auto const add_picture = [&] {
    Film film;
    renderer.render(test.request, film);
    for (auto const& array : film.arrays()) hasher.add_bytes(array.data(), array.size());
  };
  for (auto const& integrator : integrator_words) {
    test.request.integrator = integrator.value;
    add_picture();
  }
  // Numbers below the least normal float, 1.2e-38, which some devices take for 0.
  test.request.background = Background(Rgb(1e-38f, 3e-39f, 1e-40f), Rgb(2e-38f, 1e-39f, 1e-42f));
  test.request.planes = {FilmPlane::radiance};  // with alpha it would leave out the background
  add_picture();
  return {hasher.finish().text(), device.kind, device.name};
}

}  // namespace lichtraum::app
