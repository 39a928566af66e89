#pragma once

#include <span>
#include <string>
#include <utility>

#include "lichtraum/renderer.hpp"

namespace lichtraum::test {

/// Two pictures agree where no channel, clamped to 0..1, differs by more than this: one step of eight bits.
inline constexpr double picture_tolerance = 1.0 / 255;

/// How many pixels may differ: silhouettes, where rounding decides what a ray meets.
inline constexpr double differing_share = 0.001;

/// Checks that `actual` agrees with `expected` in all but `allowed_share` of the pixels. When it does not, the failure
/// names the differing pixels, and <name>.actual.png, .expected.png and .difference.png (differences times eight) are
/// left at their artifact_path.
void check_picture(Image const& actual, Image const& expected, std::string const& name,
                   double allowed_share = differing_share);

/// A request for the whole picture.
RenderRequest whole_picture(Camera const& camera, Resolution const& resolution);

/// `scene` on `device`. `traversal` means nothing to the reference renderer.
Image render_on(DeviceInfo const& device, Scene const& scene, RenderRequest const& request,
                std::optional<Traversal> traversal = {}, Development const& development = {});
/// The same before it is developed.
Film film_on(DeviceInfo const& device, Scene const& scene, RenderRequest const& request,
             std::optional<Traversal> traversal = {});

/// The same by the reference renderer.
Image render_reference(Scene const& scene, RenderRequest const& request, Development const& development = {});

/// Every OpenCL device of this machine, found once.
std::vector<DeviceInfo> const& opencl_devices();

/// The layouts of the tree to test on a device, with their names: all on processors, `scalar` on others. These may have
/// the others as well, but their compilers take minutes for sixteen lanes.
std::span<std::pair<char const*, Traversal> const> layouts_of(DeviceInfo const& device);

/// Checks that the reference renderer's picture comes from every OpenCL device, in every layout. `name`: of the
/// pictures that a failure leaves.
void check_layouts(Scene const& scene, RenderRequest const& request, std::string const& name,
                   Development const& development = {});

}  // namespace lichtraum::test

/// Leaves the test with a line SKIPPED where there is no OpenCL device.
#define REQUIRE_OPENCL_DEVICE() \
  if (lichtraum::test::opencl_devices().empty()) SKIP_TEST("no OpenCL device")
