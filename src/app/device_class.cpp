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
  for (auto const& integrator : integrator_words) {
    test.request.integrator = integrator.value;
    Film film;
    renderer.render(test.request, film);
    for (auto const& array : film.arrays()) hasher.add_bytes(array.data(), array.size());
  }
  return {hasher.finish().text(), device.kind, device.name};
}

}  // namespace lichtraum::app
